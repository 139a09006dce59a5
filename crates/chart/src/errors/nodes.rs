//! Where the errors are known.

use std::f64::consts::PI;
use stratiform_artifact::{ErrorBlock, ErrorRow};
use stratiform_quantities::Side;

/// Red, green and blue; the methods are held against green.
pub const WAVELENGTHS_UM: [f64; 3] = [0.65, 0.55, 0.45];

/// The axes of the lattices.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// r_e.
    pub radii_um: Vec<f64>,
    /// Optical thickness of the full medium.
    pub tau: Vec<f64>,
    /// Sun.
    pub theta_l_deg: Vec<f64>,
    /// View.
    pub theta_v_deg: Vec<f64>,
    /// Azimuth.
    pub phi_deg: Vec<f64>,
    /// Θ of the glory.
    pub glory_deg: Vec<f64>,
    /// Θ of the fogbow.
    pub fogbow_deg: Vec<f64>,
    /// Θ of the silver lining.
    pub silver_lining_deg: Vec<f64>,
    /// Suns of R and T.
    pub flux_theta_l_deg: Vec<f64>,
}

impl Nodes {
    /// What is committed.
    pub fn full() -> Self {
        Self {
            radii_um: vec![4.0, 7.0, 12.0, 20.0],
            tau: vec![0.05, 0.25, 1.2, 6.0, 30.0, 160.0],
            theta_l_deg: vec![0.0, 35.0, 60.0, 76.0, 87.0],
            theta_v_deg: vec![0.0, 30.0, 55.0, 74.0, 87.0],
            phi_deg: vec![0.0, 60.0, 120.0, 180.0],
            glory_deg: vec![174.0, 176.0, 178.0, 179.0, 180.0],
            fogbow_deg: vec![135.0, 140.0, 145.0, 150.0],
            silver_lining_deg: vec![0.0, 2.0, 6.0, 12.0, 20.0],
            flux_theta_l_deg: (0..9).map(|i| f64::from(10 * i)).chain([87.0]).collect(),
        }
    }

    /// A few, for trials.
    pub fn small() -> Self {
        Self {
            radii_um: vec![7.0],
            tau: vec![0.1, 1.6, 25.0],
            theta_l_deg: vec![0.0, 52.0, 79.0],
            theta_v_deg: vec![0.0, 55.0, 79.0],
            phi_deg: vec![0.0, 90.0, 180.0],
            glory_deg: vec![174.0, 177.0, 180.0],
            fogbow_deg: vec![135.0, 142.0, 150.0],
            silver_lining_deg: vec![0.0, 7.0, 20.0],
            flux_theta_l_deg: vec![0.0, 52.0, 79.0],
        }
    }

    /// Whether red and blue are solved for that cloud: the one in the middle.
    pub(super) fn coloured(&self, place: usize) -> bool {
        place == (self.radii_um.len() - 1) / 2
    }

    /// The points of one sun: every view of every lattice of radiances, thickness left open.
    pub(super) fn views(&self, theta_l_deg: f64) -> Vec<Vec<Sighted>> {
        let mut grid = Vec::new();
        for side in Side::BOTH {
            for theta_v_deg in &self.theta_v_deg {
                let place = |phi| Sighted::new(ErrorBlock::Grid, theta_l_deg, *theta_v_deg, phi, side);
                grid.extend(self.phi_deg.iter().copied().map(place));
            }
        }
        let furthest = self.theta_v_deg.last().copied().unwrap_or(0.0);
        let in_plane = |block, phi, side, away: f64| {
            let beyond = theta_l_deg + away;
            let theta_v = if beyond <= furthest { beyond } else { theta_l_deg - away };
            Sighted::new(block, theta_l_deg, theta_v, phi, side)
        };
        let glory = self.glory_deg.iter().map(|at| in_plane(ErrorBlock::Glory, 180.0, Side::Top, 180.0 - at));
        let silver = self.silver_lining_deg.iter();
        let silver = silver.map(|at| in_plane(ErrorBlock::SilverLining, 0.0, Side::Bottom, *at));
        let mut bow = Vec::new();
        for theta_v_deg in &self.theta_v_deg {
            let at = |scattering: &f64| {
                let phi = azimuth(theta_l_deg, *theta_v_deg, *scattering)?;
                let sight = Sighted::new(ErrorBlock::Fogbow, theta_l_deg, *theta_v_deg, phi, Side::Top);
                Some(Sighted { scattering_deg: *scattering, ..sight })
            };
            bow.extend(self.fogbow_deg.iter().filter_map(at));
        }
        [grid, glory.collect(), silver.collect(), bow].into_iter().filter(|views| !views.is_empty()).collect()
    }

