//! A phase function against Mie's, both with mean 1 and forward at 0°.

use super::Check;
use super::bounds::{FOGBOW_DEG, FORWARD_PEAK, SEEN, TRANSPORT, WIDE_SHAPE};
use super::landmarks::Landmarks;
use super::sampling::total_variation;
use crate::TablesError;
use stratiform_optics::phase::{PhaseFunction, PhaseTable};

/// Every check that needs Mie.
pub(super) fn compare(
    table: &PhaseTable,
    mie: &PhaseTable,
    theta_f_deg: f64,
) -> Result<Vec<Check>, TablesError> {
    let (found, expected) = (Landmarks::of(table), Landmarks::of(mie));
    let mut checks = vec![
        relative("forward-peak", found.forward_value, expected.forward_value, FORWARD_PEAK, "P at 0 degrees"),
        forward_fraction(table.forward_fraction(theta_f_deg)?, mie.forward_fraction(theta_f_deg)?),
        asymmetry(table.asymmetry(), mie.asymmetry()),
        wide_shape(table, mie, theta_f_deg)?,
    ];
    checks.extend(fogbow(&found, &expected));
    checks.push(glory(table, mie, &found, &expected));
    Ok(checks)
}

fn relative(name: &str, found: f64, expected: f64, bound: f64, words: &str) -> Check {
    Check::number(name, found, expected, bound * expected, words)
}

pub(super) fn asymmetry(found: f64, expected: f64) -> Check {
    Check::number("asymmetry", found, expected, TRANSPORT * (1.0 - expected), "g, bound 2 % of 1-g")
}

pub(super) fn forward_fraction(found: f64, expected: f64) -> Check {
    let words = format!("P_f {found:.3} where Mie says {expected:.3}, bound 2 % of 1-P_f");
    Check::number("forward-fraction", found, expected, TRANSPORT * (1.0 - expected), words)
}

/// Total variation beyond θ_f, each part normalised.
fn wide_shape(table: &PhaseTable, mie: &PhaseTable, theta_f_deg: f64) -> Result<Check, TablesError> {
    let Ok(part) = table.modified(theta_f_deg) else {
        return Ok(Check::plain("wide-shape", false, "nothing is scattered beyond theta_f"));
    };
    let off = total_variation(&mie.modified(theta_f_deg)?, &part);
    let words = "share of light beyond theta_f that goes elsewhere";
    Ok(Check::number("wide-shape", off, 0.0, WIDE_SHAPE, words))
}

fn fogbow(found: &Landmarks, expected: &Landmarks) -> Vec<Check> {
    let Some(mie) = expected.fogbow else { return Vec::new() };
    let Some(bow) = found.fogbow else {
        return vec![Check::plain(
            "fogbow-contrast",
            false,
            format!("no fogbow; Mie's is at {:.1}", mie.theta_deg),
        )];
    };
    vec![
        Check::number("fogbow-angle", bow.theta_deg, mie.theta_deg, FOGBOW_DEG, "degrees"),
        relative("fogbow-contrast", bow.contrast, mie.contrast, SEEN, "fogbow over the valley before it"),
    ]
}

/// The table over Mie from 170° on, where its largest deviation is, relative to what the ratio is elsewhere.
fn glory(table: &PhaseTable, mie: &PhaseTable, found: &Landmarks, expected: &Landmarks) -> Check {
    let ratio = |degrees: f64| table.at(degrees.to_radians()) / mie.at(degrees.to_radians());
    let mut elsewhere: Vec<f64> = (20..170).map(|degrees| ratio(f64::from(degrees))).collect();
    elsewhere.sort_by(f64::total_cmp);
    let scale = elsewhere[elsewhere.len() / 2];
    if scale <= 0.0 {
        return Check::plain(
            "glory",
            false,
            "nothing is scattered between 20 and 170 degrees to compare it with",
        );
    }
    let off = |i: i32| ratio(170.0 + 0.25 * f64::from(i)) / scale;
    let worst = (0..=40)
        .map(off)
        .fold(1.0, |worst: f64, r| if (r - 1.0).abs() > (worst - 1.0).abs() { r } else { worst });
    let words = format!(
        "table over Mie where they differ most beyond 170 degrees; rings at {} where Mie has {}; contrast {} where Mie has {}",
        rings(found),
        rings(expected),
        contrast(found),
        contrast(expected)
    );
    Check::number("glory", worst, 1.0, SEEN, words)
}

fn contrast(landmarks: &Landmarks) -> String {
    landmarks.glory_contrast.map_or("without end".to_owned(), |contrast| format!("{contrast:.2}"))
}

fn rings(landmarks: &Landmarks) -> String {
    let listed: Vec<String> = landmarks.rings_deg.iter().take(4).map(|ring| format!("{ring:.1}")).collect();
    if listed.is_empty() { "no angle".to_owned() } else { listed.join(", ") }
}
