//! The paper's cloud at 30 wavelengths on one and two threads; sixteen spheres at once against one alone; and `scatrs` on
//! the same angles, with the error of both against a finer average.
//!
//! `cargo bench -p stratiform-optics --bench spectrum [-- FOLDER]`: into FOLDER go the spheres, angles and phase functions
//! that `scripts/compare-mie.py` has miepython repeat.
#![expect(clippy::print_stdout, clippy::unwrap_used, reason = "a benchmark prints figures and may stop")]

use num_complex::Complex64;
use scatrs::ensemble::EnsembleOptions;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::ffi::OsString;
use std::fmt::Write;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;
use stratiform_optics::droplets::{DropletDistribution, SizeDistribution};
use stratiform_optics::ensemble::{
    Ensemble, EnsembleSpec, QuadratureTolerance, ensemble, radius_rule, refine,
};
use stratiform_optics::mie::{
    Coefficients, LANES, LaneCoefficients, RefractiveIndex, ScatteringAngle, SizeParameter, amplitudes,
    efficiencies,
};
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_optics::water::WaterTable;

/// Compared with other codes: one that scatters only, one that absorbs, one in between.
const COMPARED_UM: [f64; 3] = [0.55, 1.6, 2.2];

fn spec(droplets: &SizeDistribution, wavelength_um: f64, tolerance: QuadratureTolerance) -> EnsembleSpec<'_> {
    EnsembleSpec {
        droplets,
        number_density_per_cm3: 300.0,
        wavelength_um,
        refractive_index: WaterTable::HaleQuerry1973.at(wavelength_um).unwrap(),
        theta_f_deg: 5.0,
        tolerance,
    }
}

/// What a piece of work took.
struct Taken {
    wall: f64,
    /// Of all threads together; on a busy machine the better measure. 0 where the system does not tell.
    processor: f64,
}

impl std::fmt::Display for Taken {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.3} s ({:.3} s of processors)", self.wall, self.processor)
    }
}

fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> (Taken, T) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let (start, before) = (Instant::now(), processor_seconds());
        let result = work();
        let run = |(thread, after): (&OsString, &f64)| after - before.get(thread).unwrap_or(&0.0);
        let processor = processor_seconds().iter().map(run).sum();
        (Taken { wall: start.elapsed().as_secs_f64(), processor }, result)
    })
}

/// Seconds that each thread now alive has run (Linux).
fn processor_seconds() -> BTreeMap<OsString, f64> {
    let threads = std::fs::read_dir("/proc/self/task").into_iter().flatten().flatten();
    let seconds = |text: String| Some(1e-9 * text.split(' ').next()?.parse::<f64>().ok()?);
    let of_thread = |thread: std::fs::DirEntry| {
        let text = std::fs::read_to_string(thread.path().join("schedstat")).ok()?;
        Some((thread.file_name(), seconds(text)?))
    };
    threads.filter_map(of_thread).collect()
}

/// The least of `repeats` runs.
fn least_seconds(repeats: usize, mut work: impl FnMut()) -> f64 {
    let timed = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..repeats).map(timed).fold(f64::INFINITY, f64::min)
}

/// 0.35 to 2.5 µm, equally spaced.
fn wavelengths() -> Vec<f64> {
    (0..30).map(|i| 0.35 + 2.15 * f64::from(i) / 29.0).collect()
}

fn spectrum(droplets: &SizeDistribution) {
    use rayon::prelude::*;
    let one = |w: &f64| ensemble(&spec(droplets, *w, QuadratureTolerance::default())).unwrap();
    for threads in [1, 2] {
        let (taken, all) =
            with_threads(threads, || wavelengths().par_iter().map(one).collect::<Vec<Ensemble>>());
        let angles: usize = all.iter().map(|one| one.phase.values().len()).sum();
        let radii: u64 = all.iter().map(|one| one.reached.radii + 1).sum();
        let most = |of: fn(&Ensemble) -> f64| all.iter().map(of).fold(0.0, f64::max);
        println!(
            "30 wavelengths, {angles} angles and {radii} spheres in all, threads {threads}: {taken}; \
             reached g {:.1e}, P {:.1e} below 60 deg, {:.1e} beyond",
            most(|one| one.reached.asymmetry),
            most(|one| one.reached.phase_below_60_deg),
            most(|one| one.reached.phase_beyond_60_deg)
        );
    }
}

