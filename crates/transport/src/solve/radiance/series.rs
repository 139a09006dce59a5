//! The azimuth series of one number of streams: light scattered three times or more.
//!
//! Σ(2-δ_m0) cos mφ of the modes' responses. Orders 1 and 2, the slowly converging part, are exact and stand elsewhere,
//! so the series ends early: when four modes in a row, everywhere, add less than a share of the tolerance (one or two
//! may vanish by parity at the horizon or at a zero of a Legendre function). Modes are worked out in batches of fixed size, in parallel, and added in order.

use super::depth::{Exit, Vias};
use super::mode::{Mode, Streams};
use super::response::{Ray, Response};
use super::scaled::Scaled;
use super::single::exit;
use super::view::Geometry;
use rayon::prelude::*;

/// Modes worked out at once.
const BATCH: usize = 8;

/// Share of the tolerance that counts as nothing.
pub(super) const NOTHING: f64 = 0.01;

/// So many small modes in a row end the series.
const ENOUGH: usize = 4;

/// What is asked for: geometries, views inside suns, at every thickness.
pub(super) struct Request<'a> {
    pub(super) tau: &'a [f64],
    pub(super) mu0: &'a [f64],
    /// `views` for each sun, a list per sun.
    pub(super) geometries: &'a [Vec<Geometry>],
}

impl Request<'_> {
    /// Every (thickness, sun, view) in the order of results.
    pub(super) fn places(&self) -> impl Iterator<Item = (f64, usize, &Geometry)> {
        self.tau.iter().flat_map(move |tau| {
            self.geometries.iter().enumerate().flat_map(move |(s, row)| row.iter().map(move |g| (*tau, s, g)))
        })
    }
}

/// The series at every place.
pub(super) fn beyond_twice(medium: &Scaled, count: usize, request: &Request, tolerance: f64) -> Vec<f64> {
    let places: Vec<(f64, usize, &Geometry)> = request.places().collect();
    let streams = Streams::new(count);
    let rates: Vec<f64> = streams.mu.iter().map(|mu| 1.0 / mu).collect();
    // What all modes share: the way out of every place, and the depth integrals of the streams.
    let ways: Vec<Way> =
        places.par_iter().map(|(tau, _, geometry)| Way::new(exit(medium, *tau, geometry), &rates)).collect();
    let mut sums = vec![0.0; places.len()];
    let mut small = 0;
    let modes: Vec<usize> = (0..medium.moments.len() - 1).collect();
    for batch in modes.chunks(BATCH) {
        let terms: Vec<Vec<f64>> =
            batch.par_iter().map(|m| mode_terms(&Mode::new(medium, &streams, *m), request, &ways)).collect();
        for (m, terms) in batch.iter().zip(terms) {
            let factor = if *m == 0 { 1.0 } else { 2.0 };
            let mut most: f64 = 0.0;
            for ((sum, term), (_, _, geometry)) in sums.iter_mut().zip(&terms).zip(&places) {
                *sum += factor * term * libm::cos(*m as f64 * geometry.phi);
                // A NaN is no small term.
                most = if term.is_finite() { most.max(factor * term.abs()) } else { f64::INFINITY };
            }
            small = if most <= NOTHING * tolerance { small + 1 } else { 0 };
            if small == ENOUGH {
                return sums;
            }
        }
    }
    sums
}

/// The way out of a place.
struct Way {
    exit: Exit,
    by_streams: Vias,
}

impl Way {
    fn new(exit: Exit, rates: &[f64]) -> Self {
        Self { exit, by_streams: exit.via(rates) }
    }
}

/// Fourier coefficients of one mode at every place.
fn mode_terms(mode: &Mode, request: &Request, ways: &[Way]) -> Vec<f64> {
    let suns: Vec<Ray> = request.mu0.iter().map(|mu| ray(mode, *mu)).collect();
    let views = Views::new(mode, request);
    let extinction = mode.medium().extinction;
    let mut terms = Vec::new();
    let mut rows = ways.chunks(request.geometries[0].len());
    for tau in request.tau {
        let response = Response::new(mode, tau * extinction, &suns);
        for (s, row) in suns.iter().enumerate().zip(&mut rows) {
            let mut known: Vec<(&Exit, f64)> = Vec::new();
            for (v, Way { exit, by_streams }) in row.iter().enumerate() {
                let before = known.iter().find(|(other, _)| *other == exit).map(|(_, value)| *value);
                let value =
                    before.unwrap_or_else(|| response.beyond_twice(s, views.get(v), exit, by_streams));
                if before.is_none() {
                    known.push((exit, value));
                }
                terms.push(value);
            }
        }
    }
    terms
}

fn ray(mode: &Mode, mu: f64) -> Ray {
    Ray { mu, towards: mode.towards(mu) }
}

/// Views with equal cosines share a ray.
struct Views {
    rays: Vec<Ray>,
    place: Vec<usize>,
}

impl Views {
    fn new(mode: &Mode, request: &Request) -> Self {
        let (mut rays, mut place): (Vec<Ray>, Vec<usize>) = (Vec::new(), Vec::new());
        for geometry in &request.geometries[0] {
            let found = rays.iter().position(|ray| ray.mu == geometry.mu);
            place.push(found.unwrap_or(rays.len()));
            if found.is_none() {
                rays.push(ray(mode, geometry.mu));
            }
        }
        Self { rays, place }
    }

    fn get(&self, view: usize) -> &Ray {
        &self.rays[self.place[view]]
    }
}
