//! The truth: the deterministic solver on the full medium, one call for each sun with all thicknesses and views.
//!
//! Radiances are solved to [`TOLERANCE`]; each comes with its own estimated error. A point whose error exceeds [`SHARE`] of its
//! value, or that the solver cannot answer, is `None`: it is counted and left out. Results are kept on disk by the hash of the
//! phase function, albedo and grid.

use crate::ChartError;
use crate::grid::Grid;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use stratiform_artifact::{create_folder, hash_bytes, hash_of, write_atomic};
use stratiform_methods::{Cloud, FluxPair};
use stratiform_quantities::Incidence;
use stratiform_stats::Estimate;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, Solver, View};

/// Asked of radiances: absolute below 1, relative above.
pub const TOLERANCE: f64 = 1e-4;

/// Asked of fluxes, absolute.
const FLUX_TOLERANCE: f64 = 1e-6;

/// The largest relative error of a truth that counts.
pub const SHARE: f64 = 0.01;

/// Changes whenever the solver gives other numbers, so that no cache hands out what an earlier program computed.
const REVISION: u32 = 1;

/// What the methods are held against, in the order of the grid's points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Truth {
    /// Radiances; `None` where they are not known well enough.
    pub radiances: Vec<Option<Estimate>>,
    /// R and T with estimated errors.
    pub fluxes: Vec<(Estimate, Estimate)>,
}

impl Truth {
    /// Solves for a grid.
    ///
    /// # Errors
    /// [`ChartError::Transport`].
    pub fn solve(cloud: &Cloud, grid: &Grid) -> Result<Self, ChartError> {
        let medium = SolveMedium::full(cloud.phase().clone(), cloud.omega());
        let solver = RadianceSolver::new(medium.clone(), TOLERANCE)?;
        let views = grid.views();
        let suns = grid.mu_l();
        let mut radiances = Vec::new();
        for mu_l in &suns {
            radiances.extend(together(&solver, &grid.tau, *mu_l, &views)?);
        }
        let incidences = suns.iter().map(|mu_l| Incidence::beam(*mu_l)).collect::<Result<Vec<_>, _>>()?;
        let solved = Solver::new(medium, FLUX_TOLERANCE)?.totals(&grid.tau, &incidences)?;
        let places = (0..suns.len()).flat_map(|sun| (0..grid.tau.len()).map(move |tau| (sun, tau)));
        let fluxes = places.map(|(sun, tau)| solved.total(sun, tau)).collect();
        Ok(Self { radiances, fluxes })
    }

    /// [`solve`](Self::solve), unless `folder` holds the result of the same inputs. A folder that cannot be written is no
    /// reason to stop.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub fn load_or_solve(cloud: &Cloud, grid: &Grid, folder: Option<&Path>) -> Result<Self, ChartError> {
        let path = folder.map(|folder| entry(folder, cloud, grid));
        let count = (grid.points().len(), grid.flux_points().len());
        let kept = path.as_deref().and_then(load);
        if let Some(truth) = kept.filter(|truth| (truth.radiances.len(), truth.fluxes.len()) == count) {
            return Ok(truth);
        }
        let truth = Self::solve(cloud, grid)?;
        if let Some(path) = path {
            store(&path, &truth);
        }
        Ok(truth)
    }

    /// R and T without their errors' names.
    pub fn flux(&self, place: usize) -> FluxPair {
        let (reflectance, transmittance) = self.fluxes[place];
        FluxPair { reflectance, transmittance }
    }

    /// Largest relative error among the radiances that count.
    pub fn worst_error(&self) -> f64 {
        let share = |truth: &Estimate| truth.std_error / truth.value.abs();
        self.radiances.iter().flatten().map(share).fold(0.0, f64::max)
    }
}

/// One sun: thicknesses outside, views inside. Where the solver refuses the lot, each view is asked for alone.
fn together(
    solver: &RadianceSolver,
    tau: &[f64],
    mu_l: f64,
    views: &[View],
) -> Result<Vec<Option<Estimate>>, ChartError> {
    let total = RadianceOrder::Total;
    if let Ok(solved) = solver.radiance_as_reached(total, tau, &[mu_l], views) {
        let places = (0..tau.len()).flat_map(|t| (0..views.len()).map(move |v| (t, v)));
        return Ok(places.map(|(t, v)| known(solved.estimate(t, 0, v, total))).collect());
    }
    let places = tau.iter().flat_map(|tau| views.iter().map(move |view| (*tau, *view)));
    let alone = |(tau, view): (f64, View)| {
        let solved = solver.radiance_as_reached(total, &[tau], &[mu_l], &[view]);
        solved.ok().and_then(|solved| known(solved.estimate(0, 0, 0, total)))
    };
    Ok(places.map(alone).collect())
}

/// Well enough.
fn known(estimate: Estimate) -> Option<Estimate> {
    let enough = estimate.value.is_finite() && estimate.std_error <= SHARE * estimate.value.abs();
    (enough && estimate.value != 0.0).then_some(estimate)
}

fn entry(folder: &Path, cloud: &Cloud, grid: &Grid) -> PathBuf {
    let phase = cloud.phase();
    let medium = (phase.theta_deg(), phase.values(), cloud.omega().get());
    let angles = (&grid.theta_l_deg, &grid.theta_v_deg, &grid.phi_deg, &grid.sides);
    let settings = ("stratiform/truth", REVISION, TOLERANCE, FLUX_TOLERANCE, SHARE);
    folder.join(format!("truth-{}.json", hash_of(&(settings, medium, &grid.tau, angles))))
}

/// What reads back whole.
fn load(path: &Path) -> Option<Truth> {
    let text = std::fs::read_to_string(path).ok()?;
    let (hash, body) = text.split_once('\n')?;
    (hash == hash_bytes(body.as_bytes())).then(|| serde_json::from_str(body).ok())?
}

fn store(path: &Path, truth: &Truth) {
    let Ok(body) = serde_json::to_string(truth) else { return };
    let text = format!("{}\n{body}", hash_bytes(body.as_bytes()));
    // The next run solves again.
    let _ = create_folder(path.parent().unwrap_or(Path::new("")))
        .and_then(|()| write_atomic(path, text.as_bytes()));
}
