//! Radiance at given directions, by local estimates.

use super::RadianceRequest;
use super::request::{orders, row_of};
use super::rounds;
use super::score::Score;
use crate::solve::View;
use crate::walk::{Collision, Walk, sunbeam};
use crate::{Control, TraceMedium, TransportError};
use glam::DVec3;
use stratiform_optics::phase::{PhaseFunction, versine};
use stratiform_quantities::{Order, Range, Side};
use stratiform_stats::{Estimate, Purpose, key, photon_stream};

/// Events of the largest possible score that the scatter met must exceed before its size is trusted.
const EVENTS: f64 = 3.0;

/// Traces radiance towards `views`.
///
/// # Errors
/// [`TransportError`] for τ, μ0, photons or a view out of domain (a view's μ must be above 0), for an empty list of
/// views or one too long, and on cancellation.
pub fn trace_radiance(
    medium: &TraceMedium,
    request: &RadianceRequest,
    views: &[View],
    control: Control<'_>,
) -> Result<ViewRadiance, TransportError> {
    check_views(request, views)?;
    let scene = Scene::new(medium, request, views);
    let mut scores = vec![Score::default(); views.len() * request.rows()];
    let fold = |share: Vec<Score>| scores.iter_mut().zip(&share).for_each(|(sum, score)| sum.merge(score));
    rounds::run(request, control, |photons| scene.trace(photons), fold)?;
    Ok(ViewRadiance {
        largest: largest_events(medium, request, views),
        views: views.to_vec(),
        photons: request.photons,
        max_order: request.max_order,
        scores,
    })
}

/// Checks every number, as [`trace_radiance`] does before it starts.
///
/// # Errors
/// [`TransportError`] naming the number that is out of domain.
pub fn check_views(request: &RadianceRequest, views: &[View]) -> Result<(), TransportError> {
    if views.is_empty() {
        return Err(TransportError::NoView);
    }
    views.iter().try_for_each(check)?;
    request.check(views.len())
}

fn check(view: &View) -> Result<(), TransportError> {
    Range { min_included: false, ..Range::closed(0.0, 1.0) }.check("view mu", view.mu)?;
    Range::closed(-360.0, 360.0).check("phi (degrees)", view.phi_deg)?;
    Ok(())
}

/// The directions of flight that reach a viewer at φ and at -φ.
struct Sight {
    side: Side,
    mu: f64,
    to: DVec3,
    /// The mirror image, unless it is the same.
    mirror: Option<DVec3>,
}

impl Sight {
    fn new(view: &View) -> Self {
        let sine = (1.0 - view.mu * view.mu).sqrt();
        // Beyond 180° mirror images, so that exact multiples of 180° stay in the principal plane.
        let turned = 180.0 - (view.phi_deg.abs() - 180.0).abs();
        let phi = turned.to_radians();
        let z = if view.side == Side::Top { -view.mu } else { view.mu };
        let across = if turned == 180.0 { 0.0 } else { sine * libm::sin(phi) };
        let to = DVec3::new(sine * libm::cos(phi), across, z);
        let mirror = (across != 0.0).then(|| DVec3::new(to.x, -to.y, to.z));
        Self { side: view.side, mu: view.mu, to, mirror }
    }

    /// P towards the viewer, the mean of both azimuths.
    fn phase(&self, phase: &dyn PhaseFunction, from: DVec3) -> f64 {
        let towards = |to: DVec3| phase.value((0.5 * (from - to).length_squared()).min(2.0));
        match self.mirror {
            None => towards(self.to),
            Some(mirror) => 0.5 * (towards(self.to) + towards(mirror)),
        }
    }
}

/// A slab, its sun and its viewers.
struct Scene<'a> {
    walk: Walk<'a>,
    request: RadianceRequest,
    sights: Vec<Sight>,
    key: u64,
}

impl<'a> Scene<'a> {
    fn new(medium: &'a TraceMedium, request: &RadianceRequest, views: &[View]) -> Self {
        Self {
            walk: Walk { medium, bottom: request.bottom(medium) },
            request: *request,
            sights: views.iter().map(Sight::new).collect(),
            key: key(request.seed, Purpose::RadianceAtViews(request.stream)),
        }
    }

