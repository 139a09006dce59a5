//! Whether advice holds: random scenes, points of a [`Pool`] in them that are no nodes of the data, truth by the solver.
//!
//! A [`Trial`] has two verdicts. *Held*: the 95th percentile of the advised method's error at the points, of the scene's as of each
//! visible effect's, is within what was promised. *Cheapest*: no listed method that costs less reaches the budget there.

#![allow(dead_code, reason = "each program uses its part")]

mod pool;

pub use pool::{Effort, Pool, Pooled, TAU, THETA_DEG};

use rand::Rng;
use std::path::PathBuf;
use stratiform_advise::{Advice, Budget, Candidate, Channels, Data, advise, candidates, percentile, window};
use stratiform_chart::errors::{ErrorsError, WAVELENGTHS_UM};
use stratiform_methods::{Cloud, MethodError};
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::{OpticsConfig, OpticsError, compute, load_or_compute};
use stratiform_quantities::{Side, SingleScatteringAlbedo};
use stratiform_scene::{Droplets, Effect, Interval, Layer, Scene, SceneError, Sun, View};
use stratiform_stats::{Purpose, key, photon_stream};
use stratiform_transport::TransportError;

/// Fewer points, or suns, make no trial.
const FEWEST: usize = 60;
const FEWEST_SUNS: usize = 2;

