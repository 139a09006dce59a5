//! Fits of data made by the model itself.

mod support;

use stratiform_artifact::{Flag, ParametersDocument, RowIncidence, read_json, to_csv, write_json};
use stratiform_fit::{FitError, derived_numbers};
use support::{ANGLES, KAPPA, config, incidences, reference, references, run, truth, truths};

fn emitted(document: &ParametersDocument) -> Vec<[f64; 5]> {
    let rows = &document.optical.rows;
    rows.iter().map(|r| [r.b.emitted, r.c.emitted, r.kappa_c.emitted, r.t.emitted, r.r.emitted]).collect()
}

#[test]
fn exact_data_give_back_their_parameters() {
    let document = run(&config(&ANGLES), &references(0.0, 1e-4)).unwrap();
    assert!((document.optical.beta.value / 0.92 - 1.0).abs() < 1e-8);
    for ((got, want), row) in emitted(&document).iter().zip(truths()).zip(&document.optical.rows) {
        for (g, w) in got.iter().zip([want.b, want.c, want.kappa_c, want.t, want.r]) {
            assert!((g / w - 1.0).abs() < 1e-8, "{}: {got:?} for {want:?}", row.theta_l_deg);
        }
        assert!(row.misfit.iter().all(|m| m.max < 1e-9));
        assert!(row.b.std_error.unwrap() > 0.0 && row.correlation_kappa_c_t_r.is_some());
        assert_eq!(row.flags.contains(&Flag::BetaFixed), row.theta_l_deg.degrees().is_none_or(|d| d > 80.0));
        assert!(!row.flags.contains(&Flag::CNotIdentifiable), "{:?}", row.flags);
    }
}

#[test]
fn both_tables_describe_the_same_curves() {
    let document = run(&config(&ANGLES), &references(0.003, 1e-4)).unwrap();
    let (metres, optical) = (&document.metres, &document.optical);
    let slope = |beta: f64| (1.0 - beta) / beta;
    assert!((slope(metres.beta.value) / slope(optical.beta.value) / KAPPA - 1.0).abs() < 1e-12);
    let nearby = slope(optical.beta.value + optical.beta.std_error) * KAPPA;
    let error = metres.beta.value - 1.0 / (1.0 + nearby);
    assert!((error.abs() / metres.beta.std_error - 1.0).abs() < 1e-2);
    for (m, o) in metres.rows.iter().zip(&optical.rows) {
        assert!((m.c.emitted / o.c.emitted / KAPPA - 1.0).abs() < 1e-14);
        assert!((m.kappa_c.std_error.unwrap() / o.kappa_c.std_error.unwrap() / KAPPA - 1.0).abs() < 1e-14);
        assert_eq!((m.t, m.r, m.b), (o.t, o.r, o.b));
    }
    let astray = |document: &ParametersDocument| -> Vec<String> {
        let numbers = derived_numbers(document).unwrap().into_iter();
        numbers.filter(|n| n.document != n.follows).map(|n| n.name).collect()
    };
    assert!(astray(&document).is_empty());
    let mut slipped = document.clone();
    slipped.metres.rows[1].c.emitted *= 1.0 + 1e-9;
    assert_eq!(astray(&slipped), ["metres c", "metres c"]);
    slipped.metres.rows.pop();
    assert!(derived_numbers(&slipped).is_err());
}

