//! Radiance within a tolerance: rules and streams are refined until results agree.

use super::double::{POINTS, Pairing};
use super::narrow::{MOMENTS, Narrow};
use super::phase::Phase;
use super::radiances::Radiances;
use super::scaled::Scaled;
use super::series::{NOTHING, Request, beyond_twice};
use super::single::{once, once_estimate};
use super::view::{Geometry, RadianceOrder, View};
use crate::TransportError;
use crate::solve::medium::SolveMedium;
use rayon::prelude::*;
use stratiform_quantities::{OpticalThickness, Range};
use stratiform_stats::Estimate;

/// Streams per hemisphere.
const LADDER: [usize; 8] = [8, 16, 24, 32, 48, 64, 96, 128];

/// Streams that can be asked for.
const STREAMS: Range = Range::closed(2.0, 128.0);

/// Tolerances that can be met.
const TOLERANCE: Range = Range { max_included: false, ..Range::closed(2e-8, 1.0) };

/// Share of the tolerance that the angular rule of order 2 should take.
const SHARE: f64 = 0.1;

/// Times the rest of a 1/n series.
const MARGIN: f64 = 1.5;

/// Rounding and limits (k = 0, μ = 0) relative to radiances of order one.
const ROUNDING: f64 = 1e-8;

/// A medium ready for radiances in any direction.
#[derive(Clone)]
pub struct RadianceSolver {
    medium: SolveMedium,
    phase: Phase,
    /// Moments enough for the last rung.
    chi: Vec<f64>,
    narrow: Narrow,
    tolerance: f64,
}

/// Three rules of order 2, each finer than the one before.
type Rules = [Pairing; 3];

/// Order 2 at one place.
type Second = fn(&Rules, &Scaled, &Phase, f64, &Geometry) -> Estimate;

/// What is worked out once for sun and view.
#[derive(Clone)]
struct Prepared {
    rules: Rules,
    /// (2l+1)P_l between them.
    waves: Vec<f64>,
}

impl RadianceSolver {
    /// Prepares radiances within `tolerance`: absolute below 1, relative above.
    ///
    /// # Errors
    /// [`TransportError::Domain`] unless 2e-8 ≤ `tolerance` < 1.
    pub fn new(medium: SolveMedium, tolerance: f64) -> Result<Self, TransportError> {
        TOLERANCE.check("tolerance", tolerance)?;
        let chi = medium.leading_moments(MOMENTS);
        let phase = Phase::new(&medium);
        let narrow = Narrow::new(chi.clone(), &phase);
        Ok(Self { medium, phase, chi, narrow, tolerance })
    }

    /// The medium.
    pub fn medium(&self) -> &SolveMedium {
        &self.medium
    }

    /// Radiances of order 1, order 2 and in total, for every thickness, μ0 and view.
    ///
    /// # Errors
    /// [`TransportError::Domain`] for τ, μ0 or a view, or if μ0 and a view's μ are both 0;
    /// [`TransportError::NoThickness`], [`TransportError::NoIncidence`], [`TransportError::NoView`];
    /// [`TransportError::Tolerance`] or [`TransportError::Rule`] if the finest streams or rule do not suffice.
    pub fn radiance(&self, tau: &[f64], mu0: &[f64], views: &[View]) -> Result<Radiances, TransportError> {
        let solved = self.radiance_as_reached(RadianceOrder::Total, tau, mu0, views)?;
        let totals = solved.orders[RadianceOrder::Total as usize].iter().map(excess).enumerate();
        let (worst, reached) =
            totals.fold((0, 0.0), |worst, next| if next.1 > worst.1 { next } else { worst });
        if reached <= self.tolerance {
            return Ok(solved);
        }
        let (place, view) = (worst / views.len(), &views[worst % views.len()]);
        let (tau, mu0) = (tau[place / mu0.len()], mu0[place % mu0.len()]);
        let place = format!(" at tau {tau}, mu0 {mu0}, {:?} mu {}, phi {}", view.side, view.mu, view.phi_deg);
        let (wanted, streams) = (self.tolerance, solved.streams);
        Err(TransportError::Tolerance { wanted, reached, streams, place: place.to_lowercase() })
    }

