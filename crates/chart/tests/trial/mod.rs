//! Whether advice holds: random scenes, random points in them that are no nodes of the data, truth by the solver.
//!
//! A [`Trial`] has two verdicts. *Held*: the 95th percentile of the advised method's error at the points, of the scene's as of each
//! visible effect's, is within what was promised. *Cheapest*: no listed method that costs less reaches the budget there.

#![allow(dead_code, reason = "each program uses its part")]

use rand::Rng;
use std::path::PathBuf;
use stratiform_advise::{
    Advice, Ask, Budget, Candidate, Channels, Data, advise, candidates, percentile, window,
};
use stratiform_chart::errors::{ErrorsError, Listed, WAVELENGTHS_UM, listed};
use stratiform_methods::{Cloud, MethodError, Point};
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::{OpticsConfig, OpticsError, compute, load_or_compute};
use stratiform_quantities::{Side, SingleScatteringAlbedo};
use stratiform_scene::{Droplets, Effect, Interval, Layer, Scene, Sun, View};
use stratiform_stats::{Purpose, key, photon_stream};
use stratiform_transport::TransportError;
use stratiform_transport::solve::{self, RadianceOrder, RadianceSolver, SolveMedium};

/// Asked of the truth, absolute below 1, relative above; of what is known to 1 % the rest is left out.
const TOLERANCE: f64 = 1e-3;
const SHARE: f64 = 0.01;

/// Views that are tried for one of an effect.
const TRIED: usize = 4000;

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
    /// A listed method is gone.
    #[error("the data list {0}, which is no method any more")]
    Gone(String),
    /// No droplets.
    #[error(transparent)]
    Optics(#[from] OpticsError),
    /// No truth.
    #[error(transparent)]
    Transport(#[from] TransportError),
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

/// A cloud that scenes are tried at.
pub struct Sampled {
    /// r_e.
    pub effective_radius_um: f64,
    /// Red, green, blue; or green alone.
    pub waves: Vec<Cloud>,
    solvers: Vec<RadianceSolver>,
}

impl Sampled {
    /// Ready to be solved.
    ///
    /// # Errors
    /// [`TrialError::Transport`].
    pub fn new(effective_radius_um: f64, waves: Vec<Cloud>) -> Result<Self, TrialError> {
        let solver = |cloud: &Cloud| {
            RadianceSolver::new(SolveMedium::full(cloud.phase().clone(), cloud.omega()), TOLERANCE)
        };
        let solvers = waves.iter().map(solver).collect::<Result<_, _>>()?;
        Ok(Self { effective_radius_um, waves, solvers })
    }

    fn middle(&self) -> usize {
        self.waves.len() / 2
    }
}

/// How many points of each population.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Suns.
    pub suns: usize,
    /// Thicknesses under each.
    pub thicknesses: usize,
    /// Views of each.
    pub views: usize,
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

/// Scene number `index` of `seed`; r_e runs over a range that holds `radius`.
pub fn random_scene(seed: u64, index: u64, radius: f64, spread: bool) -> Scene {
    let mut stream = photon_stream(key(seed, Purpose::Calibration), index);
    let mut share = || f64::from(stream.next_u32()) / 4_294_967_296.0;
    let mut range = |low: f64, high: f64| {
        let (a, b) = (low + (high - low) * share(), low + (high - low) * share());
        Interval { min: a.min(b), max: a.max(b) }
    };
    let logs = range(libm::log(0.1), libm::log(100.0));
    let (sun, view, azimuth) = (range(0.0, 87.0), range(0.0, 87.0), range(0.0, 180.0));
    let widths = range(0.0, 1.0);
    let sides = [vec![Side::Top], vec![Side::Bottom], Side::BOTH.to_vec()];
    let sides = sides[(3.0 * share()) as usize].clone();
    let effects = [Effect::Glory, Effect::Fogbow, Effect::SilverLining];
    let visible = effects.into_iter().filter(|_| share() < 0.25).collect();
    let radii =
        Interval { min: radius - widths.min * (radius - 4.0), max: radius + widths.max * (20.0 - radius) };
    Scene {
        schema: Scene::SCHEMA.to_owned(),
        title: format!("Random scene {index} of seed {seed}"),
        wavelengths_um: vec![0.65, 0.55, 0.45],
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
        sun: Sun { theta_deg: sun },
        view: View { theta_deg: view, azimuth_deg: azimuth, sides },
    }
}

/// A budget between 3 % and 100 %, even in its logarithm.
pub fn random_error(seed: u64, index: u64) -> f64 {
    let mut stream = photon_stream(key(seed ^ 0xb0d6e7, Purpose::Calibration), index);
    libm::pow(0.03, f64::from(stream.next_u32()) / 4_294_967_296.0)
}

/// Tries the advice for `scene` and `max_error` at points of `cloud` that `seed` chooses.
///
/// # Errors
/// [`TrialError`].
pub fn trial(
    data: &Data,
    scene: &Scene,
    max_error: f64,
    cloud: &Sampled,
    seed: u64,
    effort: Effort,
) -> Result<Trial, TrialError> {
    let tau = scene.layer.optical_thickness.unwrap_or(Interval { min: 1.0, max: 1.0 });
    let budget = Budget::new(Some(max_error), None)?;
    let advice = advise(data, scene, tau, &budget, None)?;
    let all = candidates(data, scene, tau)?;
    let methods = listed()?;
    let populations = draw(scene, tau, cloud, seed, effort)?;
    let chosen = all.iter().find(|one| one.method.name == advice.method && one.channels == advice.channels);
    let reached = chosen.map_or(Ok(f64::INFINITY), |one| reached(&methods, one, &populations))?;
    let mut cheaper = Vec::new();
    for one in all.iter().filter(|one| !advice.met || chosen.is_none_or(|chosen| one.ns < chosen.ns)) {
        let error = self::reached(&methods, one, &populations)?;
        if error <= max_error {
            cheaper.push((one.method.name.clone(), error));
        }
    }
    let points = populations.iter().flatten().map(|group| group.truths.len()).sum();
    Ok(Trial { scene: scene.clone(), advice, reached, cheaper, points })
}

/// Points of one cloud and sun with the truth in its wavelengths.
struct Group<'a> {
    cloud: &'a Sampled,
    points: Vec<Point>,
    truths: Vec<Vec<f64>>,
}

/// 95th percentile of the worst channel's error, the largest of any population.
fn reached(methods: &[Listed], one: &Candidate, populations: &[Vec<Group<'_>>]) -> Result<f64, TrialError> {
    let gone = || TrialError::Gone(one.method.name.clone());
    let method = &methods.iter().find(|listed| listed.name == one.method.name).ok_or_else(gone)?.method;
    let mut worst = 0.0_f64;
    for groups in populations {
        let mut sizes = Vec::new();
        for group in groups {
            let middle = group.cloud.middle();
            let grey = one.channels == Channels::Grey;
            let ready = method.prepare(&group.cloud.waves[middle]);
            let values = ready.and_then(|ready| ready.radiances(&group.points));
            for (place, truths) in group.truths.iter().enumerate() {
                // A refusal is an error beyond any budget.
                let value = values.as_ref().map_or(f64::INFINITY, |values| values[place].value);
                let counted = if grey && truths.len() > 1 { &truths[..] } else { &truths[middle..=middle] };
                let sizes_of = counted.iter().map(|truth| (value / truth - 1.0).abs());
                sizes.push(sizes_of.fold(0.0, f64::max));
            }
        }
        worst = worst.max(percentile(&mut sizes, 0.95));
    }
    Ok(worst)
}

/// The scene's points, then those of each effect that it shows.
fn draw<'a>(
    scene: &Scene,
    tau: Interval,
    cloud: &'a Sampled,
    seed: u64,
    effort: Effort,
) -> Result<Vec<Vec<Group<'a>>>, TrialError> {
    let windows = scene.visible.iter().filter_map(|effect| window(*effect));
    let kinds = std::iter::once(None).chain(windows.map(|(_, side, range)| Some((side, range))));
    let mut populations = Vec::new();
    for (kind, which) in kinds.zip(0_u64..) {
        let mut groups = Vec::new();
        for sun in 0..effort.suns as u64 {
            let key = key(seed, Purpose::Calibration).wrapping_add(64 * which + sun);
            groups.extend(solve(cloud, points(scene, tau, kind, key, effort))?);
        }
        if !groups.is_empty() {
            populations.push(groups);
        }
    }
    Ok(populations)
}

