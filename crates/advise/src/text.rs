//! The answer in words.

use crate::predict::{FLOOR, MARGIN};
use crate::{Advice, Channels};
use std::fmt::{self, Display, Formatter};

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

fn list(values: &[f64]) -> String {
    values.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
}

impl Display for Advice {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.title)?;
        if !self.met {
            writeln!(f, "No listed method meets the budget. The nearest:")?;
        }
        writeln!(f, "  method           {} ({})", self.method, self.method_title)?;
        self.write_error(f)?;
        writeln!(f, "  cost             {:.1} ns a pixel (f32, one thread)", self.ns)?;
        let channels = match self.channels {
            Channels::Grey => "one value serves all channels",
            Channels::Rgb => "one evaluation for each wavelength",
        };
        writeln!(f, "  colour           {channels}")?;
        let orders = self.orders.map_or("more than 2 count".to_owned(), |count| format!("{count} suffice"));
        writeln!(f, "  orders           {orders}")?;
        let texels = self.phase_texels.map_or("none".to_owned(), |count| format!("{count} texels"));
        writeln!(f, "  phase table      {texels}")?;
        let radii = &self.effective_radius_nodes_um;
        writeln!(f, "  droplet nodes    {}: {} um", radii.len(), list(radii))?;
        let suns = &self.theta_l_nodes_deg;
        writeln!(f, "  parameter rows   {}: theta_l = {} deg", suns.len(), list(suns))?;
        writeln!(f, "  tables           {} bytes", self.table_bytes)?;
        self.write_bounce(f)?;
        for note in &self.notes {
            writeln!(f, "  note             {note}")?;
        }
        self.write_rejected(f)
    }
}

impl Advice {
    fn write_error(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let promise = &self.prediction;
        let decided = promise.decided_by.map_or(String::new(), |effect| format!(", decided by {effect:?}"));
        writeln!(
            f,
            "  error            {} (95th percentile x {MARGIN} + {}{decided}); median {}, worst {}",
            percent(promise.error),
            percent(FLOOR),
            percent(promise.median),
            percent(promise.worst)
        )?;
        if promise.refused > 0.0 {
            writeln!(f, "  refuses          {} of the scene", percent(promise.refused))?;
        }
        Ok(())
    }

    fn write_bounce(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Some(bounce) = &self.bounce else { return writeln!(f, "  ground           no radiosity passes") };
        writeln!(
            f,
            "  ground           {} passes with R and T of {} (error {}, {:.1} ns); ground albedo {}, cloud's {:.2}",
            bounce.passes,
            bounce.method,
            percent(bounce.error),
            bounce.ns,
            bounce.ground_albedo,
            bounce.cloud_albedo
        )
    }

    fn write_rejected(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "Rejected:")?;
        let width = self.rejected.iter().map(|one| one.method.len()).max().unwrap_or(0);
        self.rejected.iter().try_for_each(|one| writeln!(f, "  {:width$}  {}", one.method, one.reason))
    }
}
