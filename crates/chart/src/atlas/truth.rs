//! The truth in a plane: the deterministic solver on the full medium, one call for each cloud and sun.
//!
//! Radiances and fluxes are `None` where the solver's own estimated error exceeds [`SHARE`] of the value. Results are kept on
//! disk by the hash of phase function, albedo and grid.

use super::plane::Place;
use crate::ChartError;
use rayon::prelude::*;
use std::path::Path;
use stratiform_artifact::{create_folder, hash_bytes, hash_of, write_atomic};
use stratiform_methods::{Cloud, Point};
use stratiform_quantities::{Incidence, Side};
use stratiform_stats::Estimate;
use stratiform_transport::TransportError;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, Solver, View};

/// The largest relative error of a truth that counts.
pub const SHARE: f64 = 0.01;

/// Asked of radiances: absolute below 1, relative above.
const TOLERANCE: f64 = 1e-3;

/// Asked of fluxes, absolute.
const FLUX_TOLERANCE: f64 = 1e-6;

/// Changes whenever the solver gives other numbers.
const REVISION: u32 = 1;

/// Top, bottom, R and T of a place.
pub type Four = [Option<Estimate>; 4];

/// One call of the solver.
struct Group {
    cloud: Cloud,
    mu_l: f64,
    tau: Vec<f64>,
    views: Vec<(f64, f64)>,
}

fn place_of<T: PartialEq>(list: &mut Vec<T>, value: T) -> usize {
    list.iter().position(|known| *known == value).unwrap_or_else(|| {
        list.push(value);
        list.len() - 1
    })
}

/// What is true at each place; nothing is where its cloud is refused.
///
/// # Errors
/// [`ChartError::Transport`].
pub fn truths(places: &[(Place, Option<Cloud>)], cache: Option<&Path>) -> Result<Vec<Four>, ChartError> {
    let mut groups: Vec<Group> = Vec::new();
    let mut found = Vec::new();
    for (place, cloud) in places {
        let Some(cloud) = cloud else {
            found.push(None);
            continue;
        };
        let Point { tau, mu_l, mu_v, phi_deg, .. } = place.point;
        let same = |group: &Group| group.mu_l == mu_l && is_same(&group.cloud, cloud);
        let at = groups.iter().position(same).unwrap_or_else(|| {
            groups.push(Group { cloud: cloud.clone(), mu_l, tau: Vec::new(), views: Vec::new() });
            groups.len() - 1
        });
        let group = &mut groups[at];
        found.push(Some((at, place_of(&mut group.tau, tau), place_of(&mut group.views, (mu_v, phi_deg)))));
    }
    let solved: Vec<Vec<Vec<Four>>> =
        groups.par_iter().map(|group| group.load_or_solve(cache)).collect::<Result<_, _>>()?;
    Ok(found
        .into_iter()
        .map(|at| at.map_or([None; 4], |(group, tau, view)| solved[group][tau][view]))
        .collect())
}

/// Whether the full media are the same: θ_f is not part of them.
fn is_same(a: &Cloud, b: &Cloud) -> bool {
    a.omega() == b.omega() && a.phase().values() == b.phase().values()
}

impl Group {
    fn load_or_solve(&self, cache: Option<&Path>) -> Result<Vec<Vec<Four>>, TransportError> {
        let phase = self.cloud.phase();
        let medium = (phase.theta_deg(), phase.values(), self.cloud.omega().get());
        let key = ("stratiform/atlas", REVISION, TOLERANCE, FLUX_TOLERANCE, SHARE, medium);
        let hash = hash_of(&(key, self.mu_l, &self.tau, &self.views));
        let path = cache.map(|folder| folder.join(format!("atlas-{hash}.json")));
        if let Some(kept) = path.as_deref().and_then(load) {
            return Ok(kept);
        }
        let solved = self.solve()?;
        if let Some(path) = path {
            store(&path, &solved);
        }
        Ok(solved)
    }

    /// Thicknesses outside, views inside.
    fn solve(&self) -> Result<Vec<Vec<Four>>, TransportError> {
        let medium = SolveMedium::full(self.cloud.phase().clone(), self.cloud.omega());
        let solver = RadianceSolver::new(medium.clone(), TOLERANCE)?;
        let views: Vec<View> = Side::BOTH
            .iter()
            .flat_map(|side| {
                self.views.iter().map(|(mu, phi_deg)| View { side: *side, mu: *mu, phi_deg: *phi_deg })
            })
            .collect();
        let total = RadianceOrder::Total;
        let radiances = solver.radiance_as_reached(total, &self.tau, &[self.mu_l], &views).ok();
        let fluxes =
            Solver::new(medium, FLUX_TOLERANCE)?.totals(&self.tau, &[Incidence::beam(self.mu_l)?]).ok();
        let half = self.views.len();
        let at = |tau: usize, view: usize| {
            let side = |place: usize| {
                radiances.as_ref().and_then(|solved| known(solved.estimate(tau, 0, place, total)))
            };
            let pair = fluxes.as_ref().map(|solved| solved.total(0, tau));
            let (r, t) = pair.map_or((None, None), |(r, t)| (known(r), known(t)));
            [side(view), side(half + view), r, t]
        };
        Ok((0..self.tau.len()).map(|tau| (0..half).map(|view| at(tau, view)).collect()).collect())
    }
}

/// Well enough.
fn known(estimate: Estimate) -> Option<Estimate> {
    let enough = estimate.value.is_finite() && estimate.std_error <= SHARE * estimate.value.abs();
    (enough && estimate.value > 0.0).then_some(estimate)
}

/// What reads back whole.
fn load(path: &Path) -> Option<Vec<Vec<Four>>> {
    let text = std::fs::read_to_string(path).ok()?;
    let (hash, body) = text.split_once('\n')?;
    (hash == hash_bytes(body.as_bytes())).then(|| serde_json::from_str(body).ok())?
}

fn store(path: &Path, solved: &Vec<Vec<Four>>) {
    let Ok(body) = serde_json::to_string(solved) else { return };
    let text = format!("{}\n{body}", hash_bytes(body.as_bytes()));
    // The next run solves again.
    let _ = create_folder(path.parent().unwrap_or(Path::new("")))
        .and_then(|()| write_atomic(path, text.as_bytes()));
}
