//! References made from the model itself, with whatever is added to it.
#![allow(dead_code, clippy::unwrap_used, reason = "support of tests, each of which uses a part")]

use rand::Rng;
use stratiform_artifact::{MediumRecord, ParametersDocument, Provenance, RowIncidence};
use stratiform_fit::{FitConfig, FitError, ParameterBounds, Reference, ThicknessGrid, fit};
use stratiform_model::{Form, Parameters, Thickness, Values};
use stratiform_quantities::{ExtinctionConvention, Incidence};
use stratiform_stats::{Purpose, key, photon_stream};

pub const KAPPA: f64 = 0.04618;

pub fn medium() -> MediumRecord {
    MediumRecord {
        wavelength_um: 0.55,
        extinction_convention: ExtinctionConvention::Paper,
        extinction_per_m: KAPPA,
        single_scattering_albedo: 1.0,
        asymmetry: 0.853,
        theta_f_deg: 5.0,
        forward_fraction: 0.455,
    }
}

pub fn config(angles: &[f64]) -> FitConfig {
    FitConfig {
        theta_l_deg: angles.to_vec(),
        thickness_m: ThicknessGrid::default(),
        shared_beta_up_to_deg: 80.0,
        bounds: ParameterBounds::default(),
    }
}

/// Truth per unit of optical thickness; β = 0.92 in each.
pub fn truth(b: f64, c: f64, kappa_c: f64, t: f64, r: f64) -> Values<f64> {
    Values { beta: 0.92, b, c, kappa_c, t, r, kappa_s: 0.545 }
}

/// Six rows like those of the published table: 0, 30, 60, 80, 90 degrees and diffuse.
pub const ANGLES: [f64; 5] = [0.0, 30.0, 60.0, 80.0, 90.0];

pub fn truths() -> Vec<Values<f64>> {
    vec![
        truth(1.18, 0.3, 0.57, 0.84, 0.055),
        truth(1.10, 0.2, 0.64, 0.82, 0.056),
        truth(0.80, 0.45, 1.02, 0.75, 0.098),
        truth(0.50, 0.6, 1.50, 0.71, 0.355),
        truth(0.30, 1.7, 1.80, 0.10, 0.950),
        truth(0.90, 0.5, 0.80, 0.80, 0.100),
    ]
}

pub fn incidences(angles: &[f64]) -> Vec<RowIncidence> {
    let degrees = angles.iter().map(|a| RowIncidence::Degrees(*a));
    degrees.chain([RowIncidence::diffuse()]).collect()
}

/// How far a flux may move without leaving [0, 1].
fn room(flux: f64) -> f64 {
    flux * (1.0 - flux)
}

/// The model's own fluxes f with a smooth misfit of this amplitude times f(1-f), and standard errors of
/// `spread` times that, a third of whose variance is common to all thicknesses.
pub fn reference(incidence: RowIncidence, values: &Values<f64>, misfit: f64, spread: f64) -> Reference {
    let tau: Vec<f64> = ThicknessGrid::default().metres().iter().map(|h| h * KAPPA).collect();
    let parameters = Parameters::new(values, Incidence::Diffuse).unwrap();
    let fluxes: Vec<_> =
        tau.iter().map(|h| parameters.fluxes(Form::Corrected, Thickness::new(*h).unwrap())).collect();
    let bent = |k: usize, f: f64, phase: f64| f + misfit * room(f) * libm::sin(0.5 * k as f64 + phase);
    let curve =
        |of: &dyn Fn(usize) -> f64, phase: f64| (0..tau.len()).map(|k| bent(k, of(k), phase)).collect();
    let t_ms: Vec<f64> = curve(&|k| fluxes[k].t_ms, 0.0);
    let orders: [Vec<f64>; 4] = [
        curve(&|k| fluxes[k].t_1, 1.0),
        curve(&|k| fluxes[k].t_2, 2.0),
        curve(&|k| fluxes[k].r_1, 3.0),
        curve(&|k| fluxes[k].r_2, 4.0),
    ];
    let (t_ms_covariance, orders_covariance) =
        (covariance(&t_ms, spread), covariance(&orders.concat(), spread));
    Reference { incidence, tau, t_ms, t_ms_covariance, orders, orders_covariance }
}

fn covariance(values: &[f64], spread: f64) -> Vec<f64> {
    let share = |i: usize, j: usize| if i == j { 1.0 } else { 1.0 / 3.0 };
    let n = values.len();
    let at = |i: usize, j: usize| spread * spread * share(i, j) * room(values[i]) * room(values[j]);
    (0..n * n).map(|k| at(k / n, k % n)).collect()
}

pub fn references(misfit: f64, spread: f64) -> Vec<Reference> {
    let rows = incidences(&ANGLES).into_iter().zip(truths());
    rows.map(|(incidence, values)| reference(incidence, &values, misfit, spread)).collect()
}

/// `reference` with noise drawn from its own covariance.
pub fn noisy(reference: &Reference, spread: f64, seed: u64) -> Reference {
    let mut rng = photon_stream(key(seed, Purpose::Calibration), 0);
    let mut normal = || (0..12).map(|_| f64::from(rng.next_u32()) / 4_294_967_296.0).sum::<f64>() - 6.0;
    let mut disturb = |curves: &mut [Vec<f64>]| {
        let common = normal() * (1.0_f64 / 3.0).sqrt();
        for value in curves.iter_mut().flatten() {
            *value += spread * room(*value) * (common + normal() * (2.0_f64 / 3.0).sqrt());
        }
    };
    let mut out = reference.clone();
    let mut total = [std::mem::take(&mut out.t_ms)];
    disturb(&mut total);
    [out.t_ms] = total;
    disturb(&mut out.orders);
    out
}

pub fn run(config: &FitConfig, references: &[Reference]) -> Result<ParametersDocument, FitError> {
    fit(config, references, medium(), Provenance::new("0".repeat(32), None, "synthetic"))
}
