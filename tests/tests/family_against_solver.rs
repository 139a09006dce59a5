//! The accepted family at a radius that is none of its tables', and one table with scaled thickness, against the solver.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::sync::Arc;
use stratiform_artifact::FamilyDocument;
use stratiform_cli::config::Config;
use stratiform_cli::pipeline::accepted;
use stratiform_codegen::parameter_family;
use stratiform_model::family::ParameterFamily;
use stratiform_model::table::cos_degrees;
use stratiform_model::{Form, Thickness};
use stratiform_optics::phase::{Modified, PhaseTable};
use stratiform_quantities::{Incidence, SingleScatteringAlbedo};
use stratiform_tests::root;
use stratiform_transport::TraceMedium;
use stratiform_transport::solve::{SolveMedium, Solver};

/// Between the tables at 10 and 14 µm.
const RADIUS_UM: f64 = 12.0;
const TAU: [f64; 4] = [0.3, 2.0, 8.0, 40.0];
const THETA_DEG: [f64; 4] = [0.0, 30.0, 60.0, 80.0];

fn family() -> (Config, FamilyDocument) {
    let config = Config::load(&root().join("fit-configs/family.toml")).unwrap();
    let kept = root().join("fit-configs").join(&config.codegen.accepted);
    let document = accepted::read_family(&config, &kept).unwrap().unwrap();
    (config, document)
}

/// P at a radius, computed anew.
fn phase(config: &Config, radius_um: f64) -> Arc<PhaseTable> {
    let mut optics = config.optics.clone();
    optics.droplets = optics.droplets.at_effective_radius(radius_um).unwrap();
    let one = stratiform_optics::compute(&optics).unwrap().pop().unwrap();
    Arc::new(one.phase)
}

/// T_ms of the full medium, and T_1 and R_1 of the modified one, at every angle and thickness.
fn solved(phase: &Arc<PhaseTable>, theta_f_deg: f64) -> Vec<[f64; 3]> {
    let omega = SingleScatteringAlbedo::new(1.0).unwrap();
    let modified = Modified::new(phase.clone(), theta_f_deg).unwrap();
    let forward = modified.forward_fraction();
    let full = TraceMedium::full(phase.clone(), omega);
    let modified = TraceMedium::modified(Arc::new(modified), omega, forward).unwrap();
    let lights: Vec<_> =
        THETA_DEG.iter().map(|theta| Incidence::beam(cos_degrees(*theta)).unwrap()).collect();
    let [full, modified] = [full, modified].map(|medium| {
        let solver = Solver::new(SolveMedium::from(&medium), 1e-5).unwrap();
        solver.orders(&TAU, &lights, 2).unwrap()
    });
    let places = (0..THETA_DEG.len()).flat_map(|i| (0..TAU.len()).map(move |k| (i, k)));
    let one = |(i, k)| {
        let (r_1, t_1) = modified.estimate(i, k, 1);
        [full.estimate(i, k, 4).1.value, t_1.value, r_1.value]
    };
    places.map(one).collect()
}

/// The same from the family at `radius_um` with thicknesses multiplied by `scale`.
fn modelled(family: &ParameterFamily<f64>, radius_um: f64, scale: f64) -> Vec<[f64; 3]> {
    let places = THETA_DEG.iter().flat_map(|theta| TAU.iter().map(move |tau| (*theta, *tau)));
    let one = |(theta, tau): (f64, f64)| {
        let parameters = family.at(cos_degrees(theta), radius_um).unwrap();
        let f = parameters.fluxes(Form::Corrected, Thickness::new(tau * scale).unwrap());
        [f.t_ms, f.t_1, f.r_1]
    };
    places.map(one).collect()
}

fn worst(a: &[[f64; 3]], b: &[[f64; 3]]) -> [f64; 3] {
    assert_eq!(a.len(), b.len());
    [0, 1, 2].map(|i| a.iter().zip(b).map(|(a, b)| (a[i] - b[i]).abs()).fold(0.0, f64::max))
}

/// The bounds are those that the fit's own misfit needs (fit-configs/family.toml, `check.model`).
#[test]
fn a_radius_between_the_tables_is_as_good_as_one_of_them() {
    let (config, document) = family();
    let tables = parameter_family::<f64>(&document).unwrap();
    let truth = solved(&phase(&config, RADIUS_UM), config.optics.theta_f_deg);
    let [t_ms, t_1, r_1] = worst(&modelled(&tables, RADIUS_UM, 1.0), &truth);
    assert!(t_ms < 0.015 && t_1 < 0.025 && r_1 < 0.017, "{t_ms} {t_1} {r_1}");
    // The neighbouring radius in its place is seen.
    let [planted, ..] = worst(&modelled(&tables, 5.0, 1.0), &truth);
    assert!(planted > 0.025, "{planted}");
}

/// (1-g)τ makes one table serve for totals within 0.012 of the tables of each radius, and not for single orders.
#[test]
fn scaled_thickness_serves_totals_and_not_orders() {
    let (_, document) = family();
    let tables = parameter_family::<f64>(&document).unwrap();
    let medium = |radius: f64| {
        let one = document.members.iter().find(|one| one.effective_radius_um == radius).unwrap();
        one.parameters.medium.clone()
    };
    let base = medium(7.0);
    for radius in [4.0, 5.0, 10.0, 14.0, 20.0] {
        let scale = (1.0 - medium(radius).asymmetry) / (1.0 - base.asymmetry);
        let wide = (1.0 - medium(radius).forward_fraction) / (1.0 - base.forward_fraction);
        let own = modelled(&tables, radius, 1.0);
        let [t_ms, t_1, _] = worst(&modelled(&tables, 7.0, scale), &own);
        let [unscaled, ..] = worst(&modelled(&tables, 7.0, 1.0), &own);
        let [_, of_wide, _] = worst(&modelled(&tables, 7.0, wide), &own);
        assert!(t_ms < 0.012 && t_ms < 0.5 * unscaled, "{radius}: {t_ms} {unscaled}");
        assert!(of_wide < 0.004 && t_1 > 2.0 * of_wide, "{radius}: {t_1} {of_wide}");
    }
}
