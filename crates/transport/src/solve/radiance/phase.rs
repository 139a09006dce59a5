//! What the exact orders need of a phase function: its values, and where they change quickly.

use super::series_table::SeriesTable;
use crate::solve::medium::{SolveMedium, Source};
use stratiform_optics::phase::PhaseFunction;

/// Values of P with its angular scales.
#[derive(Clone)]
pub(super) struct Phase<'a> {
    values: Values<'a>,
    /// Angle over which P halves from the forward direction, radians; θ_f where there is nothing forward.
    pub(super) peak: f64,
    /// The same from the backward direction, if P is strong there.
    pub(super) back: Option<f64>,
    /// θ_f, below which P is 0.
    pub(super) edge: Option<f64>,
}

/// 1 - cosΘ below which P = 0 is no hole.
const NARROWEST: f64 = 1e-8;

/// Backward values that count as a peak.
const STRONG: f64 = 3.0;

#[derive(Clone)]
enum Values<'a> {
    Function(&'a dyn PhaseFunction),
    Series(SeriesTable),
}

impl Values<'_> {
    fn at(&self, deflection: f64) -> f64 {
        match self {
            Self::Function(phase) => phase.value(deflection),
            Self::Series(table) => table.at(angle(deflection)),
        }
    }
}

impl<'a> Phase<'a> {
    pub(super) fn new(medium: &'a SolveMedium) -> Self {
        let (values, hole) = match medium.source() {
            Source::Phase(phase) => (Values::Function(phase.as_ref()), phase.invert(0.0)),
            Source::Moments(chi) => (Values::Series(SeriesTable::new(chi)), 0.0),
        };
        let edge = (hole > NARROWEST).then(|| angle(hole));
        let peak = edge.unwrap_or_else(|| half_width(|theta| values.at(deflection(theta))));
        let mirrored = |theta: f64| values.at(2.0 - deflection(theta));
        let back = (mirrored(0.0) > STRONG).then(|| half_width(mirrored));
        Self { values, peak, back, edge }
    }

    /// P at 1 - cosΘ.
    pub(super) fn at(&self, deflection: f64) -> f64 {
        self.values.at(deflection)
    }
}

/// Θ of 1 - cosΘ.
fn angle(deflection: f64) -> f64 {
    2.0 * libm::asin((0.5 * deflection).min(1.0).sqrt())
}

fn deflection(theta: f64) -> f64 {
    2.0 * libm::pow(libm::sin(0.5 * theta), 2.0)
}

/// The first of π, π/2, π/4 … at which `value` is above half of that at 0.
fn half_width(value: impl Fn(f64) -> f64) -> f64 {
    let half = 0.5 * value(0.0);
    let mut theta = std::f64::consts::PI;
    while value(theta) < half && theta > 1e-6 {
        theta *= 0.5;
    }
    theta
}
