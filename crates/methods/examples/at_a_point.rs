//! Every method at one point of the paper's cloud, beside the solver: `cargo run --example at_a_point -- TAU MU_L MU_V PHI`.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example prints and may stop")]

#[path = "../tests/common/mod.rs"]
mod common;

use stratiform_methods::{FluxPoint, Point, all};
use stratiform_quantities::{Incidence, Side};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, Solver, View};

fn main() {
    let given: Vec<f64> = std::env::args().skip(1).map(|text| text.parse().unwrap()).collect();
    let [tau, mu_l, mu_v, phi_deg] = given.try_into().unwrap_or([10.0, 0.7, 0.7, 90.0]);
    let cloud = common::cloud(1.0);
    let medium = SolveMedium::full(cloud.phase().clone(), cloud.omega());
    let views = Side::BOTH.map(|side| View { side, mu: mu_v, phi_deg });
    let solved =
        RadianceSolver::new(medium.clone(), 1e-4).unwrap().radiance(&[tau], &[mu_l], &views).unwrap();
    let truth = [0, 1].map(|view| solved.estimate(0, 0, view, RadianceOrder::Total).value);
    let beam = Incidence::beam(mu_l).unwrap();
    let (r, t) = Solver::new(medium, 1e-6).unwrap().totals(&[tau], &[beam]).unwrap().total(0, 0);
    println!("tau {tau}, mu_l {mu_l}, mu_v {mu_v}, phi {phi_deg}");
    println!("{:<28} {:>9.5} {:>9.5} {:>9.5} {:>9.5}", "solver", truth[0], truth[1], r.value, t.value);
    for method in all() {
        let ready = method.prepare(&cloud).unwrap();
        let points = Side::BOTH.map(|side| Point { tau, mu_l, mu_v, phi_deg, side });
        let error = |value: f64, truth: f64| format!("{:+8.1}%", 100.0 * (value / truth - 1.0));
        let radiance = ready.radiances(&points).map_or("        -         -".to_owned(), |values| {
            format!("{} {}", error(values[0].value, truth[0]), error(values[1].value, truth[1]))
        });
        let flux =
            ready.fluxes(&[FluxPoint { tau, mu_l }]).map_or("        -         -".to_owned(), |pairs| {
                format!(
                    "{} {}",
                    error(pairs[0].reflectance.value, r.value),
                    error(pairs[0].transmittance.value, t.value)
                )
            });
        println!("{:<28} {radiance} {flux}", method.card().name);
    }
}