/// Why a trial has no verdict.
#[derive(Debug, thiserror::Error)]
pub enum TrialError {
    /// The scene is outside of the data.
    #[error(transparent)]
    Advise(#[from] stratiform_advise::AdviseError),
    /// A method cannot be prepared.
    #[error(transparent)]
    Method(#[from] MethodError),
    /// The list.
    #[error(transparent)]
    List(#[from] ErrorsError),
    /// No droplets.
    #[error(transparent)]
    Optics(#[from] OpticsError),
    /// No truth.
    #[error(transparent)]
    Transport(#[from] TransportError),
    /// No scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

/// Droplets of that effective radius in red, green and blue, from the disk cache if it has them.
///
/// # Errors
/// [`TrialError`].
pub fn clouds(effective_radius_um: f64) -> Result<Vec<Cloud>, TrialError> {
    let config = OpticsConfig {
        droplets: DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um },
        number_density_per_cm3: 300.0,
        wavelengths_um: WAVELENGTHS_UM.to_vec(),
        refractive_index: Default::default(),
        theta_f_deg: 5.0,
        tolerance: Default::default(),
    };
    let folder = std::env::var_os("HOME").map(|home| PathBuf::from(home).join(".cache/stratiform"));
    let made = folder.map_or_else(|| compute(&config), |folder| load_or_compute(&config, &folder))?;
    let omega = SingleScatteringAlbedo::new(1.0).map_err(MethodError::from)?;
    made.into_iter().map(|one| Ok(Cloud::new(one.phase, omega, 5.0, Some(effective_radius_um))?)).collect()
}

/// What came of a scene.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The scene.
    pub scene: Scene,
    /// What was advised.
    pub advice: Advice,
    /// The error that was reached.
    pub reached: f64,
    /// Cheaper methods that reach the budget, with their errors.
    pub cheaper: Vec<(String, f64)>,
    /// Points with a truth.
    pub points: usize,
}

impl Trial {
    /// Whether the promise was kept.
    pub fn held(&self) -> bool {
        self.reached <= self.advice.prediction.error
    }

    /// Whether nothing cheaper would have done.
    pub fn cheapest(&self) -> bool {
        self.cheaper.is_empty()
    }
}

/// Scene number `index` of `seed`, the first with points enough; r_e runs over a range that holds the pool's, or is that.
pub fn random_scene(seed: u64, index: u64, pool: &Pool, spread: bool) -> Scene {
    let mut stream = photon_stream(key(seed, Purpose::Calibration), index);
    let mut share = || f64::from(stream.next_u32()) / 4_294_967_296.0;
    loop {
        let scene = any_scene(&mut share, pool, spread, format!("Random scene {index} of seed {seed}"));
        let seen = inside(&scene, pool);
        let mut suns: Vec<f64> = seen.iter().map(|one| one.ask.theta_l_deg).collect();
        suns.dedup();
        if seen.len() >= FEWEST && suns.len() >= FEWEST_SUNS {
            return scene;
        }
    }
}

fn any_scene(share: &mut impl FnMut() -> f64, pool: &Pool, spread: bool, title: String) -> Scene {
    let mut range = |low: f64, high: f64| {
        let (a, b) = (low + (high - low) * share(), low + (high - low) * share());
        Interval { min: a.min(b), max: a.max(b) }
    };
    let logs = range(libm::log(TAU.min), libm::log(TAU.max));
    let (sun, view) = (range(THETA_DEG.min, THETA_DEG.max), range(THETA_DEG.min, THETA_DEG.max));
    let (azimuth, widths) = (range(0.0, 180.0), range(0.0, 1.0));
    let sides = [vec![Side::Top], vec![Side::Bottom], Side::BOTH.to_vec()];
    let sides = sides[(3.0 * share()) as usize].clone();
    let effects = [Effect::Glory, Effect::Fogbow, Effect::SilverLining];
    let visible = effects.into_iter().filter(|_| share() < 0.25).collect();
    let radius = pool.effective_radius_um;
    let radii =
        Interval { min: radius - widths.min * (radius - 4.0), max: radius + widths.max * (20.0 - radius) };
    let wavelengths_um = if pool.waves.len() > 1 { WAVELENGTHS_UM.to_vec() } else { vec![WAVELENGTHS_UM[1]] };
    Scene {
        schema: Scene::SCHEMA.to_owned(),
        title,
        wavelengths_um,
        visible,
        layer: Layer {
            optical_thickness: Some(Interval { min: libm::exp(logs.min), max: libm::exp(logs.max) }),
            thickness_m: None,
            extinction_convention: None,
        },
        droplets: Droplets {
            effective_radius_um: if spread { radii } else { Interval { min: radius, max: radius } },
            effective_variance: 0.25,
            theta_f_deg: 5.0,
            number_density_per_cm3: None,
            single_scattering_albedo: SingleScatteringAlbedo::new(1.0).ok(),
        },
        sun: Sun::at(sun),
        view: View { theta_deg: view, azimuth_deg: azimuth, sides },
        ground: None,
        camera: None,
        clouds: None,
        sky: Default::default(),
        picture: Default::default(),
        radiosity: Default::default(),
    }
}

/// A budget between 2 % and 40 %, even in its logarithm.
pub fn random_error(seed: u64, index: u64) -> f64 {
    let mut stream = photon_stream(key(seed ^ 0xb0d6e7, Purpose::Calibration), index);
    0.02 * libm::pow(20.0, f64::from(stream.next_u32()) / 4_294_967_296.0)
}

/// Tries the advice for `scene` and `max_error` at the points of `pool` in it.
///
/// # Errors
/// [`TrialError`].
pub fn trial(data: &Data, scene: &Scene, max_error: f64, pool: &Pool) -> Result<Trial, TrialError> {
    let tau = scene.layer.optical_thickness.unwrap_or(TAU);
    let budget = Budget::new(Some(max_error), None)?;
    let advice = advise(data, scene, tau, &budget, None)?;
    let all = candidates(data, scene, tau)?;
    let populations = populations(scene, pool);
    let chosen = all.iter().find(|one| one.method.name == advice.method && one.channels == advice.channels);
    let error = chosen.map_or(f64::INFINITY, |one| reached(one, &populations));
    let cheaper = all.iter().filter(|one| !advice.met || chosen.is_none_or(|chosen| one.ns < chosen.ns));
    let with_error = cheaper.map(|one| (one.method.name.clone(), reached(one, &populations)));
    let cheaper = with_error.filter(|(_, error)| *error <= max_error).collect();
    let points = populations.iter().map(Vec::len).sum();
    Ok(Trial { scene: scene.clone(), advice, reached: error, cheaper, points })
}

/// The points of `pool` in the scene's ranges.
fn inside<'a>(scene: &Scene, pool: &'a Pool) -> Vec<&'a Pooled> {
    let view = &scene.view;
    let tau = scene.layer.optical_thickness.unwrap_or(TAU);
    let seen = |one: &&Pooled| {
        tau.contains(one.ask.tau)
            && scene.sun.theta_deg.contains(one.ask.theta_l_deg)
            && view.theta_deg.contains(one.ask.theta_v_deg)
            && view.azimuth_deg.contains(one.ask.phi_deg)
            && view.sides.contains(&one.ask.side)
    };
    pool.points.iter().filter(seen).collect()
}

/// The scene's points, then those of each effect that it shows at points enough.
fn populations<'a>(scene: &Scene, pool: &'a Pool) -> Vec<Vec<&'a Pooled>> {
    let all = inside(scene, pool);
    let windows = scene.visible.iter().filter_map(|effect| window(*effect));
    let effects = windows.map(|(_, side, range)| {
        let seen = |one: &&Pooled| one.ask.side == side && range.contains(one.ask.scattering_deg);
        all.iter().copied().filter(seen).collect::<Vec<_>>()
    });
    let effects: Vec<_> = effects.filter(|seen| seen.len() >= FEWEST / 2).collect();
    std::iter::once(all.clone()).chain(effects).collect()
}

/// 95th percentile of the worst channel's error, the largest of any population; a refusal is an error beyond any budget.
fn reached(one: &Candidate, populations: &[Vec<&Pooled>]) -> f64 {
    let size = |pooled: &&Pooled| {
        let value = pooled.values.get(&one.method.name).copied().unwrap_or(f64::INFINITY);
        let (all, middle) = (&pooled.truths, pooled.truths.len() / 2);
        let counted = if one.channels == Channels::Grey { &all[..] } else { &all[middle..=middle] };
        counted.iter().map(|truth| (value / truth - 1.0).abs()).fold(0.0, f64::max)
    };
    let of =
        |population: &Vec<&Pooled>| percentile(&mut population.iter().map(size).collect::<Vec<_>>(), 0.95);
    populations.iter().map(of).fold(0.0, f64::max)
}
