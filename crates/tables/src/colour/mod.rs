//! Phase functions in linear sRGB, through the CIE 1931 colour matching functions.
//!
//! XYZ(Θ) = Σ P(Θ, λ) S(λ) x̄ȳz̄(λ) over 0.36–0.83 µm in steps of 5 nm, S = D65; then IEC 61966-2-1's matrix.
//! P at a fixed Θ is linear in λ between the given wavelengths and constant beyond them.
//!
//! White balance: D65 is white. Each channel is divided by its value for P = 1, so a phase function that does not depend
//! on λ gives r = g = b = P exactly. (By the standard's rounded matrix D65 is white to 4e-4 already.)
//! Channels can be negative where the colour is outside sRGB's gamut; they stay, and
//! [`SrgbPhase::smallest_channel`] tells. Extinction and albedo are not in P: multiply by them if they depend on λ.

use crate::TablesError;
use stratiform_optics::phase::PhaseTable;

/// A phase function's three channels, piecewise linear in Θ like the tables it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct SrgbPhase {
    /// Θ, degrees: every node of every table; a repeated node is a jump.
    pub theta_deg: Vec<f64>,
    /// Linear sRGB at each node.
    pub rgb: Vec<[f64; 3]>,
}

/// The colour of phase functions given at ascending wavelengths in µm.
///
/// # Errors
/// [`TablesError::Domain`] for fewer than three wavelengths, one outside \[0.36, 0.83\] µm, or one not above the one before.
pub fn srgb_phase(_spectrum: &[(f64, PhaseTable)]) -> Result<SrgbPhase, TablesError> {
    Err(TablesError::Container { format: "sRGB", reason: "not yet".to_owned() })
}
