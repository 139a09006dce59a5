//! Fluxes through both faces of a slab from its radiance, around the direction of the sun.
//!
//! With f = πL/(μ_l F0) the flux per incident flux is (1/π)∫f μ_v dΩ, dΩ = sinΘ dΘ dψ, with Θ the scattering angle and ψ the
//! azimuth around the sun's direction: ±μ_v = μ_l cosΘ + sinθ_l sinΘ cosψ. The phase function changes with Θ alone,
//! where Gauss's rule runs over panels that end at θ_f, the edge of P_S; ψ has midpoints.
//!
//! Beside the phase functions, in which it is linear, radiance changes with μ_v alone and slowly. So the directions of one sun are gathered once in
//! narrow cells of μ_v, and every slab's radiance is asked for once per cell, at the mean μ_v and the mean phase functions:
//! exact for what is linear in μ_v over a cell. Forward (Θ < 90°) and backward directions have cells of their own, because the
//! paper's printed form tells them apart. Relative error below 3e-4.

use super::cut::Cut;
use stratiform_model::angular::{PhaseLookup, Sight};
use stratiform_optics::phase::{gauss_legendre, versine};
use stratiform_quantities::Side;

/// Panels below and beyond θ_f.
const PANELS: [usize; 2] = [8, 240];

/// Nodes per panel.
const NODES: usize = 4;

/// Azimuths between 0 and π.
const AZIMUTHS: usize = 180;

/// Cells between μ_v = 0 and 1, even in √μ_v: radiance of thin slabs changes fastest at the horizon.
const CELLS: usize = 1024;

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
    pub fn new(cut: &Cut, theta_f_deg: f64) -> Self {
        let edges = [0.0, theta_f_deg.to_radians(), std::f64::consts::PI];
        let rule = gauss_legendre(NODES);
        let mut nodes = Vec::new();
        for (part, panels) in edges.windows(2).zip(PANELS) {
            let half = 0.5 * (part[1] - part[0]) / panels as f64;
            for panel in 0..panels {
                nodes.extend(rule.iter().map(|(node, weight)| {
                    let theta = part[0] + half * ((2 * panel + 1) as f64 + node);
                    let functions = AtAngle { wide: cut.wide.at(theta), wide_squared: cut.squared.at(theta) };
                    (theta, weight * half * libm::sin(theta), functions)
                }));
            }
        }
        let psi = |k: usize| std::f64::consts::PI * (k as f64 + 0.5) / AZIMUTHS as f64;
        Self { nodes, cosines: (0..AZIMUTHS).map(|k| libm::cos(psi(k))).collect() }
    }

    /// The directions in which light of a sun at `mu_l` leaves.
    pub fn under(&self, mu_l: f64) -> Leaving {
        let mut faces = Side::BOTH.map(|side| (side, vec![Cell::default(); 2 * CELLS]));
        for (theta, weight, functions) in &self.nodes {
            // ψ counts twice: (1/π) · 2π/AZIMUTHS for each of the midpoints of half a turn.
            let weight = 2.0 * weight / AZIMUTHS as f64;
            let (along, across) = (mu_l * libm::cos(*theta), (1.0 - mu_l * mu_l).sqrt() * libm::sin(*theta));
            let half = if versine(*theta) < 1.0 { 0 } else { CELLS };
            for cosine in &self.cosines {
                let down = along + across * cosine;
                let face = faces.iter_mut().find(|(side, _)| (*side == Side::Bottom) == (down > 0.0));
                let mu_v = down.abs().min(1.0);
                let place = ((CELLS as f64 * mu_v.sqrt()) as usize).min(CELLS - 1);
                face.into_iter().for_each(|(_, cells)| cells[half + place].add(weight, mu_v, functions));
            }
        }
        Leaving { mu_l, faces }
    }
}

/// Sums over directions of nearly the same μ_v.
#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    /// dΩ/π.
    weight: f64,
    /// μ_v dΩ/π, by itself and times the phase functions.
    flux: f64,
    wide: f64,
    wide_squared: f64,
}

impl Cell {
    fn add(&mut self, weight: f64, mu_v: f64, functions: &AtAngle) {
        let flux = weight * mu_v;
        self.weight += weight;
        self.flux += flux;
        self.wide += flux * functions.wide;
        self.wide_squared += flux * functions.wide_squared;
    }

    fn functions(&self) -> AtAngle {
        AtAngle { wide: self.wide / self.flux, wide_squared: self.wide_squared / self.flux }
    }
}

/// Directions in which light of one sun leaves.
pub struct Leaving {
    mu_l: f64,
    /// Cells of forward, then of backward scattering angles.
    faces: [(Side, Vec<Cell>); 2],
}

impl Leaving {
    /// Fluxes through `side` of N radiances at once, each linear in the phase functions. Of a sight's v they see no more than on
    /// which side of 1 it lies.
    pub fn fluxes<const N: usize>(
        &self,
        side: Side,
        radiance: impl Fn(Sight<f64>, &AtAngle) -> [f64; N],
    ) -> [f64; N] {
        let mut fluxes = [0.0; N];
        for (_, cells) in self.faces.iter().filter(|(face, _)| *face == side) {
            for (k, cell) in cells.iter().enumerate().filter(|(_, cell)| cell.flux > 0.0) {
                let v = if k < CELLS { 0.0 } else { 2.0 };
                let sight = Sight { mu_l: self.mu_l, mu_v: (cell.flux / cell.weight).min(1.0), v, side };
                for (flux, factor) in fluxes.iter_mut().zip(radiance(sight, &cell.functions())) {
                    *flux += cell.flux * factor;
                }
            }
        }
        fluxes
    }
}