    /// Scores of a share of photons: views inside orders.
    fn trace(&self, photons: std::ops::Range<u64>) -> Vec<Score> {
        let (views, rows) = (self.sights.len(), self.request.rows());
        let mut scores = vec![Score::default(); views * rows];
        let mut photon = vec![0.0; views * rows];
        for index in photons {
            let mut rng = photon_stream(self.key, index);
            let mut reached = 0;
            self.walk.history(sunbeam(self.request.mu0), &mut rng, |collision| {
                let row = self.request.row(collision.order + 1);
                reached = reached.max(row + 1);
                self.score(collision, &mut photon[row * views..(row + 1) * views]);
            });
            enter(&mut photon, &mut scores, reached * views, views);
        }
        scores
    }

    /// Adds what `collision` sends to every viewer.
    fn score(&self, collision: &Collision, photon: &mut [f64]) {
        let (medium, bottom) = (self.walk.medium, self.walk.bottom);
        let phase = medium.phase().as_ref();
        for (sight, sum) in self.sights.iter().zip(photon) {
            let way = if sight.side == Side::Top { collision.depth } else { bottom - collision.depth };
            let arrives = libm::exp(-way / sight.mu);
            if arrives > 0.0 {
                *sum += 0.25 * medium.albedo() / sight.mu * arrives * sight.phase(phase, collision.direction);
            }
        }
    }
}

/// Enters one photon's first `cells` cells, and their sums over orders as the last row; clears them.
fn enter(photon: &mut [f64], scores: &mut [Score], cells: usize, views: usize) {
    let total = photon.len() - views;
    for cell in 0..cells {
        let x = std::mem::take(&mut photon[cell]);
        scores[cell].add(x);
        photon[total + cell % views] += x;
    }
    if cells > 0 {
        for cell in total..photon.len() {
            scores[cell].add(std::mem::take(&mut photon[cell]));
        }
    }
}

/// The largest score of one event: of order 1, where Θ is given, and of any order.
fn largest_events(medium: &TraceMedium, request: &RadianceRequest, views: &[View]) -> Vec<[f64; 2]> {
    let phase = medium.phase().as_ref();
    let peak = largest_value(phase);
    let event = |view: &View| {
        let scale = 0.25 * medium.albedo() / view.mu;
        let once = Sight::new(view).phase(phase, sunbeam(request.mu0));
        [scale * once, scale * peak.max(once)]
    };
    views.iter().map(event).collect()
}

/// The largest P on a grid that is fine near the forward direction.
fn largest_value(phase: &dyn PhaseFunction) -> f64 {
    const STEPS: u32 = 4096;
    let angle = |i: u32| std::f64::consts::PI * libm::pow(f64::from(i) / f64::from(STEPS), 2.0);
    (0..=STEPS).map(|i| phase.value(versine(angle(i)))).fold(0.0, f64::max)
}

/// Reflectance factors πL/(μ0F0) at the views, unscattered light left out.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewRadiance {
    views: Vec<View>,
    photons: u64,
    max_order: u32,
    /// Views inside orders.
    scores: Vec<Score>,
    /// Of each view, the largest score of one event: of order 1, of any.
    largest: Vec<[f64; 2]>,
}

impl ViewRadiance {
    /// The views, in the order of the request.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// Histories traced.
    pub fn photons(&self) -> u64 {
        self.photons
    }

    /// All rows: orders 1…N, tail and total.
    pub fn orders(&self) -> impl Iterator<Item = Order> + use<> {
        orders(self.max_order)
    }

    /// The radiance of `order` at view number `view`; the error contains one largest event that may have been missed.
    ///
    /// # Panics
    /// If there is no such view, or the order was not traced by itself. So for every method with these arguments.
    pub fn estimate(&self, view: usize, order: Order) -> Estimate {
        let met = self.score(view, order).scatter(self.photons);
        Estimate { std_error: libm::hypot(met.std_error, self.event(view, order)), ..met }
    }

    /// Whether the scatter met exceeds three events of the largest possible score. If not, spikes may be missing and
    /// the error is a guess.
    pub fn is_settled(&self, view: usize, order: Order) -> bool {
        self.score(view, order).scatter(self.photons).std_error >= EVENTS * self.event(view, order)
    }

    /// Largest share of one photon in the sum.
    pub fn largest_share(&self, view: usize, order: Order) -> f64 {
        self.score(view, order).largest_share()
    }

    fn score(&self, view: usize, order: Order) -> &Score {
        &self.scores[row_of(order, self.max_order) * self.views.len() + view]
    }

    /// What one event of the largest possible score adds to the mean.
    fn event(&self, view: usize, order: Order) -> f64 {
        self.largest[view][usize::from(order != Order::Exactly(1))] / (self.photons as f64 + 3.0)
    }
}
