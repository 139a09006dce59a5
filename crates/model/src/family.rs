//! Tables of parameters over (θ_l, r_e): one table per effective radius, interpolated between radii.
//!
//! At μ_l each of the two tables around r_e is interpolated by its own rule ([`ParameterGrid`]), then the two results by
//! the same rule with the weight (s(r_e) - s(r_a))/(s(r_b) - s(r_a)), κ_S and (1-β)/β linearly. s is the
//! [`RadiusCoordinate`].
//!
//! Thickness is optical thickness of the full medium, so that one family serves every droplet number. r_e outside the
//! family is refused.

mod phase;

pub use phase::{PhaseFamily, PhaseMember};

use crate::parameters::Light;
use crate::table::{Angle, ParameterGrid};
use crate::{ModelError, Parameters, Real, Values};
use stratiform_quantities::{Incidence, Range};

/// Effective radii that a family may have, µm.
pub const RADIUS_UM: Range = Range::closed(0.1, 1000.0);

/// The function s of r_e in which parameters are interpolated linearly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RadiusCoordinate {
    /// r_e.
    Radius,
    /// ln r_e.
    Logarithm,
    /// r_e^(-2/3): how corrections to geometrical optics fall with size.
    TwoThirds,
    /// 1/r_e.
    Reciprocal,
}

impl RadiusCoordinate {
    /// All, for comparisons.
    pub const ALL: [Self; 4] = [Self::Radius, Self::Logarithm, Self::TwoThirds, Self::Reciprocal];

    /// s(r_e).
    pub fn of<F: Real>(self, radius: F) -> F {
        match self {
            Self::Radius => radius,
            Self::Logarithm => radius.ln(),
            Self::TwoThirds => (F::of(-2.0 / 3.0) * radius.ln()).exp(),
            Self::Reciprocal => F::of(1.0) / radius,
        }
    }
}

impl std::fmt::Display for RadiusCoordinate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Radius => "r",
            Self::Logarithm => "log(r)",
            Self::TwoThirds => "r^(-2/3)",
            Self::Reciprocal => "1/r",
        })
    }
}

/// The parameters at one effective radius.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// r_e, µm.
    pub effective_radius_um: f64,
    /// The table's angles; β and κ_S are the same in every row.
    pub angles: Vec<Angle>,
    /// Diffuse light.
    pub diffuse: Values<f64>,
}

/// A member, ready to be looked up.
#[derive(Clone, Debug, PartialEq)]
struct Node<F> {
    radius: F,
    place: F,
    grid: ParameterGrid<F>,
    diffuse: Parameters<F>,
}

/// Parameters for every μ_l of the tables and every r_e between the first and the last.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterFamily<F> {
    coordinate: RadiusCoordinate,
    nodes: Vec<Node<F>>,
}

impl<F: Real> ParameterFamily<F> {
    /// A family of at least two members with rising radii.
    ///
    /// # Errors
    /// [`ModelError`] if a number is out of domain, radii or angles do not rise, or there are too few.
    pub fn new(coordinate: RadiusCoordinate, members: &[Member]) -> Result<Self, ModelError> {
        check_radii(&members.iter().map(|member| member.effective_radius_um).collect::<Vec<_>>())?;
        let node = |member: &Member| {
            let radius = F::of(member.effective_radius_um);
            let grid = ParameterGrid::new(&member.angles)?;
            let diffuse = Parameters::new(&member.diffuse, Incidence::Diffuse)?;
            Ok(Node { radius, place: coordinate.of(radius), grid, diffuse })
        };
        Ok(Self { coordinate, nodes: members.iter().map(node).collect::<Result<_, ModelError>>()? })
    }

    /// The parameters of a beam at μ_l in a cloud of effective radius `radius` in µm.
    ///
    /// # Errors
    /// [`ModelError::Domain`] outside the tables' angles or the family's radii.
    pub fn at(&self, mu: F, radius: F) -> Result<Parameters<F>, ModelError> {
        let (a, b, weight) = self.around(radius)?;
        Ok(Parameters::between(&a.grid.at(mu)?, &b.grid.at(mu)?, weight, Light::Beam(mu)))
    }

    /// The parameters of diffuse light.
    ///
    /// # Errors
    /// [`ModelError::Domain`] outside the family's radii.
    pub fn diffuse(&self, radius: F) -> Result<Parameters<F>, ModelError> {
        let (a, b, weight) = self.around(radius)?;
        Ok(Parameters::between(&a.diffuse, &b.diffuse, weight, Light::Diffuse))
    }

    /// The members around `radius`, and the weight of the second.
    fn around(&self, radius: F) -> Result<(&Node<F>, &Node<F>, F), ModelError> {
        let (first, last) = (&self.nodes[0], &self.nodes[self.nodes.len() - 1]);
        Range::closed(first.radius.to_f64(), last.radius.to_f64())
            .check("effective_radius_um", radius.to_f64())?;
        let inner = &self.nodes[1..self.nodes.len() - 1];
        let i = inner.iter().filter(|node| radius > node.radius).count();
        let (a, b) = (&self.nodes[i], &self.nodes[i + 1]);
        let weight = (self.coordinate.of(radius) - a.place) / (b.place - a.place);
        Ok((a, b, weight))
    }
}

/// At least two radii within [`RADIUS_UM`], rising.
fn check_radii(radii: &[f64]) -> Result<(), ModelError> {
    if radii.len() < 2 {
        return Err(ModelError::TooFewRadii { radii: radii.len() });
    }
    for pair in radii.windows(2) {
        let (previous, next) = (pair[0], pair[1]);
        if next.partial_cmp(&previous) != Some(std::cmp::Ordering::Greater) {
            return Err(ModelError::UnsortedRadii { previous, next });
        }
    }
    for radius in radii {
        RADIUS_UM.check("effective_radius_um", *radius)?;
    }
    Ok(())
}
