//! Flux through one face of a slab from its radiance, around the direction of the sun.
//!
//! With f = πL/(μ_l F0) the flux per incident flux is (1/π)∫f μ_v dΩ, dΩ = sinΘ dΘ dψ, with Θ the scattering angle and ψ the
//! azimuth around the sun's direction: μ_v = ±(μ_l cosΘ + sinθ_l sinΘ cosψ). The phase function changes with Θ alone,
//! where Gauss's rule runs over panels that end at θ_f, the edge of P_S; ψ has midpoints. Relative error below 3e-4.

use stratiform_model::angular::{PhaseLookup, Sight};
use stratiform_optics::phase::{PhaseTable, gauss_legendre, versine};
use stratiform_quantities::Side;

/// Panels below and beyond θ_f.
const PANELS: [usize; 2] = [8, 240];

/// Nodes per panel.
const NODES: usize = 4;

/// Azimuths between 0 and π.
const AZIMUTHS: usize = 180;

/// The modified medium's phase functions at one angle.
#[derive(Clone, Copy, Debug)]
pub struct AtAngle {
    wide: f64,
    wide_squared: f64,
}

impl PhaseLookup<f64> for AtAngle {
    /// P_S again: nothing that is integrated here looks up P.
    fn full(&self, _: f64) -> f64 {
        self.wide
    }

    fn wide(&self, _: f64) -> f64 {
        self.wide
    }

    fn wide_squared(&self, _: f64) -> f64 {
        self.wide_squared
    }
}

/// Nodes over all scattering angles.
pub struct Hemisphere {
    /// Θ, weight sinΘ dΘ, and the functions there.
    nodes: Vec<(f64, f64, AtAngle)>,
    /// cosψ of the azimuths.
    cosines: Vec<f64>,
}

impl Hemisphere {
    /// Nodes for a P_S cut at `theta_f_deg`, and for its square.
    pub fn new(wide: &PhaseTable, wide_squared: &PhaseTable, theta_f_deg: f64) -> Self {
        let edges = [0.0, theta_f_deg.to_radians(), std::f64::consts::PI];
        let rule = gauss_legendre(NODES);
        let mut nodes = Vec::new();
        for (part, panels) in edges.windows(2).zip(PANELS) {
            let half = 0.5 * (part[1] - part[0]) / panels as f64;
            for panel in 0..panels {
                nodes.extend(rule.iter().map(|(node, weight)| {
                    let theta = part[0] + half * ((2 * panel + 1) as f64 + node);
                    let functions = AtAngle { wide: wide.at(theta), wide_squared: wide_squared.at(theta) };
                    (theta, weight * half * libm::sin(theta), functions)
                }));
            }
        }
        let psi = |k: usize| std::f64::consts::PI * (k as f64 + 0.5) / AZIMUTHS as f64;
        Self { nodes, cosines: (0..AZIMUTHS).map(|k| libm::cos(psi(k))).collect() }
    }

    /// Fluxes through `side` of N radiances at once.
    pub fn fluxes<const N: usize>(
        &self,
        mu_l: f64,
        side: Side,
        radiance: impl Fn(Sight<f64>, &AtAngle) -> [f64; N],
    ) -> [f64; N] {
        let mut fluxes = [0.0; N];
        for (theta, weight, functions) in &self.nodes {
            // ψ counts twice: (1/π) · 2π/AZIMUTHS for each of the midpoints of half a turn.
            let weight = 2.0 * weight / AZIMUTHS as f64;
            for mu_v in self.leaving(mu_l, *theta, side).filter(|mu_v| *mu_v > 0.0) {
                let sight = Sight { mu_l, mu_v: mu_v.min(1.0), v: versine(*theta), side };
                for (flux, factor) in fluxes.iter_mut().zip(radiance(sight, functions)) {
                    *flux += weight * mu_v * factor;
                }
            }
        }
        fluxes
    }

    /// Cosines to the normal of `side` around the sun's direction at `theta`; negative where light leaves the other face.
    fn leaving(&self, mu_l: f64, theta: f64, side: Side) -> impl Iterator<Item = f64> {
        let sign = if side == Side::Top { -1.0 } else { 1.0 };
        let (along, across) = (mu_l * libm::cos(theta), (1.0 - mu_l * mu_l).sqrt() * libm::sin(theta));
        self.cosines.iter().map(move |cosine| sign * (along + across * cosine))
    }
}
