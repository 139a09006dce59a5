//! Planted faults are named, each by its own name and no other; what is right is not.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::cloud;
use std::f64::consts::PI;
use std::fmt::Write;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_tables::diagnosis::{
    Check, Constants, Diagnosis, Known, Question, Verdict, check_constants, diagnose, tabulated,
};
use stratiform_tables::nearest::Blend;
use stratiform_tables::read::{Choice, Normalisation, RawTable, read};

/// The cloud's own rows, each changed.
fn changed(change: impl Fn(f64, f64) -> (f64, f64)) -> Vec<(f64, f64)> {
    let phase = &cloud().phase;
    phase.theta_deg().iter().zip(phase.values()).map(|(theta, p)| change(*theta, *p)).collect()
}

/// P at any angle.
fn p(theta_deg: f64) -> f64 {
    cloud().phase.at(theta_deg.to_radians())
}

fn read_rows(header: &str, rows: &[(f64, f64)]) -> RawTable {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("table.csv");
    let text = rows.iter().fold(format!("{header}\n"), |mut text, (theta, p)| {
        let _ = writeln!(text, "{theta},{p}");
        text
    });
    std::fs::write(&path, text).unwrap();
    read(&path, &Choice::default()).unwrap()
}

fn look(rows: &[(f64, f64)]) -> Diagnosis {
    diagnose(&read_rows("theta_deg,p", rows), Some(&cloud().phase), Question::mean_one(5.0)).unwrap()
}

fn faults(rows: &[(f64, f64)]) -> Vec<String> {
    look(rows).faults().into_iter().map(str::to_owned).collect()
}

fn check<'a>(diagnosis: &'a Diagnosis, name: &str) -> &'a Check {
    diagnosis.checks.iter().find(|check| check.name == name).unwrap()
}

/// 1 below `from`, rising to 1 + `by` at `to` and beyond.
fn ramp(theta: f64, from: f64, to: f64, by: f64) -> f64 {
    1.0 + by * ((theta - from) / (to - from)).clamp(0.0, 1.0)
}

/// `by` between 130° and 150°, falling to 0 at 120° and 160°.
fn hump(theta: f64, by: f64) -> f64 {
    ramp(theta, 120.0, 130.0, by) - ramp(theta, 150.0, 160.0, by)
}

fn normalised(rows: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let (theta, p): (Vec<f64>, Vec<f64>) = rows.into_iter().unzip();
    let table = PhaseTable::new(theta, p, Norm::Any).unwrap();
    table.rows().iter().map(|row| (row.theta_deg, row.p)).collect()
}

fn equal_steps(count: u32) -> Vec<(f64, f64)> {
    (0..=count).map(|i| 180.0 * f64::from(i) / f64::from(count)).map(|theta| (theta, p(theta))).collect()
}

#[test]
fn the_clouds_own_table_passes() {
    let diagnosis = look(&changed(|theta, p| (theta, p)));
    assert!(diagnosis.passes(), "{:?}", diagnosis.faults());
    assert!(
        diagnosis.checks.len() == 12 && diagnosis.checks.iter().all(|check| check.verdict == Verdict::Ok)
    );
    let alone =
        diagnose(&read_rows("", &changed(|theta, p| (theta, p))), None, Question::mean_one(5.0)).unwrap();
    assert!(alone.passes() && alone.checks.len() == 5);
}

#[test]
fn every_planted_fault_is_named_and_no_other() {
    let mut flipped = changed(|theta, p| (180.0 - theta, p));
    flipped.reverse();
    let cases = [
        ("angle-sign", flipped),
        ("angle-unit", changed(|theta, p| (theta.to_radians(), p))),
        ("normalisation", changed(|theta, p| (theta, 0.25 * p / PI))),
        ("normalisation", changed(|theta, p| (theta, 4.0 * PI * p))),
        ("normalisation", changed(|theta, p| (theta, 1234.5 * p))),
        ("integral", changed(|theta, p| (theta, 1.01 * p))),
        ("sampling", equal_steps(180)),
        // The peak cut off at 5°, as it stands and normalised again.
        ("forward-peak", changed(|theta, q| (theta, q.min(p(5.0))))),
        ("forward-peak", changed(|theta, q| (theta, q.min(p(5.0)) / 0.59117))),
        // A smooth end instead of a glory.
        ("glory", changed(|theta, q| (theta, if theta < 170.0 { q } else { p(170.0) }))),
        // The bow 2° nearer to the sun's side; the valley before it filled; the norm kept.
        ("fogbow-angle", normalised(changed(|theta, _| (theta, p(theta + 2.0 * hump(theta, 1.0)))))),
        ("fogbow-contrast", normalised(changed(|theta, q| (theta, q * (1.0 + hump(theta + 30.0, 0.13)))))),
    ];
    for (name, rows) in cases {
        assert_eq!(faults(&rows), [name]);
    }
}

