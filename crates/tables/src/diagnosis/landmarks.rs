//! What one sees in a phase function: the forward peak, the fogbow, the glory.
//!
//! The fogbow is the highest local maximum between 120° and 165°, its contrast its value over the least one between 80° and
//! itself. Glory rings are local maxima between 165° and 179.5°, from where on it is the centre; the glory's contrast is
//! the highest value there over the least one between the fogbow (or 150°) and 180°.

use stratiform_optics::phase::PhaseTable;

/// A maximum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bow {
    /// Where, degrees.
    pub theta_deg: f64,
    /// P there.
    pub value: f64,
    /// Over the valley before it.
    pub contrast: f64,
}

/// The landmarks of a phase function.
#[derive(Clone, Debug, PartialEq)]
pub struct Landmarks {
    /// P at 0°.
    pub forward_value: f64,
    /// Where P first falls to half of it, degrees.
    pub half_width_deg: f64,
    /// The fogbow, if there is one.
    pub fogbow: Option<Bow>,
    /// P at 180°.
    pub backward_value: f64,
    /// Glory rings.
    pub rings_deg: Vec<f64>,
    /// Highest value beyond 165° over the valley before it, unless that is dark.
    pub glory_contrast: Option<f64>,
}

/// A bow stands out of the valley before it by this much: rounding of printed tables does not make one.
const STANDS_OUT: f64 = 1.01;

impl Landmarks {
    /// Those of `table`.
    pub fn of(table: &PhaseTable) -> Self {
        let (theta, p) = (table.theta_deg(), table.values());
        let forward_value = p[0];
        let backward_value = p[p.len() - 1];
        let fogbow = fogbow(theta, p);
        let valley_from = fogbow.map_or(150.0, |bow| bow.theta_deg);
        let beyond = |from: f64| (0..p.len()).filter(move |i| theta[*i] >= from).map(|i| p[i]);
        let valley = beyond(valley_from).fold(f64::INFINITY, f64::min);
        Self {
            forward_value,
            half_width_deg: half_width(theta, p),
            fogbow,
            backward_value,
            rings_deg: maxima(theta, p, 165.0, 179.5).map(|i| theta[i]).collect(),
            glory_contrast: (valley > 0.0).then(|| beyond(165.0).fold(0.0, f64::max) / valley),
        }
    }
}

/// Where P falls to half of P(0), linear between rows.
fn half_width(theta: &[f64], p: &[f64]) -> f64 {
    let half = 0.5 * p[0];
    match p.iter().position(|p| *p < half) {
        Some(i) => theta[i - 1] + (theta[i] - theta[i - 1]) * (p[i - 1] - half) / (p[i - 1] - p[i]),
        None => 180.0,
    }
}

/// Rows inside (from, to) above both neighbours.
fn maxima<'a>(theta: &'a [f64], p: &'a [f64], from: f64, to: f64) -> impl Iterator<Item = usize> + 'a {
    (1..p.len() - 1)
        .filter(move |i| theta[*i] > from && theta[*i] < to)
        .filter(move |i| p[*i] > p[i - 1] && p[*i] >= p[i + 1])
}

fn fogbow(theta: &[f64], p: &[f64]) -> Option<Bow> {
    let peak = maxima(theta, p, 120.0, 165.0).max_by(|a, b| p[*a].total_cmp(&p[*b]))?;
    let before = (0..peak).filter(|i| theta[*i] >= 80.0).map(|i| p[i]);
    let contrast = p[peak] / before.fold(f64::INFINITY, f64::min);
    (contrast > STANDS_OUT).then_some(Bow { theta_deg: theta[peak], value: p[peak], contrast })
}
