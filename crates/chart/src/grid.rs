//! Where in a scene's ranges is sampled: every combination of a few values of each.

use stratiform_methods::{FluxPoint, Point};
use stratiform_quantities::Side;
use stratiform_scene::{Interval, Scene};
use stratiform_transport::solve::View;

/// How many values each range gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Density {
    /// Of θ_l.
    pub suns: usize,
    /// Of κH.
    pub thicknesses: usize,
    /// Of θ_v.
    pub views: usize,
    /// Of φ.
    pub azimuths: usize,
}

impl Density {
    /// For a scene's main cloud.
    pub const FULL: Self = Self { suns: 4, thicknesses: 4, views: 5, azimuths: 5 };
    /// For its other droplets and wavelengths.
    pub const THIN: Self = Self { suns: 2, thicknesses: 3, views: 3, azimuths: 3 };
    /// For a quick look.
    pub const QUICK: Self = Self { suns: 1, thicknesses: 2, views: 2, azimuths: 2 };
}

/// The values of each range.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// κH.
    pub tau: Vec<f64>,
    /// θ_l.
    pub theta_l_deg: Vec<f64>,
    /// θ_v.
    pub theta_v_deg: Vec<f64>,
    /// φ.
    pub phi_deg: Vec<f64>,
    /// The faces.
    pub sides: Vec<Side>,
}

impl Grid {
    /// Values of a scene's ranges: equal steps of angles, equal ratios of thickness.
    pub fn new(scene: &Scene, tau: Interval, density: Density) -> Self {
        Self {
            tau: tau.geometric(density.thicknesses, libm::pow),
            theta_l_deg: scene.sun.theta_deg.linear(density.suns),
            theta_v_deg: scene.view.theta_deg.linear(density.views),
            phi_deg: scene.view.azimuth_deg.linear(density.azimuths),
            sides: scene.view.sides.clone(),
        }
    }

    /// μ_l.
    pub fn mu_l(&self) -> Vec<f64> {
        self.theta_l_deg.iter().copied().map(cosine).collect()
    }

    /// Every direction: azimuths inside angles inside faces.
    pub fn views(&self) -> Vec<View> {
        let mut views = Vec::new();
        for &side in &self.sides {
            for mu in self.theta_v_deg.iter().copied().map(cosine) {
                views.extend(self.phi_deg.iter().map(|&phi_deg| View { side, mu, phi_deg }));
            }
        }
        views
    }

    /// Every radiance: views inside thicknesses inside suns.
    pub fn points(&self) -> Vec<Point> {
        let views = self.views();
        let mut points = Vec::new();
        for FluxPoint { tau, mu_l } in self.flux_points() {
            points.extend(views.iter().map(|v| Point {
                tau,
                mu_l,
                mu_v: v.mu,
                phi_deg: v.phi_deg,
                side: v.side,
            }));
        }
        points
    }

    /// Every pair of fluxes: thicknesses inside suns.
    pub fn flux_points(&self) -> Vec<FluxPoint> {
        let suns = self.mu_l();
        suns.iter().flat_map(|&mu_l| self.tau.iter().map(move |&tau| FluxPoint { tau, mu_l })).collect()
    }
}

fn cosine(theta_deg: f64) -> f64 {
    libm::cos(theta_deg.to_radians())
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_scene::named;

    #[test]
    fn points_are_every_combination_in_the_order_of_the_truth() {
        let scene = named("thin-veil").unwrap();
        let grid = Grid::new(&scene, Interval { min: 0.1, max: 10.0 }, Density::THIN);
        let (points, views) = (grid.points(), grid.views());
        assert_eq!((points.len(), views.len()), (2 * 3 * 2 * 3 * 3, 2 * 3 * 3));
        assert!((grid.tau[1] - 1.0).abs() < 1e-14 && grid.tau[2] == 10.0);
        let second = &points[views.len() + 1];
        assert_eq!((second.tau, second.mu_v, second.phi_deg), (grid.tau[1], views[1].mu, views[1].phi_deg));
    }
}
