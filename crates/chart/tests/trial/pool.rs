//! Points with their truth, solved once for many scenes.
//!
//! Suns at even distance up to 87° and thicknesses in even ratios from 0.1 to 100, each shifted by a random share of its step; under
//! every sun directions of its own: even in θ_v, φ and side, then a few in each effect's window.

use super::TrialError;
use rand::Rng;
use std::collections::BTreeMap;
use stratiform_advise::{Ask, WINDOWS};
use stratiform_chart::errors::{Listed, listed};
use stratiform_methods::{Cloud, Point};
use stratiform_quantities::Side;
use stratiform_scene::{Interval, Scene, named};
use stratiform_stats::{Purpose, key, photon_stream};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, View};

/// Asked of the truth, absolute below 1, relative above; what is known less well than to 1 % is left out.
const TOLERANCE: f64 = 2e-3;
const SHARE: f64 = 0.01;

/// Thickness of the pools.
pub const TAU: Interval = Interval { min: 0.1, max: 100.0 };

/// Sun and view of the pools.
pub const THETA_DEG: Interval = Interval { min: 0.0, max: 87.0 };

/// How many points.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Suns.
    pub suns: usize,
    /// Thicknesses under each.
    pub thicknesses: usize,
    /// Directions of each.
    pub views: usize,
    /// More of them for each effect.
    pub effects: usize,
}

/// A point of a pool.
pub struct Pooled {
    /// Where.
    pub ask: Ask,
    /// In each wavelength.
    pub truths: Vec<f64>,
    /// What each listed method says in the middle one, unless it refuses.
    pub values: BTreeMap<String, f64>,
}

impl Pooled {
    /// For a method.
    pub fn point(&self) -> Point {
        let ask = &self.ask;
        let (mu_l, mu_v) = (mu(ask.theta_l_deg), mu(ask.theta_v_deg));
        Point { tau: ask.tau, mu_l, mu_v, phi_deg: ask.phi_deg, side: ask.side }
    }
}

/// The points of one droplet size.
pub struct Pool {
    /// r_e.
    pub effective_radius_um: f64,
    /// Red, green, blue; or green alone.
    pub waves: Vec<Cloud>,
    /// With truths.
    pub points: Vec<Pooled>,
}

fn mu(theta_deg: f64) -> f64 {
    libm::cos(theta_deg.to_radians())
}

/// Everything that a pool covers.
fn everywhere() -> Result<Scene, TrialError> {
    let mut scene = named("thin-veil")?;
    (scene.sun.theta_deg, scene.view.theta_deg) = (THETA_DEG, THETA_DEG);
    scene.view.azimuth_deg = Interval { min: 0.0, max: 180.0 };
    scene.view.sides = Side::BOTH.to_vec();
    Ok(scene)
}

impl Pool {
    /// Solves the truth of `waves` where `seed` says.
    ///
    /// # Errors
    /// [`TrialError`].
    pub fn new(
        effective_radius_um: f64,
        waves: Vec<Cloud>,
        seed: u64,
        effort: Effort,
    ) -> Result<Self, TrialError> {
        let solver = |cloud: &Cloud| {
            RadianceSolver::new(SolveMedium::full(cloud.phase().clone(), cloud.omega()), TOLERANCE)
        };
        let solvers = waves.iter().map(solver).collect::<Result<Vec<_>, _>>()?;
        let scene = everywhere()?;
        let mut points = Vec::new();
        for sun in 0..effort.suns {
            let asks = directions(&scene, key(seed, Purpose::Calibration), sun, effort);
            points.extend(solve(&solvers, &asks)?);
        }
        for one in listed()? {
            answer(&one, &waves[waves.len() / 2], &mut points);
        }
        Ok(Self { effective_radius_um, waves, points })
    }
}

/// Asks a method for every point, and where that is refused for each alone.
fn answer(one: &Listed, cloud: &Cloud, points: &mut [Pooled]) {
    let Ok(ready) = one.method.prepare(cloud) else { return };
    let asked: Vec<Point> = points.iter().map(Pooled::point).collect();
    let together = ready.radiances(&asked);
    for (place, pooled) in points.iter_mut().enumerate() {
        let alone = || ready.radiances(&asked[place..=place]).ok()?.first().copied();
        let value = together.as_ref().map_or_else(|_| alone(), |values| values.get(place).copied());
        value.map(|estimate| pooled.values.insert(one.name.clone(), estimate.value));
    }
}

/// Thicknesses, and directions under sun number `sun`.
fn directions(scene: &Scene, key: u64, sun: usize, effort: Effort) -> (Vec<f64>, Vec<Ask>) {
    let mut stream = photon_stream(key, sun as u64);
    let mut share = || f64::from(stream.next_u32()) / 4_294_967_296.0;
    let within = |place: usize, count: usize, share: f64| (place as f64 + share) / count as f64;
    let theta_l = within(sun, effort.suns, share());
    let shift = share();
    let depth = |place| within(place, effort.thicknesses, shift);
    let tau = (0..effort.thicknesses).map(|i| Ask::within(scene, TAU, [0.5, depth(i), 0.0, 0.0, 0.0], 0).tau);
    let tau = tau.collect();
    let mut ask = |turn: usize| Ask::within(scene, TAU, [0.5, 0.5, theta_l, share(), share()], turn);
    let mut asks: Vec<Ask> = (0..effort.views).map(&mut ask).collect();
    for (_, _, side, window) in WINDOWS {
        let turn = if side == Side::Top { 0 } else { 1 };
        let tried = std::iter::repeat_with(|| ask(turn)).take(20_000);
        asks.extend(tried.filter(|ask| window.contains(ask.scattering_deg)).take(effort.effects));
    }
    (tau, asks)
}

fn solve(solvers: &[RadianceSolver], (tau, asks): &(Vec<f64>, Vec<Ask>)) -> Result<Vec<Pooled>, TrialError> {
    let Some(first) = asks.first() else { return Ok(Vec::new()) };
    let view = |ask: &Ask| View { side: ask.side, mu: mu(ask.theta_v_deg), phi_deg: ask.phi_deg };
    let views: Vec<View> = asks.iter().map(view).collect();
    let total = RadianceOrder::Total;
    let solved = solvers
        .iter()
        .map(|solver| solver.radiance_as_reached(total, tau, &[mu(first.theta_l_deg)], &views))
        .collect::<Result<Vec<_>, _>>()?;
    let mut pooled = Vec::new();
    for (t, tau) in tau.iter().enumerate() {
        for (v, ask) in asks.iter().enumerate() {
            let known: Vec<_> = solved.iter().map(|solved| solved.estimate(t, 0, v, total)).collect();
            if known.iter().all(|truth| truth.value > 0.0 && truth.std_error <= SHARE * truth.value) {
                let truths = known.iter().map(|truth| truth.value).collect();
                let ask = Ask { tau: *tau, ..*ask };
                pooled.push(Pooled { ask, truths, values: BTreeMap::new() });
            }
        }
    }
    Ok(pooled)
}