/// Nanoseconds per sphere and per sphere and angle, sixteen lanes against one sphere after the other.
fn lanes_against_one(droplets: &SizeDistribution, wavelength_um: f64) {
    let [n, k] = WaterTable::HaleQuerry1973.at(wavelength_um).unwrap();
    let m = RefractiveIndex::new(n, k).unwrap();
    let rule = radius_rule(droplets, 511).unwrap();
    let x: Vec<SizeParameter> =
        rule.iter().map(|(r, _)| SizeParameter::new(2.0 * PI * r / wavelength_um).unwrap()).collect();
    let alone = least_seconds(20, || {
        for &x in &x {
            black_box(efficiencies(x, &Coefficients::new(x, m)));
        }
    });
    let together = least_seconds(20, || {
        for x in x.as_chunks().0 {
            black_box(LaneCoefficients::new(x, m).efficiencies());
        }
    });
    let per_sphere = 1e9 / x.len() as f64;
    println!(
        "{wavelength_um} um, coefficients and efficiencies, ns per sphere: one alone {:.0}, {LANES} lanes {:.0}, ratio {:.1}",
        per_sphere * alone,
        per_sphere * together,
        alone / together
    );
    let loose = QuadratureTolerance {
        asymmetry: 1.0,
        forward_fraction: 1.0,
        moments: 1.0,
        phase_below_60_deg: 1.0,
        phase_beyond_60_deg: 1.0,
        ..QuadratureTolerance::default()
    };
    let mut whole = ensemble(&spec(droplets, wavelength_um, loose)).unwrap();
    let blocked = least_seconds(10, || {
        whole = with_threads(1, || ensemble(&spec(droplets, wavelength_um, loose)).unwrap()).1;
    });
    let angles: Vec<ScatteringAngle> =
        whole.phase.theta_deg().iter().map(|t| ScatteringAngle::from_degrees(*t).unwrap()).collect();
    let some: Vec<Coefficients> = x.iter().step_by(16).map(|&x| Coefficients::new(x, m)).collect();
    let plain = least_seconds(3, || {
        for one in &some {
            black_box(angles.iter().map(|&angle| amplitudes(one, angle).intensity()).sum::<f64>());
        }
    });
    let pairs = |spheres: usize| 1e9 / (spheres * angles.len()) as f64;
    let (plain, blocked) = (pairs(some.len()) * plain, pairs(whole.reached.radii as usize + 1) * blocked);
    println!(
        "{wavelength_um} um, ns per sphere and angle: one alone {plain:.0}, the average (everything counted) {blocked:.1}, \
         ratio {:.0}",
        plain / blocked
    );
}

/// Largest relative difference of P on [from, to) degrees.
fn difference(a: &PhaseTable, b: &PhaseTable, from: f64, to: f64) -> f64 {
    let pairs = a.theta_deg().iter().zip(a.values().iter().zip(b.values()));
    let inside = pairs.filter(|(theta, _)| (from..to).contains(*theta));
    inside.map(|(_, (a, b))| (a / b - 1.0).abs()).fold(0.0, f64::max)
}

/// P of sixteen times the radii.
fn truth(droplets: &SizeDistribution, wavelength_um: f64, radii: u64) -> PhaseTable {
    let tolerance = QuadratureTolerance { asymmetry: 1e-9, most_radii: 16 * radii, ..Default::default() };
    let mut finest = None;
    assert!(
        refine(&spec(droplets, wavelength_um, tolerance), |_, phase| finest = Some(phase.clone())).is_err()
    );
    finest.unwrap()
}

