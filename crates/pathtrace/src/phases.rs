//! Three phase functions, one a channel: samples of their forward and wide parts, and their values.
//!
//! Θ < θ_f is a forward event, P_f its probability; Θ ≥ θ_f a wide one. Samples come from the parts' own inverse cumulatives, to 2⁻²³
//! in probability (`SamplingTable`). Values are linear on even steps of sin(Θ/2) below 90° and of cos(Θ/2) beyond, 0.02° wide, of the
//! exact values at the nodes: within 2e-3 of P below θ_f, where only ratios between channels use them and keep 1e-4, and within 1e-4 of P
//! elsewhere for functions as smooth as a cloud's at 0.02°.

use std::f64::consts::FRAC_1_SQRT_2;
use std::sync::Arc;
use stratiform_optics::OpticsError;
use stratiform_optics::phase::{PhaseFunction, PhaseTable, versine};
use stratiform_optics::sampling::SamplingTable;

const CELLS: usize = 4096;

/// The parts of one channel.
struct Channel {
    forward_fraction: f64,
    /// None if no light is scattered below θ_f.
    forward: Option<SamplingTable>,
    wide: SamplingTable,
}

impl Channel {
    fn new(phase: &PhaseTable, theta_f_deg: f64) -> Result<Self, OpticsError> {
        let forward_fraction = phase.forward_fraction(theta_f_deg)?;
        let table = |part: PhaseTable| SamplingTable::new(Arc::new(part));
        let forward = (forward_fraction > 0.0).then(|| phase.forward_part(theta_f_deg)).transpose()?;
        Ok(Self { forward_fraction, forward: forward.map(table), wide: table(phase.modified(theta_f_deg)?) })
    }
}

/// The channels.
pub(crate) struct Phases {
    channels: [Channel; 3],
    /// 1 - cosθ_f.
    pub(crate) edge: f64,
    /// Values of the three channels at steps of sin(Θ/2), then at steps of cos(Θ/2).
    values: [Vec<[f32; 4]>; 2],
}

impl Phases {
    pub(crate) fn new(colour: &[PhaseTable; 3], theta_f_deg: f64) -> Result<Self, OpticsError> {
        let [r, g, b] = colour.each_ref().map(|phase| Channel::new(phase, theta_f_deg));
        let at = |v: f64| {
            let [r, g, b] = colour.each_ref().map(|phase| phase.value(v) as f32);
            [r, g, b, 0.0]
        };
        let v = |i: usize| {
            let s = FRAC_1_SQRT_2 * i as f64 / CELLS as f64;
            2.0 * s * s
        };
        let values = [(0..=CELLS).map(|i| at(v(i))).collect(), (0..=CELLS).map(|i| at(2.0 - v(i))).collect()];
        Ok(Self { channels: [r?, g?, b?], edge: versine(theta_f_deg.to_radians()), values })
    }

    /// P_f of each channel.
    pub(crate) fn forward_fractions(&self) -> [f64; 3] {
        self.channels.each_ref().map(|channel| channel.forward_fraction)
    }

    /// 1 - cosΘ of a forward or a wide event of one channel.
    #[inline]
    pub(crate) fn sample(&self, channel: usize, forward: bool, bits: u32) -> f64 {
        let Channel { forward: peak, wide, .. } = &self.channels[channel];
        if forward { peak.as_ref().map_or(0.0, |peak| peak.sample(bits)) } else { wide.sample(bits) }
    }

    /// P of each channel at v = 1 - cosΘ.
    #[inline]
    pub(crate) fn values(&self, v: f64) -> [f64; 3] {
        let (half, v) = if v > 1.0 { (1, (2.0 - v).max(0.0)) } else { (0, v) };
        let place = v.sqrt() * CELLS as f64;
        let cell = (place as usize).min(CELLS - 1);
        let share = (place - cell as f64) as f32;
        let (left, right) = (self.values[half][cell], self.values[half][cell + 1]);
        std::array::from_fn(|c| f64::from(left[c] + (right[c] - left[c]) * share))
    }
}
