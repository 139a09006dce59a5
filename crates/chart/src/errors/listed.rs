//! Which methods are listed, and what they cost.
//!
//! All shader code, and the [`OFFLINE`] solvers for budgets that no shader code meets: what one radiance costs them in a batch.

use super::ErrorsError;
use super::rows::{flux_point, point};
use crate::cost::{Effort, alone, flux_ns, radiance_ns};
use std::time::Duration;
use stratiform_artifact::{ErrorBlock, ErrorMethod, ErrorRow};
use stratiform_methods::{
    Cloud, EMITTED_TEXELS, FluxPoint, Method, MethodError, Point, Ready, Single, all, by_name, knobs,
};

/// Sizes of phase tables that are listed.
const TEXELS: [f64; 3] = [64.0, 256.0, 1024.0];

/// What is no shader code but answers within milliseconds.
const OFFLINE: [&str; 0] = [];

/// Points of an offline method's batch.
const BATCH: usize = 500;

/// One run.
const SHORT: Effort = Effort { repeat: Duration::from_micros(200), repeats: 1 };

/// So many of them.
const RUNS: usize = 100;

/// A method under its name, with the size of its phase table.
pub struct Listed {
    /// Stem and knob.
    pub name: String,
    /// What it is.
    pub method: Box<dyn Method>,
    /// The name without what changes no cost.
    stem: String,
    texels: Option<usize>,
    /// `None` where it is no shader code.
    table_bytes: Option<usize>,
}

impl Listed {
    fn new(method: Box<dyn Method>, stem: &str, texels: Option<usize>) -> Self {
        let (name, table_bytes) = (method.card().name.clone(), method.card().table_bytes);
        Self { name, method, stem: stem.to_owned(), texels, table_bytes }
    }
}

/// Every method that is shader code, turned through the values of its knob, then those that are not.
///
/// # Errors
/// [`ErrorsError`].
pub fn listed() -> Result<Vec<Listed>, ErrorsError> {
    let mut list = Vec::new();
    for method in all() {
        let card = method.card();
        let Some(table_bytes) = card.table_bytes else { continue };
        let stem = card.name.split(':').next().unwrap_or_default().to_owned();
        if let Some(knob) = knobs(&stem) {
            let texels = knob.counts == "texels";
            for value in knob.values.iter().filter(|value| !texels || TEXELS.contains(*value)) {
                let name = format!("{stem}:{value}");
                let costs_as = if texels { &stem } else { &name };
                list.push(Listed::new(by_name(&name)?, costs_as, texels.then_some(*value as usize)));
            }
        } else {
            let texels = (table_bytes >= 4 * EMITTED_TEXELS).then_some(EMITTED_TEXELS);
            list.push(Listed::new(method, &stem, texels));
        }
    }
    for name in OFFLINE {
        list.push(Listed::new(by_name(name)?, name, None));
    }
    Ok(list)
}

/// Their records, costs measured at the first of `clouds` that is not refused, over the points of `rows`.
///
/// # Errors
/// [`ErrorsError::Method`].
pub(super) fn records(
    methods: &[Listed],
    clouds: &[&Cloud],
    rows: &[ErrorRow],
) -> Result<Vec<ErrorMethod>, ErrorsError> {
    let (fluxes, seen): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.block == ErrorBlock::Flux);
    let seen: Vec<Point> = seen.iter().step_by(seen.len() / BATCH + 1).map(|row| point(row)).collect();
    let fluxes: Vec<FluxPoint> = fluxes.iter().map(|row| flux_point(row)).collect();
    let mut records: Vec<ErrorMethod> = Vec::new();
    for one in methods {
        let card = one.method.card();
        let same =
            methods.iter().position(|other| other.stem == one.stem).and_then(|first| records.get(first));
        let costs = match same {
            // Sizes of a table do not change what is computed: differences would be noise.
            Some(first) => [first.ns, first.flux_ns],
            None => {
                let ready = clouds.iter().find_map(|cloud| one.method.prepare(cloud).ok());
                match (&ready, one.table_bytes) {
                    (Some(ready), None) => batch_costs(ready.as_ref(), &seen, &fluxes)?,
                    (ready, _) => costs(ready.as_ref().and_then(|ready| ready.single()), &seen, &fluxes)?,
                }
            }
        };
        records.push(ErrorMethod {
            name: one.name.clone(),
            title: card.title.to_owned(),
            radiance: card.radiance,
            flux: card.flux,
            ns: costs[0].filter(|_| card.radiance),
            flux_ns: costs[1].filter(|_| card.flux),
            table_bytes: one.table_bytes.map(|count| count as u64),
            texels: one.texels.map(|count| count as u64),
            tau_min: card.domain.tau.min,
            tau_max: card.domain.tau.max,
            mu_l_min: card.domain.mu_l.min,
            mu_v_min: card.domain.mu_v.min,
            r_e_min_um: Some(card.domain.r_eff_um.min).filter(|radius| *radius > 0.0),
            r_e_max_um: Some(card.domain.r_eff_um.max).filter(|radius| radius.is_finite()),
        });
    }
    Ok(records)
}

/// A share of a batch on one thread.
fn batch_costs(
    ready: &dyn Ready,
    seen: &[Point],
    fluxes: &[FluxPoint],
) -> Result<[Option<f64>; 2], ErrorsError> {
    let share = |ns: f64, count: usize| Some((ns / count.max(1) as f64).round());
    let (radiances, ns) = alone(|| ready.radiances(seen).map(|_| ()))?;
    let (pairs, flux_ns) = alone(|| ready.fluxes(fluxes).map(|_| ()))?;
    radiances.and(pairs)?;
    Ok([share(ns, seen.len()), share(flux_ns, fluxes.len())])
}

/// The quickest of [`RUNS`] short runs, to 0.1 ns: other work on the machine only ever adds.
fn costs(
    single: Option<&dyn Single>,
    seen: &[Point],
    fluxes: &[FluxPoint],
) -> Result<[Option<f64>; 2], MethodError> {
    let Some(single) = single else { return Ok([None, None]) };
    let mut quickest: [Option<f64>; 2] = [None, None];
    for _ in 0..RUNS {
        let run = [radiance_ns(single, seen, SHORT)?, flux_ns(single, fluxes, SHORT)];
        for (least, ns) in quickest.iter_mut().zip(run) {
            *least = ns.map(|ns| least.map_or(ns, |least| least.min(ns)));
        }
    }
    Ok(quickest.map(|ns| ns.map(|ns| (10.0 * ns).round() / 10.0)))
}
