//! A second, independent Mie code as the oracle: `scatrs`.

#![expect(clippy::unwrap_used, reason = "a test may stop")]

use num_complex::Complex64;
use scatrs::ensemble::{EnsembleOptions, Outputs, SizeDistribution, compute};
use scatrs::mie::{AmplitudeBuffers, Mie, MieOptions};
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::{Ensemble, EnsembleSpec, QuadratureTolerance, ensemble};
use stratiform_optics::mie::scatter;

const ANGLES: [f64; 7] = [0.0, 3.0, 40.0, 90.0, 137.0, 176.0, 180.0];

fn cosines() -> Vec<f64> {
    ANGLES.iter().map(|t| if *t == 90.0 { 0.0 } else { libm::cos(t.to_radians()) }).collect()
}

/// Relative to the efficiencies and to |S(0)|, 1e-11 up to x = 1e3 and 1e-9 up to 1e5.
#[test]
fn spheres_agree() {
    let mut mie = Mie::<f64>::new();
    for x in [1e-3, 0.02, 0.7, 3.0, 30.0, 457.3, 2e4, 1e5] {
        for (n, k) in [(1.33, 0.0), (1.33, 1e-6), (1.5, 0.1), (0.8, 0.0)] {
            let ours = scatter(x, [n, k], &ANGLES).unwrap();
            let theirs = mie
                .compute(x, Complex64::new(n, k), &MieOptions::new().with_allow_unvalidated(true))
                .unwrap();
            let (mut s1, mut s2) = ([Complex64::default(); 7], [Complex64::default(); 7]);
            theirs.amplitudes(&cosines(), AmplitudeBuffers { s1: &mut s1, s2: &mut s2 }).unwrap();
            let q = theirs.efficiencies();
            let bound = if x < 1e3 { 1e-11 } else { 1e-9 };
            assert!((ours.efficiencies.q_ext / q.q_ext - 1.0).abs() < bound, "{x} {n} {k}");
            assert!((ours.efficiencies.q_sca / q.q_sca - 1.0).abs() < bound, "{x} {n} {k}");
            // g of the smallest spheres is x² small, and holds that many digits less.
            assert!((ours.efficiencies.g - q.g).abs() < bound, "{x} {n} {k}");
            for (i, ours) in ours.amplitudes.iter().enumerate() {
                let off = (ours.s1 - s1[i]).norm_sqr().max((ours.s2 - s2[i]).norm_sqr()).sqrt();
                assert!(off < bound * s1[0].norm_sqr().sqrt(), "{x} {n} {k} {}", ANGLES[i]);
            }
        }
    }
}

/// Droplets that absorb enough to blunt the resonances, so that both codes converge.
const ABSORBING: [f64; 2] = [1.317, 5e-3];
const WAVELENGTH_UM: f64 = 1.6;

fn ours(gamma: f64, effective_radius_um: f64) -> Ensemble {
    let law = DropletDistribution::ModifiedGamma { gamma, effective_radius_um };
    let spec = EnsembleSpec {
        droplets: &law.resolve().unwrap(),
        number_density_per_cm3: 1.0,
        wavelength_um: WAVELENGTH_UM,
        refractive_index: ABSORBING,
        theta_f_deg: 5.0,
        tolerance: QuadratureTolerance {
            asymmetry: 1e-6,
            phase_below_60_deg: 1e-4,
            phase_beyond_60_deg: 1e-4,
            ..QuadratureTolerance::default()
        },
    };
    ensemble(&spec).unwrap()
}

/// The oracle's averages, with P at `theta` radians.
fn theirs(gamma: f64, effective_radius: f64, rtol: f64, theta: &[f64]) -> Outputs {
    let law = SizeDistribution::Gamma { effective_radius, effective_variance: 1.0 / (gamma + 2.0) };
    let mu = theta.iter().map(|theta| libm::cos(*theta)).collect();
    let options = EnsembleOptions::new().with_rtol(rtol).with_mu(mu);
    let index = Complex64::new(ABSORBING[0], ABSORBING[1]);
    compute(&law, &[WAVELENGTH_UM], &[index], &options).unwrap()[0].values.clone()
}

#[test]
fn a_distribution_agrees() {
    let ours = ours(6.0, 3.0);
    // Our nodes nearest to the angles, so that no interpolation enters.
    let nodes: Vec<usize> =
        ANGLES.iter().map(|t| ours.phase.theta_deg().partition_point(|node| node < t)).collect();
    let theta: Vec<f64> = nodes.iter().map(|i| ours.phase.theta_rad()[*i]).collect();
    let theirs = theirs(6.0, 3.0, 1e-7, &theta);
    assert!((ours.extinction.mie / (1e-6 * theirs.c_ext) - 1.0).abs() < 2e-6);
    assert!((ours.single_scattering_albedo - theirs.ssa).abs() < 2e-6);
    assert!((ours.asymmetry - theirs.g).abs() < 2e-6);
    for (i, f11) in nodes.iter().zip(&theirs.phase.unwrap().f11) {
        // The table is divided by its norm, whose interpolation error is below 3e-4.
        let ratio = ours.phase.values()[*i] / f11;
        assert!((ratio - 1.0).abs() < 4e-4, "{}: {ratio}", ours.phase.theta_deg()[*i]);
    }
}

/// Half-way between nodes, where linear interpolation is worst: 1e-3 below 60°, 3e-3 beyond.
#[test]
fn the_angle_grid_keeps_its_promise_between_its_nodes() {
    for (gamma, radius) in [(2.0, 6.0), (6.0, 15.0)] {
        let ours = ours(gamma, radius);
        let middles: Vec<f64> =
            ours.phase.theta_rad().windows(2).step_by(3).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let f11 = theirs(gamma, radius, 1e-6, &middles).phase.unwrap().f11;
        for (theta, f11) in middles.iter().zip(&f11) {
            let off = (ours.phase.at(*theta) / f11 - 1.0).abs();
            let bound = if theta.to_degrees() < 60.0 { 1e-3 } else { 3e-3 };
            assert!(off < bound, "{radius} um at {}: {off:.1e}", theta.to_degrees());
        }
    }
}