/// Where b passes 1, c has no value, be it for the misfit's sake (44°) or the noise's (46°); what is emitted
/// is continuous, and the curve hardly worse.
#[test]
fn c_without_influence_is_left_empty() {
    let angles = [0.0, 40.0, 44.0, 46.0, 50.0];
    let b = [1.2, 1.1, 1.0, 0.99, 0.9];
    let mut references: Vec<_> = incidences(&angles)
        .into_iter()
        .zip(b.into_iter().chain([0.9]))
        .map(|(incidence, b)| reference(incidence, &truth(b, 0.3, 0.6, 0.8, 0.06), 0.0, 1e-4))
        .collect();
    for (k, value) in references[2].t_ms.iter_mut().enumerate().skip(2) {
        *value += if k % 2 == 0 { 3e-4 } else { -3e-4 };
    }
    references[3].t_ms_covariance.iter_mut().for_each(|c| *c *= 1e5);
    let document = run(&config(&angles), &references).unwrap();
    let table = document.csv_rows();
    for (row, line) in document.optical.rows.iter().zip(&table).take(5) {
        let empty = matches!(row.theta_l_deg.degrees(), Some(44.0 | 46.0));
        assert_eq!(row.c.value.is_none(), empty, "{row:?}");
        assert_eq!(row.flags.contains(&Flag::CNotIdentifiable), empty);
        assert_eq!((line.c_per_m.is_none(), line.flags.contains("c-not-identifiable")), (empty, empty));
        assert!((row.c.emitted / 0.3 - 1.0).abs() < 0.1, "{row:?}");
        assert!(row.misfit[0].rms < 1e-3, "{row:?}");
        assert!(row.c.std_error.is_some() != empty && row.b.std_error.is_some());
    }
    assert!(to_csv(&table).unwrap().lines().nth(3).unwrap().starts_with("44,"));
}

#[test]
fn a_parameter_on_its_bound_has_no_error_and_a_flag() {
    let mut narrow = config(&ANGLES);
    narrow.bounds.t = [0.0, 0.8];
    narrow.bounds.c = [1e-4, 1.0];
    let document = run(&narrow, &references(0.0, 1e-4)).unwrap();
    let rows = &document.optical.rows;
    assert_eq!((rows[0].t.emitted, rows[0].t.std_error), (0.8, None));
    assert!(rows[0].flags.contains(&Flag::TOnBound) && !rows[3].flags.contains(&Flag::TOnBound));
    assert_eq!((rows[4].c.emitted, rows[4].c.std_error), (1.0, None));
    assert!(rows[4].flags.contains(&Flag::COnBound));
}

#[test]
fn negative_differences_are_flagged() {
    let document = run(&config(&ANGLES), &references(0.0, 1e-4)).unwrap();
    // At 80 degrees the published parameters, which these resemble, give R_3+ = -0.03.
    assert!(document.optical.rows[3].flags.contains(&Flag::NegativeR3Plus));
}

#[test]
fn the_document_survives_the_disk() {
    let document = run(&config(&ANGLES), &references(0.003, 1e-4)).unwrap();
    let path = std::env::temp_dir().join(format!("stratiform-fit-{}.json", std::process::id()));
    write_json(&path, &document).unwrap();
    let back: ParametersDocument = read_json(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert_eq!(back, document);
}

#[test]
fn bad_references_are_refused_by_name() {
    let good = references(0.0, 1e-4);
    type Spoil = fn(&mut Vec<stratiform_fit::Reference>);
    let cases: [(Spoil, &str); 9] = [
        (|r| r[1].t_ms[3] = f64::NAN, "t_ms of theta_l = 30 = NaN is outside [0, 1]"),
        (|r| r[1].orders[2][0] = -0.1, "r_1 of theta_l = 30 = -0.1 is outside [0, 1]"),
        (|r| r[0].tau[0] = 1.0, "tau of theta_l = 0 = 1 is outside"),
        (|r| _ = r[5].t_ms.pop(), "t_ms of theta_l = diffuse has 19 entries, expected 20"),
        (
            |r| r[2].t_ms_covariance[1] = 1.0,
            "the covariance of t_ms of theta_l = 60 is not symmetric at (1, 0)",
        ),
        (|r| r[2].orders_covariance[0] = -1.0, "orders of theta_l = 60 = -1 is outside [0, infinity)"),
        (|r| _ = r.remove(0), "the list of references at an angle has 4 entries, expected 5"),
        (|r| r[0].incidence = RowIncidence::Degrees(1.0), "theta_l_deg = 1 is outside [0, 0]"),
        (|r| r.push(r[5].clone()), "more than one reference follows"),
    ];
    for (spoil, message) in cases {
        let mut references = good.clone();
        spoil(&mut references);
        let error = run(&config(&ANGLES), &references).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
    let mut bad = config(&ANGLES);
    bad.theta_l_deg[0] = f64::NAN;
    assert!(matches!(run(&bad, &good), Err(FitError::Domain(_))));
}
