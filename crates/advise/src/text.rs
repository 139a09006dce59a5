//! The answer in words.

use crate::emitted::stem;
use crate::predict::{FLOOR, MARGIN};
use crate::{Advice, Channels};
use std::fmt::{self, Display, Formatter};
use stratiform_scene::Effect;

pub(crate) fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

fn list(values: &[f64]) -> String {
    values.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
}

/// As people say it.
fn time(ns: f64) -> String {
    if ns >= 1e4 { format!("{:.0} us", 1e-3 * ns) } else { format!("{ns:.1} ns") }
}

fn effect(effect: Effect) -> &'static str {
    match effect {
        Effect::Glory => "the glory",
        Effect::Fogbow => "the fogbow",
        Effect::SilverLining => "the silver lining",
        Effect::GroundBounce => "the ground's light",
    }
}

impl Display for Advice {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.title)?;
        for note in self.notes.iter().filter(|note| note.starts_with("WARNING")) {
            writeln!(f, "{note}")?;
        }
        if !self.met {
            writeln!(f, "No listed method meets the budget. The nearest:")?;
        }
        writeln!(f, "  method        {}: {}", self.method, self.method_title)?;
        self.write_code(f)?;
        self.write_error(f)?;
        let channels = match self.channels {
            Channels::Grey => "grey: one evaluation serves all channels",
            Channels::Rgb => "RGB: one evaluation for each wavelength",
        };
        writeln!(f, "  cost          {} a pixel (f32, one thread)", time(self.ns))?;
        writeln!(f, "  colour        {channels}")?;
        let orders = self.orders.map_or("more than 2 count".to_owned(), |count| format!("{count} suffice"));
        writeln!(f, "  scatterings   {orders}")?;
        self.write_tables(f)?;
        self.write_bounce(f)?;
        for note in self.notes.iter().filter(|note| !note.starts_with("WARNING")) {
            writeln!(f, "  note          {note}")?;
        }
        self.write_rejected(f)
    }
}

impl Advice {
    fn write_code(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match (&self.emitted, self.table_bytes) {
            (Some(emitted), _) => {
                writeln!(f, "  shader code   {}.*: call {}", emitted.library, emitted.functions.join(", "))
            }
            (None, Some(_)) => writeln!(f, "  shader code   a formula, not among the emitted libraries"),
            (None, None) => writeln!(f, "  shader code   none: for tables made beforehand"),
        }
    }

    fn write_error(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let promise = &self.prediction;
        let decided = promise.decided_by.map_or(String::new(), |one| format!(", {} decides", effect(one)));
        if promise.refused >= 1.0 {
            return writeln!(f, "  error         none promised: it refuses the scene");
        }
        writeln!(f, "  error         at most {} at 95 % of the scene{decided}", percent(promise.error))?;
        writeln!(
            f,
            "                (known error x {MARGIN} + {}); median {}, worst {}",
            percent(FLOOR),
            percent(promise.median),
            percent(promise.worst)
        )?;
        if promise.refused > 0.0 {
            writeln!(f, "  refuses       {} of the scene", percent(promise.refused))?;
        }
        Ok(())
    }

    fn write_tables(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let radii = &self.phase_radii_um;
        match self.phase_texels {
            Some(texels) => writeln!(
                f,
                "  phase tables  {texels} texels, {} for r_e = {} um",
                count(radii.len(), "table"),
                list(radii)
            )?,
            None => writeln!(f, "  phase tables  none")?,
        }
        let (radii, suns) = (&self.parameter_radii_um, &self.theta_l_nodes_deg);
        if radii.is_empty() {
            writeln!(f, "  parameters    one set for every r_e and sun, or none")?;
        } else {
            writeln!(
                f,
                "  parameters    {} for r_e = {} um, rows at theta_l = {} deg",
                count(radii.len(), "table"),
                list(radii),
                list(suns)
            )?;
        }
        self.table_bytes.map_or(Ok(()), |bytes| writeln!(f, "  memory        {bytes} bytes of tables"))
    }

    fn write_bounce(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Some(bounce) = &self.bounce else { return writeln!(f, "  ground        no radiosity passes") };
        writeln!(
            f,
            "  ground        {} with R and T of {} (error {}, {}); albedo of the ground {}, of the cloud {:.2}",
            count(bounce.passes as usize, "radiosity pass"),
            bounce.method,
            percent(bounce.error),
            time(bounce.ns),
            bounce.ground_albedo,
            bounce.cloud_albedo
        )
    }

    fn write_rejected(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let lines = self.rejected_lines();
        let width = lines.iter().map(|(names, _)| names.len()).max().unwrap_or(0).max(8);
        writeln!(f, "\n{:width$}  {:>8}  {:>9}  why not", "rejected", "error", "cost")?;
        lines.iter().try_for_each(|(names, rest)| writeln!(f, "{names:width$}  {rest}"))
    }

    /// Names and what is said of them; settings of one knob of which the same is said share a line.
    fn rejected_lines(&self) -> Vec<(String, String)> {
        let mut lines: Vec<(String, String)> = Vec::new();
        for one in &self.rejected {
            let error = one.error.map_or("-".to_owned(), percent);
            let cost = one.ns.map_or("-".to_owned(), time);
            let said = format!("{error:>8}  {cost:>9}  {}", one.reason);
            let knob = &one.method[stem(&one.method).len()..];
            match lines.last_mut() {
                Some((names, before)) if *before == said && stem(names) == stem(&one.method) => {
                    names.push_str(&format!(", {knob}"));
                }
                _ => lines.push((one.method.clone(), said)),
            }
        }
        lines
    }
}

fn count(number: usize, what: &str) -> String {
    match (number, what.ends_with('s')) {
        (1, _) => format!("1 {what}"),
        (_, true) => format!("{number} {what}es"),
        (_, false) => format!("{number} {what}s"),
    }
}
