//! The azimuth series of one number of streams: light scattered three times or more.
//!
//! Σ(2-δ_m0) cos mφ of the modes' responses. Orders 1 and 2, the slowly converging part, are exact and stand elsewhere,
//! so a place's series ends early: when four modes in a row add less than a share of the tolerance (one or two may vanish by parity
//! at the horizon or at a zero of a Legendre function). A mode serves all places whose series goes on. Modes are worked out in
//! batches of fixed size, in parallel, and added in order.

use super::depth::{Exit, Vias};
use super::mode::{Mode, Streams};
use super::places::Place;
use super::response::{Ray, Response};
use super::scaled::Scaled;
use super::single::exit;
use rayon::prelude::*;

/// Modes worked out at once.
const BATCH: usize = 2;

/// Share of the tolerance that counts as nothing.
pub(super) const NOTHING: f64 = 0.03;

/// So many small modes in a row end the series.
const ENOUGH: usize = 4;

/// The series at every place.
pub(super) fn beyond_twice(medium: &Scaled, count: usize, places: &[Place], tolerance: f64) -> Vec<f64> {
    let streams = Streams::new(count);
    let rates: Vec<f64> = streams.mu.iter().map(|mu| 1.0 / mu).collect();
    // Small modes in a row.
    let mut small = vec![0; places.len()];
    let mut sums = vec![0.0; places.len()];
    let mut open: Vec<Way> =
        places.par_iter().enumerate().map(|(i, place)| Way::new(i, place, medium, &rates)).collect();
    let modes: Vec<usize> = (0..medium.moments.len() - 1).collect();
    for batch in modes.chunks(BATCH) {
        let terms: Vec<Vec<f64>> =
            batch.par_iter().map(|m| mode_terms(&Mode::new(medium, &streams, *m), &open)).collect();
        for (m, terms) in batch.iter().zip(terms) {
            let factor = if *m == 0 { 1.0 } else { 2.0 };
            for (way, term) in open.iter().zip(&terms) {
                let small = &mut small[way.place];
                if *small < ENOUGH {
                    sums[way.place] += factor * term * libm::cos(*m as f64 * way.phi);
                    *small = if factor * term.abs() <= NOTHING * tolerance { *small + 1 } else { 0 };
                }
            }
        }
        open.retain(|way| small[way.place] < ENOUGH);
        if open.is_empty() {
            break;
        }
    }
    sums
}

/// A place with what all its modes share: the way out, and the depth integrals of the streams.
struct Way {
    place: usize,
    tau: f64,
    sun: usize,
    mu0: f64,
    mu: f64,
    phi: f64,
    exit: Exit,
    by_streams: Vias,
}

impl Way {
    fn new(place: usize, of: &Place, medium: &Scaled, rates: &[f64]) -> Self {
        let exit = exit(medium, of.tau, &of.geometry);
        let by_streams = exit.via(rates);
        Self {
            place,
            tau: of.tau,
            sun: of.sun,
            mu0: of.geometry.mu0,
            mu: of.geometry.mu,
            phi: of.geometry.phi,
            exit,
            by_streams,
        }
    }
}

/// Fourier coefficients of one mode on every way.
fn mode_terms(mode: &Mode, ways: &[Way]) -> Vec<f64> {
    let rays = Rays::new(mode, ways.iter().flat_map(|way| [way.mu0, way.mu]));
    let slabs: Vec<&[Way]> = ways.chunk_by(|a, b| a.tau == b.tau).collect();
    let terms: Vec<Vec<f64>> = slabs.par_iter().map(|ways| slab_terms(mode, &rays, ways)).collect();
    terms.concat()
}

/// The same of one thickness.
fn slab_terms(mode: &Mode, rays: &Rays, ways: &[Way]) -> Vec<f64> {
    let by_sun: Vec<&[Way]> = ways.chunk_by(|a, b| a.sun == b.sun).collect();
    let suns: Vec<&Ray> = by_sun.iter().map(|ways| rays.get(ways[0].mu0)).collect();
    let response = Response::new(mode, ways[0].tau * mode.medium().extinction, &suns);
    let mut terms = Vec::with_capacity(ways.len());
    for (s, ways) in by_sun.iter().enumerate() {
        let mut known: Vec<(&Exit, f64)> = Vec::new();
        for Way { exit, by_streams, mu, .. } in *ways {
            let before = known.iter().find(|(other, _)| *other == exit).map(|(_, value)| *value);
            let value = before
                .unwrap_or_else(|| response.beyond_twice((s, suns[s]), rays.get(*mu), exit, by_streams));
            if before.is_none() {
                known.push((exit, value));
            }
            terms.push(value);
        }
    }
    terms
}

/// A ray for each cosine, in growing order.
struct Rays(Vec<Ray>);

impl Rays {
    fn new(mode: &Mode, mu: impl Iterator<Item = f64>) -> Self {
        let mut mu: Vec<f64> = mu.collect();
        mu.sort_by(f64::total_cmp);
        mu.dedup();
        Self(mu.into_par_iter().map(|mu| Ray { mu, towards: mode.towards(mu) }).collect())
    }

    fn get(&self, mu: f64) -> &Ray {
        &self.0[self.0.partition_point(|ray| ray.mu < mu)]
    }
}
