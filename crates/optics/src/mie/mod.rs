//! Scattering by one homogeneous sphere (Mie 1908; notation of Bohren & Huffman 1983, chapter 4).
//!
//! Size parameter x = 2πr/λ ∈ \[1e-3, 1e5\], relative index m = n + ik with k ≥ 0 absorbing. Efficiencies are
//! cross-sections over πr²; S1 and S2 have Bohren and Huffman's sign (Wiscombe's are the complex conjugates).
//! The series ends a few terms after Wiscombe's order (1980, eq. 31). `tests/mie.rs`
//! holds efficiencies and amplitudes against published tables and a 40-digit sum.

mod amplitudes;
mod coefficients;
pub mod document;
mod domain;
mod efficiencies;
mod lanes;

pub use amplitudes::{Amplitudes, amplitudes};
pub use coefficients::{Coefficients, last_order};
pub use domain::{RefractiveIndex, ScatteringAngle, SizeParameter};
pub use efficiencies::{Efficiencies, efficiencies};
pub use lanes::{LANES, LaneCoefficients, Lanes};

use stratiform_quantities::DomainError;

/// What one sphere does to light.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereScattering {
    /// Cross-sections over πr², and g.
    pub efficiencies: Efficiencies,
    /// S1, S2 at the angles asked for, in their order.
    pub amplitudes: Vec<Amplitudes>,
}

/// Scattering by the sphere of size parameter `x` and index `m` = \[n, k\] at `angles_deg`.
///
/// # Errors
/// [`DomainError`] for a size parameter, an index or an angle out of domain.
pub fn scatter(x: f64, m: [f64; 2], angles_deg: &[f64]) -> Result<SphereScattering, DomainError> {
    let (x, m) = (SizeParameter::new(x)?, RefractiveIndex::new(m[0], m[1])?);
    let angles =
        angles_deg.iter().map(|&t| ScatteringAngle::from_degrees(t)).collect::<Result<Vec<_>, _>>()?;
    let coefficients = Coefficients::new(x, m);
    Ok(SphereScattering {
        efficiencies: efficiencies(x, &coefficients),
        amplitudes: angles.into_iter().map(|angle| amplitudes(&coefficients, angle)).collect(),
    })
}
