//! Phase functions in linear sRGB, through the CIE 1931 colour matching functions.
//!
//! XYZ(Θ) = Σ P(Θ, λ) S(λ) x̄ȳz̄(λ) over 0.36–0.83 µm in steps of 1 nm, S = D65; then IEC 61966-2-1's matrix.
//! P at a fixed Θ is linear in λ between the given wavelengths and constant beyond them.
//!
//! White balance: D65 is white. Each channel is divided by its value for P = 1, so a phase function that does not depend
//! on λ gives r = g = b = P exactly. (By the standard's rounded matrix D65 is white to 5e-4 already.) Every channel
//! is normalised like P. Channels can be negative where the colour is outside sRGB's gamut; they stay, and
//! [`SrgbPhase::smallest_channel`] tells. Extinction and albedo are not in P: multiply by them if they depend on λ.

mod error;
mod observer;

pub use error::{ColourError, colour_error};

use crate::TablesError;
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::Range;

/// Wavelengths that the observer sees, µm.
pub const VISIBLE_UM: Range = Range::closed(0.36, 0.83);

/// Fewer wavelengths than three show no colour.
const COUNT: Range = Range::at_least(3.0);

/// A phase function's three channels, piecewise linear in Θ like the tables it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct SrgbPhase {
    /// Θ, degrees: every node of every table; a repeated node is a jump.
    pub theta_deg: Vec<f64>,
    /// Linear sRGB at each node.
    pub rgb: Vec<[f64; 3]>,
}

impl SrgbPhase {
    /// The smallest channel and its Θ in degrees; negative where the colour is outside sRGB's gamut.
    pub fn smallest_channel(&self) -> (f64, f64) {
        let smallest = |rgb: &[f64; 3]| rgb[0].min(rgb[1]).min(rgb[2]);
        let nodes = self.theta_deg.iter().zip(&self.rgb).map(|(theta, rgb)| (smallest(rgb), *theta));
        nodes.fold((f64::INFINITY, 0.0), |least, node| if node.0 < least.0 { node } else { least })
    }

    /// Linear sRGB at Θ ∈ \[0°, 180°\]; at a jump the value on its right.
    pub fn at(&self, theta_deg: f64) -> [f64; 3] {
        let right = self.theta_deg.partition_point(|t| *t <= theta_deg).clamp(1, self.theta_deg.len() - 1);
        let (a, b) = (self.rgb[right - 1], self.rgb[right]);
        let width = self.theta_deg[right] - self.theta_deg[right - 1];
        let t = if width > 0.0 { (theta_deg - self.theta_deg[right - 1]) / width } else { 1.0 };
        std::array::from_fn(|c| a[c] + t * (b[c] - a[c]))
    }
}

/// The colour of phase functions given at ascending wavelengths in µm.
///
/// # Errors
/// [`TablesError::Domain`] for fewer than three wavelengths, one outside \[0.36, 0.83\] µm, or one not above the one before.
pub fn srgb_phase(spectrum: &[(f64, PhaseTable)]) -> Result<SrgbPhase, TablesError> {
    let wavelengths: Vec<f64> = spectrum.iter().map(|(wavelength, _)| *wavelength).collect();
    check_wavelengths(&wavelengths)?;
    let weights = weights(&wavelengths);
    let nodes = common_nodes(spectrum);
    let values: Vec<Vec<f64>> = spectrum.iter().map(|(_, table)| at_nodes(table, &nodes)).collect();
    let rgb = (0..nodes.len()).map(|i| mix(&weights, |k| values[k][i])).collect();
    Ok(SrgbPhase { theta_deg: nodes.iter().map(|node| node.theta_deg).collect(), rgb })
}

/// Whether phase functions at `wavelengths_um` have a colour.
///
/// # Errors
/// Those of [`srgb_phase`].
pub fn check_wavelengths(wavelengths_um: &[f64]) -> Result<(), TablesError> {
    COUNT.check("wavelengths of a colour", wavelengths_um.len() as f64)?;
    let mut last = f64::NEG_INFINITY;
    for wavelength in wavelengths_um {
        VISIBLE_UM.check("wavelength_um", *wavelength)?;
        let ascending = Range { min: last, min_included: false, ..VISIBLE_UM };
        last = ascending.check("wavelength_um (ascending)", *wavelength)?;
    }
    Ok(())
}

/// What a spectrum at `wavelengths_um` adds to linear sRGB, with D65 as white: a channel is Σ w_k S(λ_k), and 1 for S = 1.
///
/// # Errors
/// Those of [`srgb_phase`].
pub fn channel_weights(wavelengths_um: &[f64]) -> Result<Vec<[f64; 3]>, TablesError> {
    check_wavelengths(wavelengths_um)?;
    Ok(weights(wavelengths_um))
}

/// What each given wavelength adds to each channel; the weights of a channel add up to 1.
fn weights(wavelengths: &[f64]) -> Vec<[f64; 3]> {
    let mut weights = vec![[0.0; 3]; wavelengths.len()];
    for band in observer::bands() {
        let x = band.wavelength_um;
        let right = wavelengths.partition_point(|w| *w < x).clamp(1, wavelengths.len() - 1);
        let (left, step) = (wavelengths[right - 1], wavelengths[right] - wavelengths[right - 1]);
        let t = ((x - left) / step).clamp(0.0, 1.0);
        for (c, weight) in band.weight.iter().enumerate() {
            weights[right - 1][c] += (1.0 - t) * weight;
            weights[right][c] += t * weight;
        }
    }
    weights
}

/// Σ w_k P_k, as P_0 + Σ w_k (P_k - P_0): equal P_k come out exactly.
fn mix(weights: &[[f64; 3]], p: impl Fn(usize) -> f64) -> [f64; 3] {
    let first = p(0);
    let channel = |c: usize| {
        weights.iter().enumerate().fold(first, |sum, (k, weight)| sum + weight[c] * (p(k) - first))
    };
    std::array::from_fn(channel)
}

/// An angle at which some table has a node, and whether the value on its left is meant.
#[derive(Clone, Copy, PartialEq)]
struct Node {
    theta_deg: f64,
    left: bool,
}

/// The nodes of all tables, ascending; an angle at which a table jumps stands twice.
fn common_nodes(spectrum: &[(f64, PhaseTable)]) -> Vec<Node> {
    let of_table = |table: &PhaseTable| {
        let theta = table.theta_deg();
        let jump = |i: usize| theta.get(i + 1) == Some(&theta[i]);
        (0..theta.len()).map(|i| Node { theta_deg: theta[i], left: jump(i) }).collect::<Vec<_>>()
    };
    let mut nodes: Vec<Node> = spectrum.iter().flat_map(|(_, table)| of_table(table)).collect();
    nodes.sort_by(|a, b| a.theta_deg.total_cmp(&b.theta_deg).then(b.left.cmp(&a.left)));
    nodes.dedup();
    nodes
}

fn at_nodes(table: &PhaseTable, nodes: &[Node]) -> Vec<f64> {
    let theta = table.theta_deg();
    let value = |node: &Node| {
        let i = theta.partition_point(|t| *t < node.theta_deg);
        let own = theta.get(i) == Some(&node.theta_deg);
        if own && (node.left || theta.get(i + 1) != Some(&node.theta_deg)) {
            table.values()[i]
        } else {
            table.at(node.theta_deg.to_radians())
        }
    };
    nodes.iter().map(value).collect()
}
