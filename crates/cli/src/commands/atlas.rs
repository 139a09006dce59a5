//! `stratiform atlas`: where methods break.

use crate::args::AtlasArgs;
use crate::output::{Data, Talk};
use crate::pipeline::optics::cache_folder;
use crate::{CliError, interrupt, pipeline, progress};
use std::path::Path;
use stratiform_artifact::{
    AtlasCount, AtlasDocument, AtlasRow, create_folder, to_csv, write_csv, write_json,
};
use stratiform_chart::atlas::{
    BASE_RADIUS_UM, Cell, Density, Input, Phases, Plane, Sheet, answered_outside, count, document, rows,
    sweep,
};
use stratiform_chart::atlas::{Class, CloudAt};
use stratiform_chart::{ChartError, Watch};
use stratiform_methods::{self as methods, Method, by_name};

type Methods = Vec<Box<dyn Method>>;

/// Photons of tracers where none are given: enough to see what breaks.
const PHOTONS: &str = "1000";

/// What was found.
struct Found {
    document: AtlasDocument,
    rows: Vec<AtlasRow>,
    counts: Vec<AtlasCount>,
    /// Of each method: values of classes that it must not have.
    breaches: Vec<String>,
}

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for unknown methods or files that cannot be written, [`CliError::Failed`] where a contract is broken.
pub fn run(args: &AtlasArgs, talk: Talk) -> Result<Data, CliError> {
    let methods = chosen(&args.methods)?;
    if let Some(out) = &args.out {
        create_folder(out)?;
    }
    let found = measure(args.quick, &methods, talk)?;
    if let Some(out) = &args.out {
        write(out, &found, talk)?;
    }
    if !found.breaches.is_empty() {
        return Err(CliError::Failed(found.breaches.join("\n")));
    }
    if !args.json {
        return Ok(to_csv(&found.counts)?);
    }
    let object = serde_json::json!({ "atlas": found.document, "summary": found.counts, "cells": found.rows });
    Ok(format!("{object:#}\n"))
}

fn write(out: &Path, found: &Found, talk: Talk) -> Result<(), CliError> {
    write_csv(&out.join("atlas.csv"), &found.rows)?;
    write_csv(&out.join("summary.csv"), &found.counts)?;
    write_json(&out.join("atlas.json"), &found.document)?;
    let drawn = stratiform_report::build_atlas(out).map_err(pipeline::input_error)?;
    talk.say(format!("page: {}", drawn.page.display()));
    Ok(())
}

fn chosen(asked: &[String]) -> Result<Methods, CliError> {
    if asked.is_empty() {
        return every();
    }
    if let Some((_, twice)) = asked.iter().enumerate().find(|(i, name)| asked[..*i].contains(name)) {
        return Err(CliError::Input(format!("method {twice} is named twice")));
    }
    asked.iter().map(|name| by_name(name).map_err(pipeline::input_error)).collect()
}

/// All methods, tracers with fewer photons than usual.
fn every() -> Result<Methods, CliError> {
    let named = |method: Box<dyn Method>| {
        let stem = method.card().name.split(':').next().unwrap_or_default().to_owned();
        let is_tracer = methods::knobs(&stem).is_some_and(|knob| knob.counts == "photons");
        if is_tracer {
            by_name(&format!("{stem}:{PHOTONS}")).map_err(pipeline::input_error)
        } else {
            Ok(method)
        }
    };
    methods::all().into_iter().map(named).collect()
}

fn measure(quick: bool, methods: &Methods, talk: Talk) -> Result<Found, CliError> {
    let density = if quick { Density::Thin } else { Density::Full };
    let bar = progress::bar((Plane::ALL.len() * (1 + methods.len())) as u64, "atlas", talk.quiet);
    let interrupted = interrupt::watch();
    let watch = Watch { progress: &|| bar.inc(1), cancel: interrupted.flag() };
    let cache = cache_folder();
    let radii = if quick { vec![BASE_RADIUS_UM] } else { Input::EffectiveRadius.values().to_vec() };
    let phases = Phases::of_radii(&radii, cache.as_deref()).map_err(fault)?;
    let sheet = |plane: &Plane| watch.over(|| Sheet::new(*plane, density, &phases, cache.as_deref()));
    let sheets = Plane::ALL.iter().map(sheet).collect::<Result<Vec<_>, _>>().map_err(fault)?;
    let thin: Vec<Sheet> = sheets.iter().map(Sheet::thin).collect();
    let traceable: Vec<Sheet> = thin.iter().map(Sheet::traceable).collect();
    let cards: Vec<_> = methods.iter().map(|method| method.card()).collect();
    let document = document(&cards, density);
    let mut found = Found { document, rows: Vec::new(), counts: Vec::new(), breaches: Vec::new() };
    for method in methods {
        let sheets = match method.card() {
            card if card.table_bytes.is_some() => &sheets,
            card if card.class == methods::Class::PathTracing => &traceable,
            _ => &thin,
        };
        found.add(&**method, sheets, watch)?;
        found.outside(&**method, &phases);
    }
    bar.finish_and_clear();
    Ok(found)
}

impl Found {
    fn add(&mut self, method: &dyn Method, sheets: &[Sheet], watch: Watch<'_>) -> Result<(), CliError> {
        let mut all = Vec::new();
        for sheet in sheets {
            let cells = watch.over(|| Ok(sweep(method, sheet))).map_err(fault)?;
            self.rows.extend(rows(method.card(), sheet.plane, &cells));
            all.extend(cells);
        }
        self.counts.extend(count(method.card(), &all));
        self.breaches.extend(breaches(&method.card().name, &all));
        Ok(())
    }

    fn outside(&mut self, method: &dyn Method, phases: &Phases) {
        let name = &method.card().name;
        let answered = answered_outside(method, phases, CloudAt::BASE);
        self.breaches
            .extend(answered.into_iter().map(|what| format!("{name} answers outside its domain: {what}")));
    }
}

/// One line for each class that a method must not have, with the first place.
fn breaches(name: &str, cells: &[Cell]) -> Vec<String> {
    let broken = Class::ALL.into_iter().filter(|class| !class.is_allowed());
    let line = |class: Class| {
        let of_class: Vec<&Cell> = cells.iter().filter(|cell| cell.class == class).collect();
        let first = of_class.first()?;
        let (quantity, precision, point) = (first.quantity.name(), first.precision.name(), first.place.point);
        let (count, cloud) = (of_class.len(), first.place.cloud);
        let value = first.value.unwrap_or(f64::NAN);
        Some(format!(
            "{name}: {count} values {}, first {quantity} ({precision}) = {value} at tau {}, mu_l {}, mu_v {}, phi {}, r_e {} um, theta_f {}, \
             omega {}; truth {:?}",
            class.name(),
            point.tau,
            point.mu_l,
            point.mu_v,
            point.phi_deg,
            cloud.r_eff_um,
            cloud.theta_f_deg,
            cloud.omega,
            first.truth
        ))
    };
    broken.filter_map(line).collect()
}

fn fault(error: ChartError) -> CliError {
    match error {
        ChartError::Cancelled => CliError::Interrupted,
        ChartError::Optics(error) => pipeline::optics::optics_error(error),
        ChartError::Transport(error) => pipeline::trace_error(error),
        other => CliError::Input(other.to_string()),
    }
}
