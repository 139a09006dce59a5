//! Photon counts as they are stored: whole numbers, one row per medium, incidence, thickness and order.

use crate::CliError;
use crate::check::config::TracerConfig;
use crate::config::Config;
use crate::output::Talk;
use crate::pipeline::fluxes;
use crate::pipeline::input_error;
use crate::pipeline::optics::Cloud;
use crate::pipeline::reference::{AtIncidence, Media, Plan};
use crate::progress;
use serde::{Deserialize, Serialize};
use std::ffi::OsStr;
use std::path::Path;
use stratiform_artifact::RowIncidence;
use stratiform_quantities::{Medium, Order};
use stratiform_reference_data::rows_in;
use stratiform_transport::{Quantity, Traced, trace_half_space};

/// Orders that are counted by themselves, beside the total.
const ORDERS: [Order; 4] = [Order::Exactly(0), Order::Exactly(1), Order::Exactly(2), Order::Total];

/// One row. In the modified medium orders count wide events.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CountRow {
    /// Full or modified.
    pub medium: Medium,
    /// Angle in degrees, or `diffuse`.
    pub theta_l_deg: RowIncidence,
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// 0, 1, 2 or `total`.
    pub order: Order,
    /// Photons launched.
    pub photons: u64,
    /// Photons of this order that left through the top.
    pub reflected: u64,
    /// Photons of this order that left through the bottom.
    pub transmitted: u64,
}

impl CountRow {
    /// Whether the other row is about the same medium, incidence, thickness and order.
    pub fn is_at(&self, other: &Self) -> bool {
        (self.medium, &self.theta_l_deg, self.tau, self.order)
            == (other.medium, &other.theta_l_deg, other.tau, other.order)
    }
}

/// Traces `photons` per incidence and medium of the config.
///
/// # Errors
/// [`CliError::Interrupted`], or [`CliError::Input`] for numbers out of domain.
pub fn trace(
    config: &Config,
    cloud: &Cloud,
    tracer: &TracerConfig,
    photons: u64,
    seed: u64,
    talk: Talk,
) -> Result<Vec<CountRow>, CliError> {
    let plan = Plan { rows: fluxes::nodes(config), tau: tracer.tau.clone(), photons, seed };
    let bar = progress::bar(plan.histories(), "photons", talk.quiet);
    let media = Media::new(config, cloud)?;
    let traced = plan.trace(&|done| bar.set_position(done), |medium, request, control| {
        trace_half_space(media.get(medium), request, control)
    })?;
    bar.finish_and_clear();
    Ok([Medium::Full, Medium::Modified]
        .into_iter()
        .flat_map(|medium| traced.iter().flat_map(move |incidence| rows(incidence, medium)))
        .collect())
}

fn rows(traced: &AtIncidence<Traced>, medium: Medium) -> Vec<CountRow> {
    let counts = traced.get(medium);
    let row = |(k, tau): (usize, &f64), order: Order| CountRow {
        medium,
        theta_l_deg: traced.row.clone(),
        tau: *tau,
        order,
        photons: counts.photons(),
        reflected: counts.hits(k, Quantity::Reflectance(order)),
        transmitted: counts.hits(k, Quantity::Transmittance(order)),
    };
    counts.tau().iter().enumerate().flat_map(|place| ORDERS.map(|order| row(place, order))).collect()
}

/// Reads stored counts: a table that the `SOURCE.toml` beside it lists with its SHA-256.
///
/// # Errors
/// [`CliError::Input`] naming what is missing, damaged or changed.
pub fn read(file: &Path) -> Result<Vec<CountRow>, CliError> {
    let part = |path: Option<&OsStr>| path.unwrap_or_default().to_string_lossy().into_owned();
    let folder = file.parent().unwrap_or(Path::new(""));
    let root = folder.parent().unwrap_or(Path::new(""));
    let rows: Vec<CountRow> =
        rows_in(root, &part(folder.file_name()), &part(file.file_name())).map_err(input_error)?;
    let sound = |row: &CountRow| row.photons > 0 && row.reflected.max(row.transmitted) <= row.photons;
    match rows.iter().find(|row| !sound(row)) {
        Some(row) => Err(CliError::Input(format!(
            "{}: more photons counted than launched at theta_l {}, tau {}, order {}",
            file.display(),
            row.theta_l_deg,
            row.tau,
            row.order
        ))),
        None => Ok(rows),
    }
}
