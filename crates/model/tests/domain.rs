//! What is refused, and what is reported.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_model::table::{Angle, ParameterGrid};
use stratiform_model::{Form, ModelError, Parameters, Thickness, Values, problems};
use stratiform_quantities::{Asymmetry, Incidence, OpticalThickness};

const VALUES: Values<f64> =
    Values { beta: 0.9961, b: 0.5043, c: 0.0280, kappa_c: 0.0700, t: 0.7149, r: 0.3554, kappa_s: 0.0252 };

fn refused(values: Values<f64>) -> String {
    Parameters::<f64>::new(&values, Incidence::Diffuse).unwrap_err().to_string()
}

#[test]
fn values_outside_their_domain_are_refused_by_name() {
    assert_eq!(refused(Values { beta: 0.0, ..VALUES }), "beta = 0 is outside (0, 1]");
    assert_eq!(refused(Values { beta: 1.5, ..VALUES }), "beta = 1.5 is outside (0, 1]");
    assert_eq!(refused(Values { b: -0.1, ..VALUES }), "b = -0.1 is outside (0, 100]");
    assert_eq!(refused(Values { c: f64::NAN, ..VALUES }), "c = NaN is outside [0, 1000000]");
    assert_eq!(refused(Values { kappa_c: 0.0, ..VALUES }), "kappa_c = 0 is outside (0, 1000000]");
    assert_eq!(refused(Values { t: 1.01, ..VALUES }), "t = 1.01 is outside [0, 1]");
    assert_eq!(refused(Values { r: -1e-9, ..VALUES }), "r = -0.000000001 is outside [0, 1]");
    assert!(refused(Values { kappa_s: f64::INFINITY, ..VALUES }).starts_with("kappa_s = inf"));
    for thickness in [-1e-300, f64::NAN, f64::INFINITY, 1.1e6] {
        assert!(Thickness::new(thickness).is_err(), "{thickness}");
    }
}

#[test]
fn grazing_light_is_extinguished_at_once_and_never_nan() {
    for mu in [0.0, f64::MIN_POSITIVE, 1e-300, 1e-40, 1e-3] {
        let light = Incidence::beam(mu).unwrap();
        for thickness in [0.0, 1e-30, 1.0, 1e6] {
            let double = Parameters::<f64>::new(&VALUES, light).unwrap();
            let single = Parameters::<f32>::new(&VALUES, light).unwrap();
            let double = double.fluxes(Form::Corrected, Thickness::new(thickness).unwrap());
            let single = single.fluxes(Form::Corrected, Thickness::new(thickness as f32).unwrap());
            assert!(
                double.named().iter().all(|(_, value)| value.is_finite()),
                "{mu} {thickness}: {double:?}"
            );
            assert!(
                single.named().iter().all(|(_, value)| value.is_finite()),
                "{mu} {thickness}: {single:?}"
            );
            if thickness == 0.0 {
                assert_eq!(double.t_0, 1.0);
            } else if mu == 0.0 {
                assert_eq!(double.t_0, 0.0);
            }
        }
    }
}

/// Appendix B at 80 degrees: R_3+ = -0.032 at 8.7 m.
#[test]
fn the_published_tables_negative_tail_is_reported() {
    let light = Incidence::beam(libm::cos(80_f64.to_radians())).unwrap();
    let parameters = Parameters::<f64>::new(&VALUES, light).unwrap();
    let found = problems(&parameters.fluxes(Form::Corrected, Thickness::new(8.7).unwrap()));
    let [tail] = &found[..] else { panic!("{found:?}") };
    assert_eq!(tail.quantity, "r_3_plus");
    assert!((tail.value + 0.032).abs() < 5e-4, "{tail}");
    assert!(tail.to_string().starts_with("r_3_plus = -0.03"));
    let healthy = parameters.fluxes(Form::Corrected, Thickness::new(500.0).unwrap());
    assert!(problems(&healthy).is_empty());
}

#[test]
fn a_transmittance_above_one_is_reported() {
    let values = Values { beta: 1.0, b: 1.5, ..VALUES };
    let parameters = Parameters::<f64>::new(&values, Incidence::Diffuse).unwrap();
    let found = problems(&parameters.fluxes(Form::Corrected, Thickness::new(1e4).unwrap()));
    assert!(found.iter().any(|problem| problem.quantity == "t_ms" && problem.value > 1.0), "{found:?}");
    assert!(found.iter().any(|problem| problem.quantity == "r_ms" && problem.value < 0.0), "{found:?}");
}

fn angle(theta_l_deg: f64, b: f64) -> Angle {
    Angle { theta_l_deg, values: Values { b, ..VALUES } }
}

#[test]
fn the_grid_interpolates_in_the_cosine_and_refuses_disorder() {
    let grid = ParameterGrid::<f64>::new(&[angle(0.0, 0.5), angle(60.0, 1.0), angle(90.0, 2.0)]).unwrap();
    for (mu, b) in [(1.0, 0.5), (0.75, 0.75), (0.5, 1.0), (0.25, 1.5), (0.0, 2.0)] {
        assert!((grid.at(mu).unwrap().values().b - b).abs() < 1e-15, "{mu}");
    }
    let shorter = Angle { theta_l_deg: 90.0, values: Values { kappa_c: 0.21, ..VALUES } };
    let grid = ParameterGrid::<f64>::new(&[angle(0.0, 0.5), shorter]).unwrap();
    let half = 2.0 / (1.0 / 0.07 + 1.0 / 0.21);
    assert!((grid.at(0.5).unwrap().values().kappa_c - half).abs() < 1e-15);
    assert!(matches!(grid.at(1.01), Err(ModelError::Domain(_))));
    let unsorted = ParameterGrid::<f64>::new(&[angle(60.0, 1.0), angle(60.0, 1.0)]);
    assert_eq!(unsorted.unwrap_err(), ModelError::Unsorted { previous: 60.0, next: 60.0 });
    assert!(ParameterGrid::<f64>::new(&[angle(0.0, 1.0), angle(f64::NAN, 1.0)]).is_err());
    assert!(ParameterGrid::<f64>::new(&[angle(0.0, 1.0), angle(91.0, 1.0)]).is_err());
    let endless = Angle { theta_l_deg: 90.0, values: Values { c: 0.0, ..VALUES } };
    let endless = ParameterGrid::<f64>::new(&[angle(0.0, 1.0), endless]).unwrap_err();
    assert_eq!(endless.to_string(), "c = 0 is outside [0.000000000001, 1000000]");
    assert_eq!(ParameterGrid::<f64>::new(&[]).unwrap_err(), ModelError::TooFewRows { rows: 0 });
}

/// b of Appendix B is the escape function in disguise: at 1 km the two forms agree to the table's 13-16 %.
#[test]
fn the_asymptotic_form_is_near_the_table_at_a_kilometre() {
    let tau = OpticalThickness::new(46.18).unwrap();
    let asymptotic = stratiform_model::asymptotic::t_ms(
        Incidence::beam(1.0).unwrap(),
        Asymmetry::new(0.853).unwrap(),
        tau,
    );
    let zenith = Values { b: 1.1796, c: 0.0138, kappa_c: 0.0265, t: 0.8389, r: 0.0547, ..VALUES };
    let table = Parameters::<f64>::new(&zenith, Incidence::beam(1.0).unwrap()).unwrap();
    let table = table.fluxes(Form::Corrected, Thickness::new(1000.0).unwrap()).t_ms;
    assert!((1.10..1.20).contains(&(table / asymptotic)), "{table} {asymptotic}");
}
