//! A chart of made-up methods, whose errors are known.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::sync::atomic::AtomicBool;
use std::time::Duration;
use stratiform_artifact::ChartRow;
use stratiform_chart::cost::Effort;
use stratiform_chart::grid::{Density, Grid};
use stratiform_chart::truth::Truth;
use stratiform_chart::{CloudSample, Knob, KnobSetting, Sample, Watch, assess, chart, document, knobs};
use stratiform_methods::{
    Card, Class, Cloud, Domain, FluxPair, FluxPoint, Method, MethodError, Point, Ready, Single,
};
use stratiform_model::angular::Sight;
use stratiform_optics::phase::{HenyeyGreenstein, Norm, PhaseFunction, PhaseTable, versine};
use stratiform_quantities::{Asymmetry, Range, SingleScatteringAlbedo};
use stratiform_scene::{Interval, named};
use stratiform_stats::Estimate;

const EFFORT: Effort = Effort { repeat: Duration::from_micros(20), repeats: 3 };

/// A cloud whose phase function needs no Mie theory.
fn cloud() -> Cloud {
    let phase = HenyeyGreenstein::new(Asymmetry::new(0.7).unwrap());
    let theta: Vec<f64> = (0..=720).map(|i| f64::from(i) * 0.25).collect();
    let values = theta.iter().map(|t| phase.value(versine(t.to_radians()))).collect();
    let table = PhaseTable::new(theta, values, Norm::Strict).unwrap();
    Cloud::new(table, SingleScatteringAlbedo::CONSERVATIVE, 5.0, None).unwrap()
}

fn sample() -> Sample {
    let scene = named("thin-veil").unwrap();
    let grid = Grid::new(&scene, Interval { min: 0.5, max: 2.0 }, Density { suns: 2, ..Density::QUICK });
    let cloud = cloud();
    let truth = Truth::solve(&cloud, &grid).unwrap();
    let one = CloudSample { effective_radius_um: 7.0, wavelength_um: 0.55, cloud, grid, truth };
    Sample { name: "made-up".to_owned(), scene, clouds: vec![one] }
}

/// What a made-up method does to the truth.
#[derive(Clone)]
struct Fake {
    card: Card,
    /// Added to 1, times the truth.
    share: f64,
    /// Whether it is shader code.
    shader: bool,
    /// A point at this place is answered by NaN.
    broken: Option<usize>,
    truth: Vec<(Point, f64)>,
    fluxes: Vec<(FluxPoint, FluxPair)>,
}

fn fake(name: &str, sample: &Sample, share: f64) -> Fake {
    let one = &sample.clouds[0];
    let known = one.truth.radiances.iter().map(|truth| truth.map_or(f64::NAN, |truth| truth.value));
    Fake {
        card: Card {
            name: name.to_owned(),
            title: "Made up",
            source: "this test",
            class: Class::Heuristic,
            domain: Domain::EVERYWHERE,
            radiance: true,
            flux: true,
            promises: Default::default(),
            table_bytes: Some(12),
        },
        share,
        shader: true,
        broken: None,
        truth: one.grid.points().into_iter().zip(known).collect(),
        fluxes: one.grid.flux_points().into_iter().enumerate().map(|(i, p)| (p, one.truth.flux(i))).collect(),
    }
}

impl Method for Fake {
    fn card(&self) -> &Card {
        &self.card
    }

    fn prepare(&self, _: &Cloud) -> Result<Box<dyn Ready>, MethodError> {
        Ok(Box::new(self.clone()))
    }
}

impl Ready for Fake {
    fn radiances(&self, points: &[Point]) -> Result<Vec<Estimate>, MethodError> {
        points.iter().for_each(|point| self.card.domain.check(point).unwrap());
        let of = |point: &Point| {
            let place = self.truth.iter().position(|(known, _)| known == point).unwrap();
            let value =
                if self.broken == Some(place) { f64::NAN } else { self.truth[place].1 * (1.0 + self.share) };
            Estimate { value, std_error: 0.0 }
        };
        Ok(points.iter().map(of).collect())
    }