/// Thicknesses and views under one sun; no views where the sun shows no effect.
fn points(
    scene: &Scene,
    tau: Interval,
    kind: Option<(Side, Interval)>,
    key: u64,
    effort: Effort,
) -> (Vec<f64>, f64, Vec<Ask>) {
    let mut stream = photon_stream(key, 0);
    let mut share = || f64::from(stream.next_u32()) / 4_294_967_296.0;
    let sun = share();
    let mut ask = |turn| Ask::within(scene, tau, [0.5, share(), sun, share(), share()], turn);
    let thicknesses = (0..effort.thicknesses).map(|_| ask(0).tau).collect();
    let seen =
        |ask: &Ask| kind.is_none_or(|(side, range)| ask.side == side && range.contains(ask.scattering_deg));
    let views: Vec<Ask> = (0..TRIED).map(&mut ask).filter(seen).take(effort.views).collect();
    (thicknesses, ask(0).theta_l_deg, views)
}

fn solve(
    cloud: &Sampled,
    (tau, theta_l, asks): (Vec<f64>, f64, Vec<Ask>),
) -> Result<Option<Group<'_>>, TrialError> {
    if asks.is_empty() {
        return Ok(None);
    }
    let mu = |theta: f64| libm::cos(theta.to_radians());
    let view = |ask: &Ask| solve::View { side: ask.side, mu: mu(ask.theta_v_deg), phi_deg: ask.phi_deg };
    let views: Vec<solve::View> = asks.iter().map(view).collect();
    let total = RadianceOrder::Total;
    let solved = cloud
        .solvers
        .iter()
        .map(|solver| solver.radiance_as_reached(total, &tau, &[mu(theta_l)], &views))
        .collect::<Result<Vec<_>, _>>()?;
    let (mut points, mut truths) = (Vec::new(), Vec::new());
    for (t, tau) in tau.iter().enumerate() {
        for (v, ask) in asks.iter().enumerate() {
            let known: Vec<_> = solved.iter().map(|solved| solved.estimate(t, 0, v, total)).collect();
            if known.iter().all(|truth| truth.value > 0.0 && truth.std_error <= SHARE * truth.value) {
                let (mu_l, mu_v) = (mu(theta_l), mu(ask.theta_v_deg));
                points.push(Point { tau: *tau, mu_l, mu_v, phi_deg: ask.phi_deg, side: ask.side });
                truths.push(known.iter().map(|truth| truth.value).collect());
            }
        }
    }
    Ok(Some(Group { cloud, points, truths }))
}
