//! Bias of single precision: the same photons traced in f32 and in f64, their counts compared row by row.
//!
//! Prints, per medium, incidence and albedo, the largest |difference of means| over thicknesses and rows, and the largest bound
//! |difference| + 3 standard errors, at least 3 photons of all (no difference seen excludes more at 95 %). A standard error is that of differences of pairs of traces, one per seed.
//!
//! `cargo run --release -p stratiform-transport --example precision_bias -- [PHOTONS] [SEEDS]`

#![expect(clippy::print_stdout, reason = "an example prints its figures")]

use std::error::Error;
use std::sync::Arc;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::{EnsembleSpec, QuadratureTolerance, ensemble};
use stratiform_optics::phase::{HenyeyGreenstein, Isotropic, Modified, PhaseFunction, PhaseTable};
use stratiform_optics::water::WaterTable;
use stratiform_quantities::{Asymmetry, Incidence, Order, SingleScatteringAlbedo};
use stratiform_transport::{
    Control, Instructions, Kernel, Precision, Stop, TraceMedium, TraceRequest, TransportError,
    trace_half_space_with,
};

const TAU: [f64; 10] = [0.05, 0.2, 0.5, 1.0, 3.0, 10.0, 16.0, 30.0, 100.0, 300.0];
const MAX_ORDER: u32 = 3;

/// The paper's cloud at 0.55 µm.
fn cloud() -> Result<PhaseTable, Box<dyn Error>> {
    let spec = EnsembleSpec {
        droplets: &DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 }.resolve()?,
        number_density_per_cm3: 300.0,
        wavelength_um: 0.55,
        refractive_index: WaterTable::HaleQuerry1973.at(0.55)?,
        theta_f_deg: 5.0,
        tolerance: QuadratureTolerance::default(),
    };
    Ok(ensemble(&spec)?.phase)
}

/// Every row's estimate.
fn rows(
    medium: &TraceMedium,
    request: &TraceRequest,
    precision: Precision,
) -> Result<Vec<f64>, TransportError> {
    let kernel = Kernel { precision: Some(precision), instructions: Instructions::Widest };
    let traced = trace_half_space_with(kernel, medium, request, Control::default())?;
    let pair = &|k: usize, order: Order| {
        let (reflectance, transmittance) = traced.estimate(k, order);
        [reflectance.value, transmittance.value]
    };
    Ok((0..TAU.len()).flat_map(|k| Order::rows(MAX_ORDER).flat_map(move |order| pair(k, order))).collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).map(|text| text.parse::<u64>());
    let photons = arguments.next().unwrap_or(Ok(1 << 18))?;
    let seeds = arguments.next().unwrap_or(Ok(8))?;
    let cloud: Arc<dyn PhaseFunction> = Arc::new(cloud()?);
    let phases: [(&str, Arc<dyn PhaseFunction>); 4] = [
        ("isotropic", Arc::new(Isotropic)),
        ("hg 0.85", Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85)?))),
        ("cloud", cloud.clone()),
        ("cloud > 5°", Arc::new(Modified::new(cloud, 5.0)?)),
    ];
    println!("{photons} photons, {seeds} seeds, tau {TAU:?}");
    println!("{:<12}{:>6}{:>9}{:>14}{:>14}{:>14}", "phase", "omega", "mu0", "largest", "its error", "bound");
    for (name, phase) in phases {
        let beams = [1.0, 0.5, 0.1, 0.01].map(|mu0| Incidence::beam(mu0).map(|beam| (1.0, beam)));
        let beams: Vec<_> = beams.into_iter().collect::<Result<_, _>>()?;
        let others = [(1.0, Incidence::Diffuse), (0.9, Incidence::beam(1.0)?), (0.9, Incidence::Diffuse)];
        for (omega, incidence) in beams.into_iter().chain(others) {
            let medium = TraceMedium::full(phase.clone(), SingleScatteringAlbedo::new(omega)?);
            let mut pairs = Vec::new();
            for seed in 0..seeds {
                let stop = Stop::Photons(photons);
                let request = TraceRequest {
                    tau: TAU.to_vec(),
                    incidence,
                    stop,
                    max_order: MAX_ORDER,
                    seed,
                    stream: 0,
                };
                let (single, double) = (
                    rows(&medium, &request, Precision::Single)?,
                    rows(&medium, &request, Precision::Double)?,
                );
                pairs.push(single.iter().zip(&double).map(|(a, b)| a - b).collect::<Vec<f64>>());
            }
            let [largest, error, bound] = summary(&pairs);
            let bound = bound.max(3.0 / (photons * seeds) as f64);
            println!(
                "{name:<12}{omega:>6}{:>9}{largest:>14.1e}{error:>14.1e}{bound:>14.1e}",
                incidence.to_string()
            );
        }
    }
    Ok(())
}

/// Largest mean difference with its standard error, and the largest of |mean| + 3 standard errors.
fn summary(pairs: &[Vec<f64>]) -> [f64; 3] {
    let n = pairs.len() as f64;
    let (mut largest, mut bound) = ([0.0; 2], 0.0_f64);
    for row in 0..pairs[0].len() {
        let mean = pairs.iter().map(|pair| pair[row]).fold(0.0, |a, b| a + b) / n;
        let square = pairs.iter().map(|pair| (pair[row] - mean) * (pair[row] - mean)).fold(0.0, |a, b| a + b);
        let error = (square / (n * (n - 1.0))).sqrt();
        if mean.abs() >= largest[0] {
            largest = [mean.abs(), error];
        }
        bound = bound.max(mean.abs() + 3.0 * error);
    }
    [largest[0], largest[1], bound]
}