    fn fluxes(&self, points: &[FluxPoint]) -> Result<Vec<FluxPair>, MethodError> {
        let scaled = |e: Estimate| Estimate { value: e.value * (1.0 + self.share), ..e };
        let of = |point: &FluxPoint| {
            let (_, pair) = self.fluxes.iter().find(|(known, _)| known == point).unwrap();
            FluxPair { reflectance: scaled(pair.reflectance), transmittance: scaled(pair.transmittance) }
        };
        Ok(points.iter().map(of).collect())
    }

    fn single(&self) -> Option<&dyn Single> {
        self.shader.then_some(self as &dyn Single)
    }
}

impl Single for Fake {
    fn radiance(&self, tau: f32, sight: &Sight<f32>) -> f32 {
        tau * sight.mu_v
    }

    fn fluxes(&self, tau: f32, mu_l: f32) -> (f32, f32) {
        (tau, mu_l)
    }
}

fn boxed(fake: Fake) -> Box<dyn Method> {
    Box::new(fake)
}

fn rows(sample: &Sample, fakes: Vec<Fake>) -> Vec<ChartRow> {
    let methods: Vec<Box<dyn Method>> = fakes.into_iter().map(boxed).collect();
    chart(sample, &methods, EFFORT, Watch { progress: &|| (), cancel: &AtomicBool::new(false) }).unwrap()
}

#[test]
fn a_planted_error_is_what_the_chart_says() {
    let sample = sample();
    let rows = rows(&sample, vec![fake("low", &sample, -0.2), fake("right:3", &sample, 0.0)]);
    assert_eq!(rows.len(), 8);
    for row in &rows {
        let (bias, error) = if row.method == "low" { (-0.2, 0.2) } else { (0.0, 0.0) };
        assert!(
            (row.bias.unwrap() - bias).abs() < 1e-12 && (row.p95.unwrap() - error).abs() < 1e-12,
            "{row:?}"
        );
        assert!(row.ns_per_evaluation.unwrap() > 0.0 && row.cost == "f32" && row.refused == 0);
    }
    assert_eq!(rows[4].knob.as_deref(), Some("3"));
    let fluxes = rows.iter().find(|row| row.quantity == "reflectance").unwrap();
    assert_eq!(fluxes.points, 4);
}

#[test]
fn refusals_and_broken_answers_are_counted_and_keep_a_method_off_the_front() {
    let sample = sample();
    let mut narrow = fake("narrow", &sample, 0.0);
    narrow.card.domain.tau = Range::closed(0.0, 1.0);
    let mut broken = fake("broken", &sample, 0.0);
    broken.broken = Some(0);
    let rows = rows(&sample, vec![narrow, broken, fake("dull", &sample, 0.5)]);
    let of = |method: &str, quantity: &str| {
        rows.iter().find(|row| row.method == method && row.quantity == quantity).unwrap().clone()
    };
    let top = of("narrow", "radiance_top");
    assert!(top.refused > 0 && top.refused < top.points && !top.pareto && top.worst == Some(0.0), "{top:?}");
    let top = of("broken", "radiance_top");
    assert!(top.not_finite == 1 && top.refused == 0 && !top.pareto, "{top:?}");
    assert!(of("dull", "radiance_top").pareto);
    assert!(of("broken", "radiance_bottom").not_finite == 0);
}