    /// The same without orders beyond `highest` (1 is immediate, 2 needs no streams); and totals that no number of streams
    /// brings within the tolerance are no error: each estimate says how well it is known.
    ///
    /// # Errors
    /// As [`radiance`](Self::radiance), but for [`TransportError::Tolerance`].
    pub fn radiance_as_reached(
        &self,
        highest: RadianceOrder,
        tau: &[f64],
        mu0: &[f64],
        views: &[View],
    ) -> Result<Radiances, TransportError> {
        let geometries = geometries(tau, mu0, views)?;
        let clean: Vec<f64> = geometries.iter().map(|row| row[0].mu0).collect();
        let request = Request { tau, mu0: &clean, geometries: &geometries };
        let phase = &self.phase;
        let as_it_is = Scaled::not(&self.medium);
        let first = request.places().map(|(tau, _, geometry)| once_estimate(&as_it_is, phase, tau, geometry));
        let mut orders = vec![first.collect()];
        let mut streams = 0;
        if highest != RadianceOrder::One {
            let prepared = self.prepare(&request)?;
            orders.push(twice(&as_it_is, phase, &request, &prepared, by_rules));
            if highest == RadianceOrder::Total {
                let (total, count) = self.climb(&request, &prepared);
                orders.push(total);
                streams = count;
            }
        }
        Ok(Radiances { suns: mu0.len(), views: views.len(), orders, streams })
    }

    /// Total radiances with `streams` per hemisphere whatever their error, thicknesses outside, suns, views inside. The errors are
    /// those of order 2 alone. For studies of convergence.
    ///
    /// # Errors
    /// As [`radiance`](Self::radiance), but for [`TransportError::Tolerance`]; [`TransportError::Domain`] unless 2 ≤ `streams` ≤ 128.
    pub fn radiance_with_streams(
        &self,
        streams: usize,
        tau: &[f64],
        mu0: &[f64],
        views: &[View],
    ) -> Result<Vec<Estimate>, TransportError> {
        STREAMS.check("streams", streams as f64)?;
        let geometries = geometries(tau, mu0, views)?;
        let clean: Vec<f64> = geometries.iter().map(|row| row[0].mu0).collect();
        let request = Request { tau, mu0: &clean, geometries: &geometries };
        let prepared = self.prepare(&request)?;
        Ok(self.rung(&request, &prepared, streams, by_rules))
    }

    /// Suns outside, views inside: rules of order 2 fine enough for every thickness.
    fn prepare(&self, request: &Request) -> Result<Vec<Vec<Prepared>>, TransportError> {
        let flat: Vec<&Geometry> = request.geometries.iter().flatten().collect();
        let of = |geometry: &&Geometry| {
            let rules = self.rule(&self.phase, request.tau, geometry)?;
            Ok(Prepared { rules, waves: self.narrow.waves(geometry) })
        };
        let prepared: Vec<Prepared> = flat.par_iter().map(of).collect::<Result<_, TransportError>>()?;
        let views = request.geometries[0].len();
        Ok(prepared.chunks(views).map(<[Prepared]>::to_vec).collect())
    }

    /// Three rules that agree to a share of the tolerance, or the finest if they meet the tolerance itself.
    fn rule(&self, phase: &Phase, tau: &[f64], geometry: &Geometry) -> Result<Rules, TransportError> {
        let medium = Scaled::not(&self.medium);
        let disagreement = |rules: &Rules| {
            tau.iter().fold(0.0_f64, |worst, tau| {
                worst.max(excess(&by_rules(rules, &medium, phase, *tau, geometry)))
            })
        };
        let mut rules = [POINTS[0], POINTS[1], POINTS[2]].map(|points| Pairing::new(phase, geometry, points));
        let mut worst = disagreement(&rules);
        for points in &POINTS[3..] {
            if worst <= SHARE * self.tolerance {
                break;
            }
            let [_, coarse, middle] = rules;
            rules = [coarse, middle, Pairing::new(phase, geometry, *points)];
            worst = disagreement(&rules);
        }
        if worst > self.tolerance {
            return Err(TransportError::Rule { wanted: self.tolerance, reached: worst });
        }
        Ok(rules)
    }

    /// Totals from the first rung that agrees with the ones below, or from the one that comes nearest to that.
    fn climb(&self, request: &Request, prepared: &[Vec<Prepared>]) -> (Vec<Estimate>, usize) {
        let mut rungs: Vec<Vec<Estimate>> = Vec::new();
        let (mut reached, mut nearest) = (f64::INFINITY, (Vec::new(), 0));
        let mut before = 0;
        for count in LADDER {
            // Errors of order 2 are asked of the rungs that can be the last.
            let second = if rungs.len() < 2 { by_finest } else { by_rules };
            rungs.push(self.rung(request, prepared, count, second));
            // An error that falls like 1/n: so many times the last step are left.
            let left = before as f64 / (count - before) as f64;
            before = count;
            let [.., first, second, third] = rungs.as_slice() else { continue };
            let total: Vec<Estimate> =
                (0..third.len()).map(|i| self.settled(left, [first[i], second[i], third[i]])).collect();
            let worst = total.iter().fold(0.0_f64, |worst, estimate| worst.max(excess(estimate)));
            if worst < reached || nearest.1 == 0 {
                (reached, nearest) = (worst, (total, count));
            }
            if worst <= self.tolerance {
                break;
            }
        }
        nearest
    }

