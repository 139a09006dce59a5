//! The analytic derivatives against central differences.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_model::{Fluxes, Form, Parameters, Thickness, Values, derivatives};
use stratiform_quantities::Incidence;

const VALUES: Values<f64> =
    Values { beta: 0.93, b: 0.8, c: 0.13, kappa_c: 0.6, t: 0.77, r: 0.13, kappa_s: 0.54 };

fn fluxes(values: &Values<f64>, h: f64) -> Fluxes<f64> {
    let parameters = Parameters::new(values, Incidence::Diffuse).unwrap();
    parameters.fluxes(Form::Corrected, Thickness::new(h).unwrap())
}

/// Central difference of `flux` by the number that `field` points at.
fn difference(field: fn(&mut Values<f64>) -> &mut f64, h: f64, flux: fn(&Fluxes<f64>) -> f64) -> f64 {
    let step = 1e-5;
    let (mut low, mut high) = (VALUES, VALUES);
    *field(&mut low) -= step;
    *field(&mut high) += step;
    (flux(&fluxes(&high, h)) - flux(&fluxes(&low, h))) / (2.0 * step)
}

#[test]
fn derivatives_equal_central_differences() {
    type Derivative = fn(&Parameters<f64>, Thickness<f64>) -> [f64; 3];
    type Flux = fn(&Fluxes<f64>) -> f64;
    type Field = fn(&mut Values<f64>) -> &mut f64;
    let multiple: [Field; 3] = [|v| &mut v.beta, |v| &mut v.b, |v| &mut v.c];
    let orders: [Field; 3] = [|v| &mut v.kappa_c, |v| &mut v.t, |v| &mut v.r];
    let cases: [(Derivative, Flux, [Field; 3]); 5] = [
        (derivatives::t_ms, |f| f.t_ms, multiple),
        (derivatives::t_1, |f| f.t_1, orders),
        (derivatives::t_2, |f| f.t_2, orders),
        (derivatives::r_1, |f| f.r_1, orders),
        (derivatives::r_2, |f| f.r_2, orders),
    ];
    let parameters = Parameters::new(&VALUES, Incidence::Diffuse).unwrap();
    for h in [0.01, 0.3, 0.9, 2.0, 7.0, 40.0] {
        for (number, (derivative, flux, fields)) in cases.iter().enumerate() {
            let analytic = derivative(&parameters, Thickness::new(h).unwrap());
            for (value, field) in analytic.iter().zip(fields) {
                let numeric = difference(*field, h, *flux);
                let error = (value - numeric).abs();
                assert!(error < 1e-8 * (1.0 + h * h), "case {number}, H = {h}: {value} against {numeric}");
            }
        }
    }
}
