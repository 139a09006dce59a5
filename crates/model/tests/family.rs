//! Families over r_e: exact at the members, between them elsewhere, refusing what lies outside.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_model::family::{Member, ParameterFamily, RadiusCoordinate};
use stratiform_model::table::Angle;
use stratiform_model::{Form, ModelError, Thickness, Values};

/// A member whose every parameter depends on `x`.
fn member(effective_radius_um: f64, x: f64) -> Member {
    let values = |b: f64| Values {
        beta: 0.9 + 0.05 * x,
        b,
        c: 0.1 * (1.0 + x),
        kappa_c: 0.5 + x,
        t: 0.8 - 0.1 * x,
        r: 0.05 + 0.1 * x,
        kappa_s: 0.6 - 0.1 * x,
    };
    let angle = |theta_l_deg: f64| Angle { theta_l_deg, values: values(1.2 - theta_l_deg / 100.0) };
    Member { effective_radius_um, angles: [0.0, 60.0, 90.0].map(angle).to_vec(), diffuse: values(0.95) }
}

fn family(coordinate: RadiusCoordinate) -> ParameterFamily<f64> {
    ParameterFamily::new(coordinate, &[member(4.0, 0.0), member(7.0, 0.3), member(20.0, 1.0)]).unwrap()
}

fn fluxes(parameters: &stratiform_model::Parameters<f64>) -> [f64; 9] {
    parameters.fluxes(Form::Corrected, Thickness::new(3.0).unwrap()).named().map(|(_, value)| value)
}

#[test]
fn members_are_met_exactly_and_half_way_is_half_way() {
    for coordinate in RadiusCoordinate::ALL {
        let family = family(coordinate);
        for (radius, x) in [(4.0, 0.0), (7.0, 0.3), (20.0, 1.0)] {
            let own = ParameterFamily::new(coordinate, &[member(radius, x), member(30.0, x)]).unwrap();
            for mu in [1.0, 0.7, 0.25, 0.0] {
                let (there, alone) = (family.at(mu, radius).unwrap(), own.at(mu, radius).unwrap());
                for (a, b) in fluxes(&there).iter().zip(fluxes(&alone)) {
                    assert!((a - b).abs() < 1e-14, "{coordinate} {radius} {mu}: {a} {b}");
                }
            }
        }
    }
    let half = family(RadiusCoordinate::Logarithm).at(0.5, (4.0_f64 * 7.0).sqrt()).unwrap();
    assert!((half.values().t - (0.8 - 0.1 * 0.15)).abs() < 1e-14);
    assert!((half.values().kappa_s - (0.6 - 0.1 * 0.15)).abs() < 1e-14);
    assert!((half.values().r - 2.0 / (1.0 / 0.05 + 1.0 / 0.08)).abs() < 1e-14);
    assert!((half.values().beta - 2.0 / (1.0 / 0.9 + 1.0 / 0.915)).abs() < 1e-14);
    let diffuse = family(RadiusCoordinate::Reciprocal).diffuse(2.0 / (1.0 / 7.0 + 1.0 / 20.0)).unwrap();
    assert!((diffuse.values().t - (0.8 - 0.1 * 0.65)).abs() < 1e-14);
}

#[test]
fn single_precision_follows_double() {
    let double = family(RadiusCoordinate::Logarithm);
    let members = [member(4.0, 0.0), member(7.0, 0.3), member(20.0, 1.0)];
    let single = ParameterFamily::<f32>::new(RadiusCoordinate::Logarithm, &members).unwrap();
    for radius in [4.0_f32, 5.5, 7.0, 13.0, 20.0] {
        let (one, two) =
            (single.at(0.4, radius).unwrap(), double.at(f64::from(0.4_f32), radius.into()).unwrap());
        let pairs = [(one.values().b, two.values().b), (one.values().kappa_c, two.values().kappa_c)];
        for (a, b) in pairs {
            assert!((f64::from(a) / b - 1.0).abs() < 3e-6, "{radius}: {a} {b}");
        }
    }
}

#[test]
fn what_lies_outside_is_refused() {
    let family = family(RadiusCoordinate::Logarithm);
    for radius in [3.99, 20.01, f64::NAN, f64::INFINITY, 0.0, -1.0] {
        assert!(matches!(family.at(0.5, radius), Err(ModelError::Domain(_))), "{radius}");
        assert!(family.diffuse(radius).is_err());
    }
    assert!(family.at(1.1, 5.0).is_err() && family.at(f64::NAN, 5.0).is_err());
    let refused =
        |members: &[Member]| ParameterFamily::<f64>::new(RadiusCoordinate::Logarithm, members).unwrap_err();
    assert_eq!(refused(&[member(4.0, 0.0)]), ModelError::TooFewRadii { radii: 1 });
    assert_eq!(
        refused(&[member(7.0, 0.0), member(4.0, 0.0)]),
        ModelError::UnsortedRadii { previous: 7.0, next: 4.0 }
    );
    assert!(matches!(refused(&[member(4.0, 0.0), member(f64::NAN, 0.0)]), ModelError::UnsortedRadii { .. }));
    assert!(matches!(refused(&[member(0.0, 0.0), member(4.0, 0.0)]), ModelError::Domain(_)));
}