/// P at the angles of `like` by `scatrs`, relative tolerance `rtol`.
fn scatrs_phase(wavelength_um: f64, like: &PhaseTable, rtol: f64) -> PhaseTable {
    let law = scatrs::ensemble::SizeDistribution::Gamma { effective_radius: 7.0, effective_variance: 0.25 };
    let mu = like.theta_rad().iter().map(|theta| libm::cos(*theta)).collect();
    let options = EnsembleOptions::new().with_rtol(rtol).with_mu(mu).with_max_panels(2048);
    let [n, k] = WaterTable::HaleQuerry1973.at(wavelength_um).unwrap();
    let result = scatrs::ensemble::compute(&law, &[wavelength_um], &[Complex64::new(n, k)], &options);
    let p = result.unwrap()[0].values.phase.clone().unwrap().f11;
    PhaseTable::new(like.theta_deg().to_vec(), p, Norm::Any).unwrap()
}

/// Seconds on one thread and true errors of this code and `scatrs`.
fn side_by_side(droplets: &SizeDistribution, folder: Option<&Path>) {
    println!("code,wavelength_um,radii,angles,seconds,processor_seconds,p_below_60,p_beyond_60");
    for wavelength_um in COMPARED_UM {
        let default = spec(droplets, wavelength_um, QuadratureTolerance::default());
        let (taken, ours) = with_threads(1, || ensemble(&default).unwrap());
        let truth = truth(droplets, wavelength_um, ours.reached.radii);
        let row = |code: &str, radii: &str, taken: &Taken, phase: &PhaseTable| {
            let [below, beyond] =
                [(0.0, 60.0), (60.0, 181.0)].map(|(from, to)| difference(phase, &truth, from, to));
            let angles = phase.values().len();
            let Taken { wall, processor } = taken;
            println!(
                "{code},{wavelength_um},{radii},{angles},{wall:.4},{processor:.4},{below:.1e},{beyond:.1e}"
            );
        };
        row("stratiform", &(ours.reached.radii + 1).to_string(), &taken, &ours.phase);
        for rtol in [1e-1, 1e-2, 1e-3] {
            let (taken, phase) = with_threads(1, || scatrs_phase(wavelength_um, &truth, rtol));
            row(&format!("scatrs rtol {rtol:e}"), "", &taken, &phase);
        }
        if let Some(folder) = folder {
            write_spheres(droplets, &ours, folder);
        }
    }
}

/// `m-W.csv` (n,k), `spheres-W.csv` (x, weight), `phase-W.csv` (theta_deg, p) of wavelength W.
fn write_spheres(droplets: &SizeDistribution, one: &Ensemble, folder: &Path) {
    let (w, [n, k]) = (one.wavelength_um, one.refractive_index);
    std::fs::create_dir_all(folder).unwrap();
    std::fs::write(folder.join(format!("m-{w}.csv")), format!("n,k\n{n},{k}\n")).unwrap();
    let mut spheres = String::from("x,weight\n");
    for (radius, weight) in radius_rule(droplets, one.reached.radii as usize).unwrap() {
        writeln!(spheres, "{},{weight}", 2.0 * PI / w * radius).unwrap();
    }
    std::fs::write(folder.join(format!("spheres-{w}.csv")), spheres).unwrap();
    let mut phase = String::from("theta_deg,p\n");
    for (theta, p) in one.phase.theta_deg().iter().zip(one.phase.values()) {
        writeln!(phase, "{theta},{p}").unwrap();
    }
    std::fs::write(folder.join(format!("phase-{w}.csv")), phase).unwrap();
}

fn main() {
    let folder = std::env::args().skip(1).find(|word| !word.starts_with("--"));
    let cloud = DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 };
    let droplets = cloud.resolve().unwrap();
    spectrum(&droplets);
    COMPARED_UM.iter().for_each(|w| lanes_against_one(&droplets, *w));
    side_by_side(&droplets, folder.as_deref().map(Path::new));
}