#[test]
fn several_faults_are_all_named() {
    let mut rows = equal_steps(180);
    rows.iter_mut().for_each(|(theta, p)| (*theta, *p) = ((180.0 - *theta).to_radians(), *p / (4.0 * PI)));
    rows.reverse();
    assert_eq!(faults(&rows), ["angle-unit", "angle-sign", "normalisation", "sampling"]);
}

/// The paper's P_f of 51 %: a table in 1° steps, integrated linearly in cosΘ (physics of the example: 1.09, 0.501).
#[test]
fn a_table_of_one_degree_steps_is_too_coarse() {
    let diagnosis = look(&equal_steps(180));
    let facts = &diagnosis.facts;
    assert!((facts.integral_trapezoids - 1.09).abs() < 6e-3, "{}", facts.integral_trapezoids);
    assert!((facts.forward_fraction_trapezoids - 0.501).abs() < 1e-3);
    let sampling = check(&diagnosis, "sampling");
    let expected = "too coarse: raw integral 1.094 by trapezoids in the cosine";
    assert!(sampling.words.starts_with(expected), "{}", sampling.words);
    assert!(sampling.words.contains("P_f 0.501 and 0.476 where Mie says 0.455"), "{}", sampling.words);
    for name in ["integral", "forward-fraction", "asymmetry"] {
        let check = check(&diagnosis, name);
        assert_eq!(
            (check.verdict, check.follows_from.as_deref()),
            (Verdict::Follows, Some("sampling")),
            "{name}"
        );
    }
    assert_eq!(
        diagnosis.facts.normalisation,
        Normalisation::MeanOne,
        "a raw integral of 1.04 is no other convention"
    );
}

/// Just under and just over the bounds of `diagnosis::bounds`.
#[test]
fn bounds_are_where_they_are_stated() {
    let pairs = [
        ("integral", [1.0009, 1.0011].map(|scale| changed(|theta, p| (theta, scale * p)))),
        ("forward-peak", [0.09, 0.11].map(|by| changed(|theta, p| (theta, p * ramp(theta, 0.2, 0.1, by))))),
        ("glory", [0.09, 0.11].map(|by| changed(|theta, p| (theta, p * ramp(theta, 176.0, 178.0, by))))),
        ("sampling", [640, 460].map(equal_steps)),
    ];
    for (name, [under, over]) in pairs {
        assert_eq!(faults(&under), [] as [&str; 0], "{name}");
        assert_eq!(faults(&over), [name]);
    }
}

/// A table per steradian is right where that is what is meant.
#[test]
fn another_convention_may_be_meant() {
    let rows = changed(|theta, p| (theta, 0.25 * p / PI));
    let question = Question { theta_f_deg: 5.0, normalisation: Normalisation::PerSteradian };
    let judge = |rows| diagnose(&read_rows("theta_deg,p", rows), Some(&cloud().phase), question).unwrap();
    assert!(judge(&rows).passes());
    assert_eq!(judge(&changed(|theta, p| (theta, p))).faults(), ["normalisation"]);
}

/// Light nowhere but in the peak, or nowhere in the valley before the bow: ratios without a value, no failure.
#[test]
fn tables_with_empty_parts_are_judged() {
    let needle = look(&changed(|theta, p| (theta, if theta < 4.0 { p } else { 0.0 })));
    assert!(
        needle.faults().contains(&"wide-shape") && needle.faults().contains(&"glory"),
        "{:?}",
        needle.faults()
    );
    let dark = look(&changed(|theta, p| (theta, if (90.0..110.0).contains(&theta) { 0.0 } else { p })));
    assert_eq!(check(&dark, "fogbow-contrast").found, None);
    assert_eq!(check(&dark, "fogbow-contrast").verdict, Verdict::Wrong);
}

