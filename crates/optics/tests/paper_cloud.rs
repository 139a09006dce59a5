//! The paper's cloud and Deirmendjian's C1, from droplets to files.
#![expect(clippy::unwrap_used, reason = "a test may stop")]

use std::f64::consts::PI;
use stratiform_optics::OpticsConfig;
use stratiform_optics::phase::{Norm, PhaseFunction, PhaseTable, read_moments};
use stratiform_optics::{compute, load_or_compute, write};
use stratiform_reference_data::rows;

const PAPER: &str = r#"
    number_density_per_cm3 = 300.0
    wavelengths_um = [0.65, 0.55, 0.45]
    refractive_index = "hale-querry-1973"
    theta_f_deg = 5.0
    [droplets]
    distribution = "modified-gamma"
    gamma = 2.0
    effective_radius_um = 7.0
"#;

const C1: &str = r#"
    number_density_per_cm3 = 100.0
    wavelengths_um = [0.70]
    refractive_index = [1.33, 0.0]
    [droplets]
    distribution = "generalised-gamma"
    alpha = 6.0
    b = 1.5
    c = 1.0
"#;

fn config(text: &str) -> OpticsConfig {
    toml::from_str(text).unwrap()
}

/// The example's converged values, to half a unit of the digits given and the quadrature's own error.
#[test]
fn the_papers_cloud_is_the_converged_one() {
    let expected = [
        // g, P_f(5°), share beyond 90°, κ by Mie's extinction
        (0.850, 0.443, 0.042, 0.0371),
        (0.853, 0.455, 0.041, 0.0368),
        (0.857, 0.466, 0.040, 0.0366),
    ];
    for (one, (g, forward, backward, kappa)) in compute(&config(PAPER)).unwrap().iter().zip(expected) {
        assert!((one.asymmetry - g).abs() < 6e-4, "{}", one.asymmetry);
        assert!((one.phase.asymmetry() - one.asymmetry).abs() < 2e-5, "{}", one.phase.asymmetry());
        assert!((one.forward_fraction - forward).abs() < 6e-4, "{}", one.forward_fraction);
        let share = 1.0 - one.phase.cumulative_at(PI / 2.0);
        assert!((share - backward).abs() < 6e-4, "{share}");
        assert!((one.extinction.mie - kappa).abs() < 6e-5, "{:?}", one.extinction);
        assert!((one.extinction.paper - 300e-6 * PI * 49.0).abs() < 1e-15, "{:?}", one.extinction);
        assert!(one.single_scattering_albedo <= 1.0 && one.single_scattering_albedo > 0.99999);
    }
}

/// (1-g)κ and (1-ωP_f)(1-g_S)κ agree to 0.2 %: the cut keeps the transport extinction nearly as it was.
#[test]
fn the_modified_medium_has_nearly_the_same_transport_extinction() {
    for one in compute(&config(PAPER)).unwrap() {
        let modified = one.phase.modified(5.0).unwrap();
        let ratio =
            (1.0 - one.forward_fraction) * (1.0 - modified.asymmetry()) / (1.0 - one.phase.asymmetry());
        assert!(ratio < 1.0 && ratio > 0.996, "{ratio}");
        let cut_directly = 1.0 / (1.0 - one.forward_fraction);
        assert!((modified.at(1.0) / one.phase.at(1.0) / cut_directly - 1.0).abs() < 1e-12);
    }
}

/// Tabulated every degree and integrated linearly in cosΘ, the peak is overrated: norms 1.07/1.09/1.14 and, once
/// normalised, P_f of 0.478/0.501/0.529 - near the 51 % that the paper states.
#[test]
fn a_table_of_one_degree_steps_explains_the_papers_forward_fraction() {
    let expected = [(1.07, 0.478), (1.09, 0.501), (1.14, 0.529)];
    for (one, (norm, forward)) in compute(&config(PAPER)).unwrap().iter().zip(expected) {
        let row = |degrees: u32| {
            let theta = f64::from(degrees).to_radians();
            (libm::cos(theta), one.phase.at(theta))
        };
        let trapezoid = |from: u32, to: u32| {
            (from..to).fold(0.0, |sum, i| {
                let ((mu, p), (next_mu, next_p)) = (row(i), row(i + 1));
                sum + 0.25 * (mu - next_mu) * (p + next_p)
            })
        };
        let (peak, all) = (trapezoid(0, 5), trapezoid(0, 180));
        assert!((all - norm).abs() < 0.01, "{all}");
        assert!((peak / all - forward).abs() < 2e-3, "{}", peak / all);
    }
}

