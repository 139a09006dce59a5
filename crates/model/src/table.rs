//! A table of parameters over θ_l, interpolated in μ_l: linearly in b, t and in the reciprocals 1/c, 1/κ_c and 1/r.
//!
//! Every parameter is an even function of θ_l, hence smooth in μ_l = cos θ_l: interpolation in μ_l needs no arc cosine
//! and has no kink at normal incidence. c, κ_c and r grow towards the horizon like slant paths, as 1/μ_l does; their
//! reciprocals are nearer to straight lines. Emitted shaders do the same; their
//! header gives the error half-way between rows.

use crate::parameters::Light;
use crate::{ModelError, Parameters, Real, Values};
use stratiform_quantities::{CosZenith, Incidence, Range};

/// The parameters of one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    /// θ_l in degrees.
    pub theta_l_deg: f64,
    /// The parameters; β and κ_S are the same in every row.
    pub values: Values<f64>,
}

/// Parameters for every μ_l between the first and the last angle.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterGrid<F> {
    nodes: Vec<(F, Parameters<F>)>,
}

/// cos of an angle in degrees, exactly 0 at 90.
pub fn cos_degrees(theta_deg: f64) -> f64 {
    libm::sin((90.0 - theta_deg).to_radians())
}

/// c, κ_c and r of a row, whose reciprocals are interpolated.
const INVERTIBLE: Range = Range::closed(1e-12, 1e6);

/// The CosZenith of a table angle.
fn cos_zenith(theta_l_deg: f64) -> Result<CosZenith, ModelError> {
    Range::closed(0.0, 90.0).check("theta_l_deg", theta_l_deg)?;
    Ok(CosZenith::new(cos_degrees(theta_l_deg))?)
}

impl<F: Real> ParameterGrid<F> {
    /// A grid of at least two angles in rising order.
    ///
    /// # Errors
    /// [`ModelError`] if a number is out of domain, an angle does not rise, or there are too few.
    pub fn new(angles: &[Angle]) -> Result<Self, ModelError> {
        if angles.len() < 2 {
            return Err(ModelError::TooFewRows { rows: angles.len() });
        }
        for pair in angles.windows(2) {
            let (previous, next) = (pair[0].theta_l_deg, pair[1].theta_l_deg);
            if next.partial_cmp(&previous) != Some(std::cmp::Ordering::Greater) {
                return Err(ModelError::Unsorted { previous, next });
            }
        }
        let node = |angle: &Angle| {
            let mu = cos_zenith(angle.theta_l_deg)?;
            INVERTIBLE.check("c", angle.values.c)?;
            INVERTIBLE.check("kappa_c", angle.values.kappa_c)?;
            INVERTIBLE.check("r", angle.values.r)?;
            Ok((F::of(mu.get()), Parameters::new(&angle.values, Incidence::Beam(mu))?))
        };
        Ok(Self { nodes: angles.iter().map(node).collect::<Result<_, ModelError>>()? })
    }

    /// The parameters at μ_l.
    ///
    /// # Errors
    /// [`ModelError::Domain`] outside the table's angles.
    pub fn at(&self, mu: F) -> Result<Parameters<F>, ModelError> {
        let (first, last) = (self.nodes[0].0, self.nodes[self.nodes.len() - 1].0);
        Range::closed(last.to_f64(), first.to_f64()).check("mu_l", mu.to_f64())?;
        // The nodes' μ fall: the interval's lower end is the number of inner nodes above μ.
        let inner = &self.nodes[1..self.nodes.len() - 1];
        let i = inner.iter().filter(|node| mu < node.0).count();
        let ((mu_a, a), (mu_b, b)) = (&self.nodes[i], &self.nodes[i + 1]);
        let weight = (*mu_a - mu) / (*mu_a - *mu_b);
        Ok(Parameters::between(a, b, weight, Light::Beam(mu)))
    }
}