/// Another cloud's table: the droplets are wrong, the table is not.
#[test]
fn smaller_droplets_show_against_mie_only() {
    let smaller = cloud_of(5.0);
    let diagnosis =
        diagnose(&tabulated(&smaller.phase).unwrap(), Some(&cloud().phase), Question::mean_one(5.0)).unwrap();
    let faults = diagnosis.faults();
    assert!(faults.contains(&"forward-peak") && faults.contains(&"forward-fraction"), "{faults:?}");
    for name in ["angle-unit", "angle-sign", "normalisation", "sampling", "integral"] {
        assert_eq!(check(&diagnosis, name).verdict, Verdict::Ok, "{name}");
    }
}

fn cloud_of(effective_radius_um: f64) -> stratiform_optics::ensemble::Ensemble {
    let text = format!(
        r#"{{"number_density_per_cm3": 300.0, "wavelengths_um": [0.55],
            "droplets": {{"distribution": "modified-gamma", "gamma": 2.0, "effective_radius_um": {effective_radius_um}}}}}"#
    );
    stratiform_optics::compute(&serde_json::from_str(&text).unwrap()).unwrap().remove(0)
}

/// A Henyey–Greenstein function of nearly the right g has no peak, no bow and no glory; nothing is wrong with it as a
/// table.
#[test]
fn an_analytic_function_lacks_what_it_lacks() {
    let phase = Blend::henyey_greenstein(0.853).phase().unwrap();
    let diagnosis =
        diagnose(&tabulated(&phase).unwrap(), Some(&cloud().phase), Question::mean_one(5.0)).unwrap();
    assert_eq!(
        diagnosis.faults(),
        ["forward-peak", "forward-fraction", "wide-shape", "fogbow-contrast", "glory"]
    );
    assert!(diagnose(&tabulated(&phase).unwrap(), None, Question::mean_one(5.0)).unwrap().passes());
}

#[test]
fn constants_are_held_against_mie() {
    let one = cloud();
    let known =
        Known { phase: &one.phase, extinction_per_m: Some([one.extinction.paper, one.extinction.mie]) };
    let judge = |constants: Constants| check_constants(&constants, &known, 5.0).unwrap().remove(0);
    let paper = judge(Constants { forward_fraction: Some(0.51), ..Constants::default() });
    assert_eq!(paper.verdict, Verdict::Wrong);
    assert!(
        paper.words.contains("where Mie says 0.455") && paper.words.contains("gives 0.501"),
        "{}",
        paper.words
    );
    let near = one.forward_fraction + 0.019 * (1.0 - one.forward_fraction);
    assert_eq!(
        judge(Constants { forward_fraction: Some(near), ..Constants::default() }).verdict,
        Verdict::Ok
    );
    let far = one.forward_fraction + 0.021 * (1.0 - one.forward_fraction);
    assert_eq!(
        judge(Constants { forward_fraction: Some(far), ..Constants::default() }).verdict,
        Verdict::Wrong
    );
    // Published: kappa = N0 pi r_e^2 = 0.04618, Mie's 0.0368.
    let kappa = |value: f64| judge(Constants { extinction_per_m: Some(value), ..Constants::default() });
    assert!(kappa(0.04618).verdict == Verdict::Ok && kappa(0.04618).words.contains("N0 pi r_e^2"));
    assert!(kappa(0.0368).verdict == Verdict::Ok && kappa(0.0368).words.contains("<Q_ext pi r^2>"));
    assert_eq!(kappa(0.0415).verdict, Verdict::Wrong);
    assert_eq!(judge(Constants { asymmetry: Some(0.86), ..Constants::default() }).verdict, Verdict::Wrong);
    let refused = Constants { asymmetry: Some(1.2), ..Constants::default() };
    assert!(check_constants(&refused, &known, 5.0).is_err());
    let both =
        Constants { henyey_greenstein: Some(0.8), blend: Some(Blend::two_lobe(0.5, 0.9, 0.5)), ..refused };
    assert!(both.phase().is_err());
}
