//! Radiance at given directions, by local estimates.

use super::RadianceRequest;
use super::request::{orders, row_of};
use super::rounds;
use super::score::Score;
use super::viewers::{Seen, Viewers};
use crate::solve::View;
use crate::walk::{Walk, sunbeam, tabulated};
use crate::{Control, TraceMedium, TransportError};
use stratiform_optics::phase::{PhaseFunction, versine};
use stratiform_quantities::{Order, Range};
use stratiform_stats::{Estimate, Purpose, key, photon_stream};

/// Photons of one share.
const SHARE: u64 = 1024;

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
    let viewers = Viewers::new(views);
    let mut scores = vec![Score::default(); views.len() * request.rows()];
    let fold = |share: Vec<Score>| scores.iter_mut().zip(&share).for_each(|(sum, score)| sum.merge(score));
    rounds::run(request, SHARE, control, |photons| trace(medium, request, &viewers, photons), fold)?;
    Ok(ViewRadiance {
        largest: largest_events(medium, request, &viewers),
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

/// Traces a share of photons: views inside orders.
fn trace(
    medium: &TraceMedium,
    request: &RadianceRequest,
    viewers: &Viewers,
    photons: std::ops::Range<u64>,
) -> Vec<Score> {
    let key = key(request.seed, Purpose::RadianceAtViews(request.stream));
    let walk = Walk { medium, sampler: tabulated(medium), bottom: request.bottom(medium) };
    let (views, rows) = (viewers.len(), request.rows());
    let mut scores = vec![Score::default(); views * rows];
    let mut photon = vec![0.0; views * rows];
    let mut seen = Seen::default();
    for index in photons {
        let mut rng = photon_stream(key, index);
        let mut reached = 0;
        walk.history(sunbeam(request.mu0), &mut rng, |collision| {
            let row = request.row(collision.order + 1);
            reached = reached.max(row + 1);
            let depths = [collision.depth, walk.bottom - collision.depth];
            viewers.look(medium, collision.direction, depths, &mut seen);
            let cells = &mut photon[row * views..(row + 1) * views];
            cells.iter_mut().enumerate().for_each(|(view, sum)| *sum += viewers.score(view, &seen));
        });
        enter(&mut photon, &mut scores, reached * views, views);
    }
    scores
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

/// The largest score of one event at each view: of order 1, where Θ is given, and of any order.
fn largest_events(medium: &TraceMedium, request: &RadianceRequest, viewers: &Viewers) -> Vec<[f64; 2]> {
    let mut seen = Seen::default();
    viewers.look(medium, sunbeam(request.mu0), [0.0; 2], &mut seen);
    let peak = largest_value(medium.phase().as_ref());
    (0..viewers.len()).map(|view| [viewers.score(view, &seen), viewers.largest(view, peak, &seen)]).collect()
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
