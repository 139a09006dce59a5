//! Bevy's chromatic phase texture (`PhaseFunction::ChromaticTexture` of `bevy_light`'s `ScatteringMedium`).
//!
//! Contract, read in bevy_light, bevy_image and bevy_pbr 0.20: an N×1 texture of `Rgba32Float`, columns at equal steps of
//! μ from -1 (back) to 1 (forward), linear between, each of r, g, b a phase function per steradian (∫p dμ = 1/2π, so
//! P/4π); alpha is not read. The image must load as one-dimensional: KTX2 of height 1 does, EXR does not and is ignored
//! in silence. 8192 columns are the most that wgpu promises for such a texture.
//!
//! Bevy samples the curve at the centres of `phase_resolution` (256 by default) texels of s ∈ \[-1, 1\], with
//! μ = ±(1 - (1-|s|)²), and is linear in s between the centres and constant beyond them: that is what is reported. Set
//! `phase_resolution` as high as the peak needs.

use super::cosine::OverCosine;
use super::{PeerFile, worth};
use crate::TablesError;
use crate::card::Card;
use crate::colour::SrgbPhase;
use std::f64::consts::PI;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::Range;

/// Numbers of columns that are written.
pub const COLUMNS: Range = Range::closed(2.0, 8192.0);

/// Values of `phase_resolution`.
pub const RESOLUTION: Range = Range::closed(2.0, 8192.0);

/// The texels of `columns` columns, back to forward, for a medium with that `phase_resolution`; alpha is 1.
///
/// # Errors
/// [`TablesError::Domain`] unless `columns` and `phase_resolution` are in \[2, 8192\], and for a negative channel;
/// [`TablesError::Optics`] for one that is not normalised.
pub fn chromatic_texture(
    colour: &SrgbPhase,
    columns: usize,
    phase_resolution: usize,
) -> Result<PeerFile<Vec<[f32; 4]>>, TablesError> {
    COLUMNS.check("columns of the phase texture", columns as f64)?;
    RESOLUTION.check("phase_resolution", phase_resolution as f64)?;
    let (least, theta_deg) = colour.smallest_channel();
    Range::at_least(0.0).check(&format!("channel of linear sRGB at {theta_deg} degrees"), least)?;
    let mut content = vec![[1.0; 4]; columns];
    let mut cards = Vec::with_capacity(3);
    for channel in 0..3 {
        let p = colour.rgb.iter().map(|rgb| rgb[channel]).collect();
        let table = PhaseTable::new(colour.theta_deg.clone(), p, Norm::Strict)?;
        let over = OverCosine::equidistant(&table, columns);
        content.iter_mut().zip(&over.p).for_each(|(texel, p)| texel[channel] = (p / (4.0 * PI)) as f32);
        cards.push(Lookup::new(&over, phase_resolution).card(&table));
    }
    Ok(PeerFile { content, values: columns, cards })
}

/// Bevy's own table: P at the texels' centres, from back to forward.
struct Lookup {
    p: Vec<f64>,
}

impl Lookup {
    fn new(over: &OverCosine, resolution: usize) -> Self {
        let centre = |j: usize| (2 * j + 1) as f64 / resolution as f64 - 1.0;
        Self { p: (0..resolution).map(|j| over.at(angle(centre(j)))).collect() }
    }

    /// P at s.
    fn at(&self, s: f64) -> f64 {
        let last = self.p.len() - 1;
        let place = (0.5 * (1.0 + s) * self.p.len() as f64 - 0.5).clamp(0.0, last as f64);
        let j = (place as usize).min(last - 1);
        self.p[j] + (place - j as f64) * (self.p[j + 1] - self.p[j])
    }

    /// The look-up is smooth between the centres.
    fn card(&self, source: &PhaseTable) -> Card {
        let centre = |j: usize| (2 * j + 1) as f64 / self.p.len() as f64 - 1.0;
        let nodes: Vec<f64> = (0..self.p.len()).rev().map(|j| angle(centre(j)).to_degrees()).collect();
        let nodes = [vec![0.0], nodes, vec![180.0]].concat();
        worth::card(source, &nodes, |theta| self.at(coordinate(theta)))
    }
}

/// Θ of s, radians.
fn angle(s: f64) -> f64 {
    let rest = 1.0 - s.abs();
    let theta = 2.0 * libm::asin((0.5 * rest * rest).sqrt());
    if s < 0.0 { PI - theta } else { theta }
}

/// s of Θ.
fn coordinate(theta: f64) -> f64 {
    let sine = libm::sin(0.5 * theta.min(PI - theta));
    let s = 1.0 - 2.0_f64.sqrt() * sine;
    if theta > 0.5 * PI { -s } else { s }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angle_and_coordinate_are_inverse_and_bevys() {
        for k in 0..=40 {
            let s = f64::from(k) / 20.0 - 1.0;
            assert!((coordinate(angle(s)) - s).abs() < 1e-12, "{s}");
            // As `bevy_pbr` 0.20 writes it.
            let mu = s.signum() * (1.0 - (1.0 - s.abs()) * (1.0 - s.abs()));
            assert!((libm::cos(angle(s)) - mu).abs() < 1e-12, "{s}");
        }
    }
}
