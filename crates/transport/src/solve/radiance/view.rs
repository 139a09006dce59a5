//! Directions in which radiance is asked for.

use crate::TransportError;
use stratiform_quantities::{Order, Range, Side};

/// Cosines below this are taken for it: the limit μ → 0, to about 1e-8.
pub(super) const GRAZING: f64 = 1e-10;

/// A direction in which light leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The face it leaves.
    pub side: Side,
    /// Cosine of its angle to the slab's normal, in \[0, 1\].
    pub mu: f64,
    /// Azimuth in degrees; at 0 light keeps the sun's. The glory is at the top, 180°, μ = μ0.
    pub phi_deg: f64,
}

/// Which scattering orders a radiance counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RadianceOrder {
    /// Light scattered once.
    One,
    /// Light scattered twice.
    Two,
    /// All scattered light.
    Total,
}

impl RadianceOrder {
    /// All, in the order of tables.
    pub const ALL: [Self; 3] = [Self::One, Self::Two, Self::Total];
}

impl From<RadianceOrder> for Order {
    fn from(order: RadianceOrder) -> Self {
        match order {
            RadianceOrder::One => Order::Exactly(1),
            RadianceOrder::Two => Order::Exactly(2),
            RadianceOrder::Total => Order::Total,
        }
    }
}

/// Sun and view, checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Geometry {
    pub(super) mu0: f64,
    pub(super) side: Side,
    pub(super) mu: f64,
    /// Radians.
    pub(super) phi: f64,
}

impl Geometry {
    pub(super) fn new(mu0: f64, view: &View) -> Result<Self, TransportError> {
        let cosine = Range::closed(0.0, 1.0);
        cosine.check("mu0", mu0)?;
        cosine.check("view mu", view.mu)?;
        Range::closed(-360.0, 360.0).check("phi (degrees)", view.phi_deg)?;
        Range::above(0.0).check("mu0 + view mu", mu0 + view.mu)?;
        // Beyond 180° mirror images, so that exact multiples of 90° stay exact.
        let turned = (view.phi_deg.abs() - 180.0).abs();
        let phi = (180.0 - turned).to_radians();
        Ok(Self { mu0: mu0.max(GRAZING), side: view.side, mu: view.mu.max(GRAZING), phi })
    }

    /// 1 - cosΘ between sun and view, 2 sin²((θ-θ')/2) + 2 sinθ sinθ' sin²(φ/2), without cancellation.
    pub(super) fn deflection(&self) -> f64 {
        let (sun, view) = (libm::acos(self.mu0), self.travel());
        let (across, around) = (libm::sin(0.5 * (sun - view)), libm::sin(0.5 * self.phi));
        2.0 * (across * across + libm::sin(sun) * libm::sin(view) * around * around).min(1.0)
    }

    /// Angle of the leaving light to the downward normal.
    pub(super) fn travel(&self) -> f64 {
        let theta = libm::acos(self.mu);
        if self.side == Side::Top { std::f64::consts::PI - theta } else { theta }
    }
}