    /// Totals with `count` streams; errors are those of `second`.
    fn rung(
        &self,
        request: &Request,
        prepared: &[Vec<Prepared>],
        count: usize,
        second: Second,
    ) -> Vec<Estimate> {
        let phase = &self.phase;
        let medium = Scaled::new(&self.medium, &self.chi, count, phase.edge.is_some());
        let rest = beyond_twice(&medium, count, request, self.tolerance);
        let second = twice(&medium, phase, request, prepared, second);
        let narrow = at_places(request, prepared, |tau, geometry, prepared| {
            once(&medium, phase, tau, geometry)
                + self.narrow.beyond_twice(&medium, tau, geometry, &prepared.waves)
        });
        let sum = |((second, rest), narrow): ((&Estimate, &f64), &f64)| Estimate {
            value: second.value + rest + narrow,
            std_error: second.std_error,
        };
        second.iter().zip(&rest).zip(&narrow).map(sum).collect()
    }

    /// The last of three rungs with its error: `left` times the last step (at the horizon and in the aureole results
    /// converge no faster than 1/n) with a margin, or half of the step before lest two rungs agree by chance; the error of
    /// order 2; what the azimuth series leaves out; rounding.
    fn settled(&self, left: f64, [first, second, third]: [Estimate; 3]) -> Estimate {
        let last = MARGIN * left * (third.value - second.value).abs();
        let step = last.max(0.5 * (second.value - first.value).abs());
        let rest = 2.0 * NOTHING * self.tolerance + ROUNDING * third.value.abs().max(1.0);
        let error = step + third.std_error + rest;
        Estimate { value: third.value, std_error: if error.is_finite() { error } else { f64::INFINITY } }
    }
}

/// Order 2 everywhere.
fn twice(
    medium: &Scaled,
    phase: &Phase,
    request: &Request,
    prepared: &[Vec<Prepared>],
    second: Second,
) -> Vec<Estimate> {
    at_places(request, prepared, |tau, geometry, prepared| {
        second(&prepared.rules, medium, phase, tau, geometry)
    })
}

/// `of` every (thickness, sun, view) in the order of results.
fn at_places<T: Send>(
    request: &Request,
    prepared: &[Vec<Prepared>],
    of: impl Fn(f64, &Geometry, &Prepared) -> T + Sync,
) -> Vec<T> {
    let views = request.geometries[0].len();
    let places: Vec<(f64, usize, &Geometry)> = request.places().collect();
    let one = |(place, (tau, sun, geometry)): (usize, &(f64, usize, &Geometry))| {
        of(*tau, geometry, &prepared[*sun][place % views])
    };
    places.par_iter().enumerate().map(one).collect()
}

/// The finest rule; no error.
fn by_finest(rules: &Rules, medium: &Scaled, phase: &Phase, tau: f64, geometry: &Geometry) -> Estimate {
    Estimate { value: rules[2].twice(medium, phase, tau, geometry), std_error: 0.0 }
}

/// The finest rule with its error: twice the last step, or half of the one before lest two rules agree by chance.
fn by_rules(rules: &Rules, medium: &Scaled, phase: &Phase, tau: f64, geometry: &Geometry) -> Estimate {
    let [coarse, middle, fine] = [0, 1, 2].map(|i| rules[i].twice(medium, phase, tau, geometry));
    let step = (fine - middle).abs().max(0.25 * (middle - coarse).abs());
    Estimate { value: fine, std_error: 2.0 * step + f64::EPSILON * fine.abs() }
}

/// Error in units of the tolerance's scale.
fn excess(estimate: &Estimate) -> f64 {
    let excess = estimate.std_error / estimate.value.abs().max(1.0);
    if excess.is_finite() { excess } else { f64::INFINITY }
}

fn geometries(tau: &[f64], mu0: &[f64], views: &[View]) -> Result<Vec<Vec<Geometry>>, TransportError> {
    if tau.is_empty() {
        return Err(TransportError::NoThickness);
    }
    if mu0.is_empty() {
        return Err(TransportError::NoIncidence);
    }
    if views.is_empty() {
        return Err(TransportError::NoView);
    }
    for &tau in tau {
        OpticalThickness::new(tau)?;
    }
    mu0.iter().map(|mu0| views.iter().map(|view| Geometry::new(*mu0, view)).collect()).collect()
}
