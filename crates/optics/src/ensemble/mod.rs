//! Scattering by a cloud of droplets: Mie theory averaged over the size distribution.
//!
//! P(Θ) = 4π ∫N (|S1|²+|S2|²)/2 dr / (k² ∫N C_sca dr) with k = 2π/λ; κ = N0 ⟨Q_ext πr²⟩ ("mie") or N0 πr_e² ("paper").
//! The radius integral is a trapezoid rule, halved until two refinements agree to the [`QuadratureTolerance`]; what
//! they differ by is the reached error. Resonances narrower than the step make that difference fall only like
//! the square root of the step.
//!
//! Spheres up to 2047 orders are summed as cosine series (`circle.rs`), whose cost does not depend on the number of angles;
//! larger ones angle by angle (`kernel.rs`).

mod angles;
mod average;
mod circle;
mod cosines;
mod fourier;
mod kernel;
mod radii;
mod tolerance;

pub use angles::angle_grid;
pub use radii::radius_rule;
pub use tolerance::QuadratureTolerance;

use crate::OpticsError;
use crate::droplets::SizeDistribution;
use crate::mie::{RefractiveIndex, SizeParameter};
use crate::phase::{Norm, PhaseTable};
use average::{Average, Basis};
use radii::Radii;
use std::f64::consts::PI;
use stratiform_artifact::{Extinction, ReachedError};

/// What is averaged over, and how well.
#[derive(Clone, Debug)]
pub struct EnsembleSpec<'a> {
    /// N(r)/N0.
    pub droplets: &'a SizeDistribution,
    /// N0.
    pub number_density_per_cm3: f64,
    /// λ.
    pub wavelength_um: f64,
    /// n, k.
    pub refractive_index: [f64; 2],
    /// θ_f.
    pub theta_f_deg: f64,
    /// The error to reach.
    pub tolerance: QuadratureTolerance,
}

/// Optical properties at one wavelength.
#[derive(Clone, Debug, PartialEq)]
pub struct Ensemble {
    /// λ.
    pub wavelength_um: f64,
    /// n, k.
    pub refractive_index: [f64; 2],
    /// κ per metre in both conventions.
    pub extinction: Extinction,
    /// ω.
    pub single_scattering_albedo: f64,
    /// g, from the Mie coefficients.
    pub asymmetry: f64,
    /// θ_f.
    pub theta_f_deg: f64,
    /// P_f.
    pub forward_fraction: f64,
    /// What the quadrature reached.
    pub reached: ReachedError,
    /// P.
    pub phase: PhaseTable,
}

/// What one refinement of the radius quadrature gives.
struct Refinement {
    average: Average,
    phase: PhaseTable,
    summary: tolerance::Summary,
}

/// The averages over `spec.droplets`, to `spec.tolerance`.
///
/// # Errors
/// [`OpticsError::Domain`] for numbers out of domain, [`OpticsError::NotConverged`] if the radii allowed by the
/// tolerance do not reach it.
pub fn ensemble(spec: &EnsembleSpec<'_>) -> Result<Ensemble, OpticsError> {
    refine(spec, |_, _| ())
}

/// [`ensemble`], telling `progress` the radii used and the error reached after every refinement.
///
/// # Errors
/// As [`ensemble`].
pub fn refine(
    spec: &EnsembleSpec<'_>,
    mut progress: impl FnMut(&ReachedError, &PhaseTable),
) -> Result<Ensemble, OpticsError> {
    let wave_number = 2.0 * PI / spec.wavelength_um;
    let index = RefractiveIndex::new(spec.refractive_index[0], spec.refractive_index[1])?;
    let mut radii = Radii::new(spec.droplets);
    for radius in radii.range() {
        SizeParameter::new(wave_number * radius)?;
    }
    let angles = angle_grid(spec.droplets, wave_number, spec.theta_f_deg)?;
    let basis = Basis::new(wave_number, index, &angles, radii.range()[1]);
    let mut average = Average::default();
    average.add(&radii.first(), &basis);
    let mut last = Refinement::new(spec, average, &radii, &basis, &angles)?;
    if spec.droplets.single_radius().is_some() {
        return Ok(last.finish(spec, ReachedError { radii: 1, ..tolerance::ZERO }, radii.step()));
    }
    let mut reached = tolerance::ZERO;
    loop {
        let mut average = last.average.clone();
        average.add(&radii.halve(), &basis);
        let next = Refinement::new(spec, average, &radii, &basis, &angles)?;
        reached = next.summary.error(&last.summary, &reached, radii.count());
        progress(&reached, &next.phase);
        last = next;
        if radii.count() >= Radii::FEWEST && spec.tolerance.met_by(&reached) {
            return Ok(last.finish(spec, reached, radii.step()));
        }
        if 2 * radii.count() > spec.tolerance.most_radii {
            let reached = Box::new(reached);
            return Err(OpticsError::NotConverged { wavelength_um: spec.wavelength_um, reached });
        }
    }
}

impl Refinement {
    fn new(
        spec: &EnsembleSpec<'_>,
        average: Average,
        radii: &Radii<'_>,
        basis: &Basis,
        angles: &[f64],
    ) -> Result<Self, OpticsError> {
        let p = average.phase(basis);
        let coarse = radii.count() < Radii::FEWEST;
        let phase = PhaseTable::new(angles.to_vec(), p, if coarse { Norm::Any } else { Norm::Strict })?;
        let summary = tolerance::Summary::new(&phase, average.asymmetry(), spec.theta_f_deg)?;
        Ok(Self { average, phase, summary })
    }

    /// `step` turns the average's sums into integrals over the radius.
    fn finish(self, spec: &EnsembleSpec<'_>, reached: ReachedError, step: f64) -> Ensemble {
        let radius = spec.droplets.effective_radius();
        // N0 in 1/cm³ = 1e6/m³, cross-sections in µm² = 1e-12 m².
        let per_m = 1e-6 * spec.number_density_per_cm3;
        let extinction =
            Extinction { paper: per_m * PI * radius * radius, mie: per_m * step * self.average.extinction() };
        Ensemble {
            wavelength_um: spec.wavelength_um,
            refractive_index: spec.refractive_index,
            extinction,
            single_scattering_albedo: self.average.albedo(),
            asymmetry: self.average.asymmetry(),
            theta_f_deg: spec.theta_f_deg,
            forward_fraction: self.summary.forward_fraction,
            reached,
            phase: self.phase,
        }
    }
}