#[test]
fn deirmendjians_c1_is_as_published() {
    let ensembles = compute(&config(C1)).unwrap();
    let one = &ensembles[0];
    assert!((one.asymmetry - 0.848).abs() < 5e-4, "{}", one.asymmetry);
    for (theta, p) in rows::<(f64, f64)>("deirmendjian-c1", "phase.csv").unwrap() {
        let ratio = one.phase.at(theta.to_radians()) / p;
        let bound = if theta < 30.0 { 1e-3 } else { 0.02 };
        assert!((ratio - 1.0).abs() < bound, "{theta}: {ratio}");
    }
}

#[test]
fn files_hold_what_was_computed() {
    let dir = tempfile::tempdir().unwrap();
    let config = config(&C1.replace("0.70", "1.6"));
    let ensembles = load_or_compute(&config, &dir.path().join("cache")).unwrap();
    let document = write(&config, &ensembles, dir.path()).unwrap();
    let one = &document.wavelengths[0];
    let read = PhaseTable::read(&dir.path().join(&one.phase_csv), Norm::Strict).unwrap();
    assert_eq!(read, ensembles[0].phase);
    let modified = PhaseTable::read(&dir.path().join(&one.modified_phase_csv), Norm::Strict).unwrap();
    assert_eq!(modified, ensembles[0].phase.modified(5.0).unwrap());
    let moments = read_moments(&dir.path().join(&one.moments_csv)).unwrap();
    assert!((moments[1] - one.asymmetry).abs() < 2e-4);

    let entry = std::fs::read_dir(dir.path().join("cache")).unwrap().next().unwrap().unwrap().path();
    assert_eq!(load_or_compute(&config, &dir.path().join("cache")).unwrap(), ensembles);
    let intact = std::fs::read_to_string(&entry).unwrap();
    std::fs::write(&entry, intact.replacen("0.9", "0.8", 1)).unwrap();
    assert_eq!(load_or_compute(&config, &dir.path().join("cache")).unwrap(), ensembles);
    assert_eq!(std::fs::read_to_string(&entry).unwrap(), intact);
}

/// Wavelengths are kept one by one: another list takes those that it shares, in its own order.
#[test]
fn wavelengths_are_cached_one_by_one() {
    let dir = tempfile::tempdir().unwrap();
    let kept = |list: &str| load_or_compute(&config(&C1.replace("0.70", list)), dir.path()).unwrap();
    let entries = || std::fs::read_dir(dir.path()).unwrap().count();
    let first = kept("1.6, 2.0");
    assert_eq!(entries(), 2);
    let second = kept("2.0, 1.8, 1.6");
    assert_eq!(entries(), 3);
    assert_eq!([&second[0], &second[2]], [&first[1], &first[0]]);
    assert_eq!(second, compute(&config(&C1.replace("0.70", "2.0, 1.8, 1.6"))).unwrap());
}

/// A golden, copied from this program's own output: not a proof that the numbers are right (the tests above are), but that they
/// do not change unnoticed, because cached results are handed out for as long as `REVISION` in `config.rs` stays. If this fails
/// on purpose, raise `REVISION` and replace the numbers.
#[test]
fn numbers_change_only_with_the_revision() {
    let config: OpticsConfig = toml::from_str(
        "number_density_per_cm3 = 100.0\nwavelengths_um = [0.55]\n[droplets]\ndistribution = 'modified-gamma'\neffective_radius_um = 2.0\ngamma = 6.0",
    )
    .unwrap();
    let cloud = &compute(&config).unwrap()[0];
    let found = (cloud.asymmetry, cloud.reached.radii, cloud.phase.values()[0]);
    let golden = (0.807_673_147_153_803_2, 2048, 330.631_103_333_008_35);
    assert_eq!(found, golden);
}