    /// A thinner lattice of the same.
    pub(super) fn thinner(&self) -> Self {
        let every = |axis: &[f64]| -> Vec<f64> {
            let last = axis.len() - 1;
            axis.iter()
                .enumerate()
                .filter(|(i, _)| (last - i).is_multiple_of(2) || *i == 0)
                .map(|(_, x)| *x)
                .collect()
        };
        Self {
            tau: every(&self.tau),
            theta_l_deg: every(&self.theta_l_deg),
            theta_v_deg: every(&self.theta_v_deg),
            phi_deg: every(&self.phi_deg),
            ..self.clone()
        }
    }
}

/// A direction with its scattering angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sighted {
    pub(super) block: ErrorBlock,
    pub(super) theta_l_deg: f64,
    pub(super) theta_v_deg: f64,
    pub(super) phi_deg: f64,
    pub(super) side: Side,
    pub(super) scattering_deg: f64,
}

impl Sighted {
    fn new(block: ErrorBlock, theta_l_deg: f64, theta_v_deg: f64, phi_deg: f64, side: Side) -> Self {
        let scattering_deg = scattering(theta_l_deg, theta_v_deg, phi_deg, side);
        Self { block, theta_l_deg, theta_v_deg, phi_deg, side, scattering_deg }
    }

    /// A row without truth and values.
    pub(super) fn row(&self, effective_radius_um: f64, tau: f64) -> ErrorRow {
        ErrorRow {
            block: self.block,
            effective_radius_um,
            tau,
            theta_l_deg: self.theta_l_deg,
            theta_v_deg: self.theta_v_deg,
            phi_deg: self.phi_deg,
            scattering_deg: self.scattering_deg,
            side: self.side,
            truth: None,
            values: Vec::new(),
        }
    }
}

/// Θ in degrees, to 0.001.
fn scattering(theta_l_deg: f64, theta_v_deg: f64, phi_deg: f64, side: Side) -> f64 {
    let [l, v, phi] = [theta_l_deg, theta_v_deg, phi_deg].map(f64::to_radians);
    let along = if side == Side::Top { -1.0 } else { 1.0 };
    let cosine = libm::sin(l) * libm::sin(v) * libm::cos(phi) + along * libm::cos(l) * libm::cos(v);
    (libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees() * 1000.0).round() / 1000.0
}

/// φ at which light leaving the top was turned by Θ; `None` where no azimuth does that.
fn azimuth(theta_l_deg: f64, theta_v_deg: f64, scattering_deg: f64) -> Option<f64> {
    let [l, v, turn] = [theta_l_deg, theta_v_deg, scattering_deg].map(f64::to_radians);
    let sines = libm::sin(l) * libm::sin(v);
    let cosine = (libm::cos(turn) + libm::cos(l) * libm::cos(v)) / sines;
    (sines > 1e-9 && cosine.abs() <= 1.0).then(|| libm::acos(cosine) * 180.0 / PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn effects_lie_at_their_angles() {
        for theta_l in Nodes::full().theta_l_deg {
            for sight in Nodes::full().views(theta_l).into_iter().flatten() {
                let angle = scattering(theta_l, sight.theta_v_deg, sight.phi_deg, sight.side);
                assert!((angle - sight.scattering_deg).abs() < 2e-3, "{sight:?}");
                let (low, high) = match sight.block {
                    ErrorBlock::Glory => (174.0, 180.0),
                    ErrorBlock::Fogbow => (135.0, 150.0),
                    ErrorBlock::SilverLining => (0.0, 20.0),
                    _ => (0.0, 180.0),
                };
                assert!((low..=high).contains(&sight.scattering_deg), "{sight:?}");
            }
        }
    }
}
