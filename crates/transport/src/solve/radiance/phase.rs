//! What the exact orders need of a phase function: its values, and where they change quickly.

use super::series_table::SeriesTable;
use crate::solve::medium::{SolveMedium, Source};
use std::f64::consts::PI;
use std::sync::Arc;
use stratiform_optics::phase::PhaseFunction;

/// Values of P with its angular scales.
#[derive(Clone)]
pub(super) struct Phase {
    values: Values,
    /// Angle over which P halves from the forward direction, radians; θ_f where there is nothing forward.
    pub(super) peak: f64,
    /// The same from the backward direction, if P is strong there.
    pub(super) back: Option<f64>,
    /// θ_f, below which P is 0.
    pub(super) edge: Option<f64>,
    /// Wave length of the finest waves that a Legendre series has.
    pub(super) waves: Option<f64>,
    /// Largest error of a value.
    pub(super) error: f64,
}

/// 1 - cosΘ below which P = 0 is no hole.
const NARROWEST: f64 = 1e-8;

/// Backward values that count as a peak.
const STRONG: f64 = 3.0;

#[derive(Clone)]
enum Values {
    Function(Arc<dyn PhaseFunction>),
    Series(Arc<SeriesTable>),
}

impl Values {
    fn at(&self, deflection: f64) -> f64 {
        match self {
            Self::Function(phase) => phase.value(deflection),
            Self::Series(table) => table.at(angle(deflection)),
        }
    }

    fn at_each(&self, deflections: &mut [f64]) {
        match self {
            Self::Function(phase) => phase.values_at(deflections),
            Self::Series(table) => deflections.iter_mut().for_each(|v| *v = table.at(angle(*v))),
        }
    }
}

impl Phase {
    pub(super) fn new(medium: &SolveMedium) -> Self {
        let (values, hole) = match medium.source() {
            Source::Phase(phase) => (Values::Function(phase.clone()), phase.invert(0.0)),
            Source::Moments(chi) => (Values::Series(Arc::new(SeriesTable::new(chi))), 0.0),
        };
        let edge = (hole > NARROWEST).then(|| angle(hole));
        let peak = edge.unwrap_or_else(|| half_width(|theta| values.at(deflection(theta))));
        let mirrored = |theta: f64| values.at(2.0 - deflection(theta));
        let back = (mirrored(0.0) > STRONG).then(|| half_width(mirrored));
        let (waves, error) = match &values {
            Values::Function(_) => (None, 0.0),
            Values::Series(table) => (table.waves(), table.error()),
        };
        Self { values, peak, back, edge, waves, error }
    }

    /// P at 1 - cosΘ.
    pub(super) fn at(&self, deflection: f64) -> f64 {
        self.values.at(deflection)
    }

    /// Replaces each 1 - cosΘ by P.
    pub(super) fn at_each(&self, deflections: &mut [f64]) {
        self.values.at_each(deflections);
    }
}

/// Θ of 1 - cosΘ.
fn angle(deflection: f64) -> f64 {
    2.0 * libm::asin((0.5 * deflection).min(1.0).sqrt())
}

fn deflection(theta: f64) -> f64 {
    2.0 * libm::pow(libm::sin(0.5 * theta), 2.0)
}

/// Half the first of π/2ⁿ, from below, at which `value` has fallen to half of that at 0; π if it never does.
fn half_width(value: impl Fn(f64) -> f64) -> f64 {
    let half = 0.5 * value(0.0);
    let angles = (0..22).rev().map(|n| PI / f64::from(1_u32 << n));
    angles.into_iter().find(|theta| value(*theta) < half).map_or(PI, |theta| 0.5 * theta)
}
