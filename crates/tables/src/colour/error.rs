//! How far a colour from few wavelengths may be off.
//!
//! Every second wavelength is left out (the ends stay) and the colour compared with that from all. P is taken as linear
//! between wavelengths, so where it is smooth in λ halving the spacing divides the error by four, and the difference is
//! three times the error of the full set; where it oscillates with λ the difference is no bound.

use super::{SrgbPhase, srgb_phase};
use crate::TablesError;
use stratiform_optics::phase::PhaseTable;

/// What leaving out every second wavelength changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColourError {
    /// Wavelengths that were kept.
    pub kept: usize,
    /// Largest change of a channel over the luminance Y = 0.2126 r + 0.7152 g + 0.0722 b.
    pub largest: f64,
    /// Where, degrees.
    pub theta_deg: f64,
}

/// The change, or none for fewer than five wavelengths: less than three would be left.
///
/// # Errors
/// Those of [`srgb_phase`].
pub fn colour_error(spectrum: &[(f64, PhaseTable)]) -> Result<Option<ColourError>, TablesError> {
    let full = srgb_phase(spectrum)?;
    if spectrum.len() < 5 {
        return Ok(None);
    }
    let last = spectrum.len() - 1;
    let keep = |i: &usize| i.is_multiple_of(2) || *i == last;
    let kept: Vec<(f64, PhaseTable)> = (0..=last).filter(keep).map(|i| spectrum[i].clone()).collect();
    Ok(Some(largest_change(&full, &srgb_phase(&kept)?, kept.len())))
}

/// Both are compared where the coarser has nodes and light is scattered at all.
fn largest_change(full: &SrgbPhase, coarse: &SrgbPhase, kept: usize) -> ColourError {
    let mut found = ColourError { kept, largest: 0.0, theta_deg: 0.0 };
    let mut nodes = full.theta_deg.iter().zip(&full.rgb);
    for (theta, rgb) in coarse.theta_deg.iter().zip(&coarse.rgb) {
        let Some((_, of)) = nodes.find(|(node, _)| *node == theta) else { break };
        let luminance = 0.2126 * of[0] + 0.7152 * of[1] + 0.0722 * of[2];
        let change = (0..3).fold(0.0, |most: f64, c| most.max((rgb[c] - of[c]).abs()));
        if luminance > 0.0 && change > found.largest * luminance {
            found = ColourError { kept, largest: change / luminance, theta_deg: *theta };
        }
    }
    found
}
