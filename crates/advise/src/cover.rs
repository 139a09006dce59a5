//! Points that stand for a scene.
//!
//! The r-th point of Halton's sequence (Halton 1960), bases 2, 3, 5, 7, 11: uniform in the logarithms of r_e and thickness, in the
//! angles of sun and view, in azimuth and in the faces seen. For an effect the same, kept where Θ lies in its window.

use stratiform_artifact::ErrorBlock;
use stratiform_quantities::Side;
use stratiform_scene::{Effect, Interval, Scene};

/// Points of a population.
const POINTS: usize = 600;

/// Points that are tried for those of an effect.
const TRIED: usize = 30_000;

/// Fewer are no effect within the ranges.
const FEWEST: usize = 10;

/// Where an effect is seen: block, face, and Θ in degrees.
pub const WINDOWS: [(Effect, ErrorBlock, Side, Interval); 3] = [
    (Effect::Glory, ErrorBlock::Glory, Side::Top, Interval { min: 174.0, max: 180.0 }),
    (Effect::Fogbow, ErrorBlock::Fogbow, Side::Top, Interval { min: 135.0, max: 150.0 }),
    (Effect::SilverLining, ErrorBlock::SilverLining, Side::Bottom, Interval { min: 0.0, max: 20.0 }),
];

/// A place where an error is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ask {
    /// r_e.
    pub effective_radius_um: f64,
    /// Optical thickness.
    pub tau: f64,
    /// Sun.
    pub theta_l_deg: f64,
    /// View.
    pub theta_v_deg: f64,
    /// Azimuth.
    pub phi_deg: f64,
    /// Θ.
    pub scattering_deg: f64,
    /// Face.
    pub side: Side,
}

impl Ask {
    /// A place in the scene from five numbers in \[0, 1); `turn` chooses the face.
    pub fn within(scene: &Scene, tau: Interval, share: [f64; 5], turn: usize) -> Self {
        let linear = |range: Interval, share: f64| range.min + share * (range.max - range.min);
        let even = |range: Interval, share: f64| range.min * libm::pow(range.max / range.min, share);
        let mut ask = Self {
            effective_radius_um: even(scene.droplets.effective_radius_um, share[0]),
            tau: even(tau, share[1]),
            theta_l_deg: linear(scene.sun.theta_deg, share[2]),
            theta_v_deg: linear(scene.view.theta_deg, share[3]),
            phi_deg: linear(scene.view.azimuth_deg, share[4]),
            scattering_deg: 0.0,
            side: scene.view.sides[turn % scene.view.sides.len()],
        };
        ask.scattering_deg = ask.scattering();
        ask
    }

    fn scattering(&self) -> f64 {
        let [l, v, phi] = [self.theta_l_deg, self.theta_v_deg, self.phi_deg].map(f64::to_radians);
        let along = if self.side == Side::Top { -1.0 } else { 1.0 };
        let cosine = libm::sin(l) * libm::sin(v) * libm::cos(phi) + along * libm::cos(l) * libm::cos(v);
        libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees()
    }
}

/// Points of a scene as a whole, or of an effect.
#[derive(Clone, Debug)]
pub struct Population {
    /// The effect; `None` for the whole.
    pub effect: Option<Effect>,
    /// Whose lattice answers.
    pub block: ErrorBlock,
    /// Where.
    pub asks: Vec<Ask>,
}

/// The window of an effect; `None` for the ground's light, which has no direction.
pub fn window(effect: Effect) -> Option<(ErrorBlock, Side, Interval)> {
    WINDOWS.iter().find(|row| row.0 == effect).map(|(_, block, side, window)| (*block, *side, *window))
}

/// The whole scene, and each visible effect that its ranges show; and the effects that they do not.
pub(crate) fn populations(scene: &Scene, tau: Interval) -> (Vec<Population>, Vec<Effect>) {
    let at = |i: usize| Ask::within(scene, tau, halton(i as u32 + 1), i);
    let whole = Population { effect: None, block: ErrorBlock::Grid, asks: (0..POINTS).map(at).collect() };
    let (mut populations, mut unseen) = (vec![whole], Vec::new());
    for effect in &scene.visible {
        let Some((block, side, window)) = window(*effect) else { continue };
        let seen = |ask: &Ask| ask.side == side && window.contains(ask.scattering_deg);
        let asks: Vec<Ask> = (0..TRIED).map(at).filter(seen).take(POINTS).collect();
        if asks.len() < FEWEST {
            unseen.push(*effect);
        } else {
            populations.push(Population { effect: Some(*effect), block, asks });
        }
    }
    (populations, unseen)
}

/// R and T under every sun of the data: what goes between cloud and ground comes from everywhere.
pub(crate) fn fluxes(scene: &Scene, tau: Interval, furthest: f64) -> Population {
    let at = |i: usize| {
        let share = halton(i as u32 + 1);
        let ask = Ask::within(scene, tau, share, i);
        Ask { theta_l_deg: share[2] * furthest, side: Side::BOTH[i % 2], ..ask }
    };
    Population {
        effect: Some(Effect::GroundBounce),
        block: ErrorBlock::Flux,
        asks: (0..POINTS).map(at).collect(),
    }
}

/// The i-th point of Halton's sequence.
pub(crate) fn halton(i: u32) -> [f64; 5] {
    [2, 3, 5, 7, 11].map(|base| {
        let (mut rest, mut scale, mut value) = (i, 1.0, 0.0);
        while rest > 0 {
            scale /= f64::from(base);
            value += scale * f64::from(rest % base);
            rest /= base;
        }
        value
    })
}