#[test]
fn solvers_are_timed_in_batches_at_the_ends_of_the_ranges() {
    let mut sample = sample();
    let grid =
        Grid::new(&sample.scene, Interval { min: 0.5, max: 2.0 }, Density { suns: 3, ..Density::QUICK });
    sample.clouds[0].truth = Truth::solve(&sample.clouds[0].cloud, &grid).unwrap();
    sample.clouds[0].grid = grid;
    let solver = Fake { shader: false, ..fake("solver", &sample, 0.1) };
    let found = assess(boxed(solver).as_ref(), &sample, EFFORT).unwrap();
    assert!(found.iter().all(|one| !one.single && one.ns.unwrap() > 0.0));
    let all = assess(boxed(fake("shader", &sample, 0.1)).as_ref(), &sample, EFFORT).unwrap();
    let asked = |of: &stratiform_chart::Assessment| of.points + of.excluded;
    let counts: Vec<_> = found.iter().zip(&all).map(|(few, all)| (asked(few), asked(all))).collect();
    // Two of three suns; of eight views the first, fourth and seventh.
    assert_eq!(counts, [(8, 24), (4, 24), (4, 6), (4, 6)]);
}

#[test]
fn the_truth_of_a_grid_is_kept_and_a_damaged_entry_is_solved_again() {
    let folder = tempfile::tempdir().unwrap();
    let sample = sample();
    let CloudSample { cloud, grid, truth, .. } = &sample.clouds[0];
    let again = || Truth::load_or_solve(cloud, grid, Some(folder.path())).unwrap();
    assert_eq!(again(), *truth);
    let file = std::fs::read_dir(folder.path()).unwrap().next().unwrap().unwrap().path();
    let text = std::fs::read_to_string(&file).unwrap();
    assert_eq!(again(), *truth);
    std::fs::write(&file, text.replace("0.0", "0.1")).unwrap();
    assert_eq!(again(), *truth);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
}

/// In a lossless layer R + T = 1, which no part of this crate knows.
#[test]
fn the_truth_conserves_energy_and_knows_its_radiances() {
    let sample = sample();
    let truth = &sample.clouds[0].truth;
    assert!(truth.fluxes.iter().all(|(r, t)| (r.value + t.value - 1.0).abs() < 2e-6));
    assert!(truth.radiances.iter().flatten().count() >= 28 && truth.worst_error() < 0.01, "{truth:?}");
}

#[test]
fn the_manifest_names_everything_and_holds_no_time() {
    let sample = sample();
    let method = boxed(fake("one", &sample, 0.0));
    let document = document(&[sample], &[method], true);
    assert_eq!(
        (document.methods[0].class.as_str(), document.scenes[0].clouds[0].tau.len()),
        ("heuristic", 2)
    );
    let text = stratiform_artifact::to_json(&document).unwrap();
    assert!(!text.contains("_ns") && !text.contains("seconds"));
}

#[test]
fn a_knob_that_turns_towards_the_truth_shows_it() {
    let sample = sample();
    let setting = |setting: f64| KnobSetting { setting, method: boxed(fake("fake", &sample, 1.0 / setting)) };
    let knob = Knob {
        method: "fake".to_owned(),
        knob: "orders".to_owned(),
        settings: [1.0, 4.0].map(setting).into(),
    };
    let rows =
        knobs(&sample, &[knob], EFFORT, Watch { progress: &|| (), cancel: &AtomicBool::new(false) }).unwrap();
    let top: Vec<_> = rows.iter().filter(|row| row.quantity == "radiance_top").collect();
    assert!((top[0].median.unwrap() - 1.0).abs() < 1e-12 && (top[1].median.unwrap() - 0.25).abs() < 1e-12);
    let named = named("thin-veil").unwrap();
    assert_eq!(named, sample.scene);
}

#[test]
fn a_cancelled_sample_says_so() {
    let watch = Watch { progress: &|| (), cancel: &AtomicBool::new(true) };
    let source = stratiform_chart::Source { quick: true, cache: None, watch };
    // The optics come first; a single size keeps them short.
    let mut scene = named("thin-veil").unwrap();
    scene.droplets.effective_radius_um = Interval { min: 0.2, max: 0.2 };
    scene.wavelengths_um = vec![0.55];
    let stopped = Sample::of_scene("a", &scene, &source);
    assert!(matches!(stopped, Err(stratiform_chart::ChartError::Cancelled)));
}
