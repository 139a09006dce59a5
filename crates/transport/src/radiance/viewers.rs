//! What one collision sends to every viewer, with all that viewers share worked out once.

use crate::TraceMedium;
use crate::solve::View;
use glam::DVec3;
use std::ops::Range;
use stratiform_quantities::Side;

/// All viewers of a trace.
pub(super) struct Viewers {
    sights: Vec<Sight>,
    /// Faces with cosines of exit, each pair once.
    exits: Vec<(Side, f64)>,
    /// Directions of flight that reach a viewer.
    directions: Vec<DVec3>,
}

/// One viewer.
struct Sight {
    /// Number of its exit.
    exit: usize,
    /// Its direction, and that of the mirror image at -φ unless it is the same.
    directions: Range<usize>,
}

/// What is seen of one collision.
#[derive(Default)]
pub(super) struct Seen {
    /// ω/4 · e^{-s}/μ for each exit.
    arrives: Vec<f64>,
    /// P for each direction.
    phase: Vec<f64>,
}

impl Viewers {
    pub fn new(views: &[View]) -> Self {
        let mut all = Self { sights: Vec::new(), exits: Vec::new(), directions: Vec::new() };
        views.iter().for_each(|view| all.add(view));
        all
    }

    fn add(&mut self, view: &View) {
        let known = self.exits.iter().position(|exit| *exit == (view.side, view.mu));
        let exit = known.unwrap_or_else(|| {
            self.exits.push((view.side, view.mu));
            self.exits.len() - 1
        });
        let first = self.directions.len();
        let sine = (1.0 - view.mu * view.mu).sqrt();
        // Beyond 180° mirror images, so that exact multiples of 180° stay in the principal plane.
        let turned = 180.0 - (view.phi_deg.abs() - 180.0).abs();
        let phi = turned.to_radians();
        let z = if view.side == Side::Top { -view.mu } else { view.mu };
        let across = if turned == 180.0 { 0.0 } else { sine * libm::sin(phi) };
        let to = DVec3::new(sine * libm::cos(phi), across, z);
        let mirror = (across != 0.0).then(|| DVec3::new(to.x, -to.y, to.z));
        self.directions.extend([to].into_iter().chain(mirror));
        self.sights.push(Sight { exit, directions: first..self.directions.len() });
    }

    pub fn len(&self) -> usize {
        self.sights.len()
    }

    /// Looks at light that flies along `from` before it is scattered at `depths` below the top and above the bottom.
    pub fn look(&self, medium: &TraceMedium, from: DVec3, depths: [f64; 2], seen: &mut Seen) {
        let arrives = |(side, mu): &(Side, f64)| {
            let way = if *side == Side::Top { depths[0] } else { depths[1] };
            0.25 * medium.albedo() / mu * libm::exp(-way / mu)
        };
        seen.arrives.clear();
        seen.arrives.extend(self.exits.iter().map(arrives));
        seen.phase.clear();
        seen.phase.extend(self.directions.iter().map(|to| (0.5 * (from - *to).length_squared()).min(2.0)));
        medium.phase().values_at(&mut seen.phase);
    }

    /// What the viewer's reflectance factor gains: ωP/4 · e^{-s}/μ, P the mean of both azimuths.
    pub fn score(&self, view: usize, seen: &Seen) -> f64 {
        let Sight { exit, directions } = &self.sights[view];
        let phase = &seen.phase[directions.clone()];
        let sum = phase.iter().fold(0.0, |sum, p| sum + p);
        seen.arrives[*exit] * sum / phase.len() as f64
    }

    /// The gain if P were `peak`, or what was seen if that is more.
    pub fn largest(&self, view: usize, peak: f64, seen: &Seen) -> f64 {
        (seen.arrives[self.sights[view].exit] * peak).max(self.score(view, seen))
    }
}
