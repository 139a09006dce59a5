//! Radiance within a tolerance: rules and streams are refined until results agree.
//!
//! Places that agree stay as they are: only the others go on to more streams.

use super::climb::{Climb, LADDER};
use super::narrow::{MOMENTS, Narrow};
use super::phase::Phase;
use super::places::{Pair, Place, pairs, places};
use super::radiances::Radiances;
use super::scaled::Scaled;
use super::second::{Rules, excess};
use super::series::{NOTHING, beyond_twice};
use super::single::{once, once_estimate};
use super::view::{Geometry, RadianceOrder, View};
use crate::TransportError;
use crate::solve::medium::SolveMedium;
use rayon::prelude::*;
use stratiform_quantities::Range;
use stratiform_stats::Estimate;

/// Streams that can be asked for.
const STREAMS: Range = Range::closed(2.0, 128.0);

/// Tolerances that can be met.
const TOLERANCE: Range = Range { max_included: false, ..Range::closed(2e-8, 1.0) };

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

/// Order 2 at one place.
type Second = fn(&Rules, &Scaled, &Phase, f64, &Geometry) -> Estimate;

/// What is worked out once for sun and view.
struct Prepared {
    rules: Rules,
    /// Order 2 at every thickness.
    second: Vec<Estimate>,
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
        let pairs = pairs(&with_views(mu0, views))?;
        let solved = self.solve(RadianceOrder::Total, tau, &pairs)?;
        self.refuse_excess(tau, &pairs, &solved)?;
        Ok(solved.radiances(mu0.len(), views.len()))
    }

    /// The same for suns with views of their own, in one go: modes and slabs are worked out once for all of them.
    ///
    /// # Errors
    /// As [`radiance`](Self::radiance).
    pub fn radiance_of_suns(
        &self,
        tau: &[f64],
        suns: &[(f64, Vec<View>)],
    ) -> Result<Vec<Radiances>, TransportError> {
        let suns: Vec<(f64, &[View])> = suns.iter().map(|(mu0, views)| (*mu0, views.as_slice())).collect();
        let pairs = pairs(&suns)?;
        let solved = self.solve(RadianceOrder::Total, tau, &pairs)?;
        self.refuse_excess(tau, &pairs, &solved)?;
        Ok((0..suns.len()).map(|sun| solved.of_sun(sun, &pairs)).collect())
    }

    /// As [`radiance`](Self::radiance) without orders beyond `highest` (1 is immediate, 2 needs no streams); and totals that no
    /// number of streams brings within the tolerance are no error: each estimate says how well it is known.
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
        let solved = self.solve(highest, tau, &pairs(&with_views(mu0, views))?)?;
        Ok(solved.radiances(mu0.len(), views.len()))
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
        let pairs = pairs(&with_views(mu0, views))?;
        let places = places(tau, &pairs)?;
        Ok(self.rung(&places, &self.prepare(tau, &pairs)?, streams, Rules::twice))
    }

    /// Every order up to `highest`.
    fn solve(&self, highest: RadianceOrder, tau: &[f64], pairs: &[Pair]) -> Result<Solved, TransportError> {
        let places = places(tau, pairs)?;
        let as_it_is = Scaled::not(&self.medium);
        let first = |place: &Place| once_estimate(&as_it_is, &self.phase, place.tau, &place.geometry);
        let mut orders = vec![places.iter().map(first).collect()];
        let mut streams = 0;
        if highest != RadianceOrder::One {
            let prepared = self.prepare(tau, pairs)?;
            orders.push((0..tau.len()).flat_map(|t| prepared.iter().map(move |of| of.second[t])).collect());
            if highest == RadianceOrder::Total {
                let climbs = self.climb(&places, &prepared);
                streams = climbs.iter().map(|climb| climb.streams).max().unwrap_or(0);
                orders.push(climbs.iter().map(|climb| climb.nearest).collect());
            }
        }
        Ok(Solved { orders, streams })
    }

    /// The place that is furthest beyond the tolerance, if one is.
    fn refuse_excess(&self, tau: &[f64], pairs: &[Pair], solved: &Solved) -> Result<(), TransportError> {
        let totals = solved.orders[RadianceOrder::Total as usize].iter().map(excess).enumerate();
        let (worst, reached) =
            totals.fold((0, 0.0), |worst, next| if next.1 > worst.1 { next } else { worst });
        if reached <= self.tolerance {
            return Ok(());
        }
        let (tau, Pair { mu0, view, .. }) = (tau[worst / pairs.len()], &pairs[worst % pairs.len()]);
        let place = format!(" at tau {tau}, mu0 {mu0}, {:?} mu {}, phi {}", view.side, view.mu, view.phi_deg);
        let (wanted, streams) = (self.tolerance, solved.streams);
        Err(TransportError::Tolerance { wanted, reached, streams, place: place.to_lowercase() })
    }

    fn prepare(&self, tau: &[f64], pairs: &[Pair]) -> Result<Vec<Prepared>, TransportError> {
        let as_it_is = Scaled::not(&self.medium);
        let of = |Pair { geometry, .. }: &Pair| {
            let (rules, second) = Rules::new(&as_it_is, &self.phase, tau, geometry, self.tolerance)?;
            Ok(Prepared { rules, second, waves: self.narrow.waves(geometry) })
        };
        pairs.par_iter().map(of).collect()
    }

    /// Totals, each from the first rung that agrees with the ones below, or from the one that comes nearest to that.
    fn climb(&self, places: &[Place], prepared: &[Prepared]) -> Vec<Climb> {
        let rest = 2.0 * NOTHING * self.tolerance;
        let mut climbs = vec![Climb::new(); places.len()];
        let mut open: Vec<usize> = (0..places.len()).collect();
        for (rung, count) in LADDER.into_iter().enumerate() {
            let asked: Vec<Place> = open.iter().map(|i| places[*i]).collect();
            // Errors of order 2 are asked of the rungs that can be the last.
            let second = if rung < 2 { Rules::finest } else { Rules::twice };
            let found = self.rung(&asked, prepared, count, second);
            open.iter().zip(&found).for_each(|(i, found)| climbs[*i].step(rung, found, rest));
            open.retain(|i| excess(&climbs[*i].nearest) > self.tolerance);
            if open.is_empty() {
                break;
            }
        }
        climbs
    }

    /// Totals with `count` streams; errors are those of `second`.
    fn rung(&self, places: &[Place], prepared: &[Prepared], count: usize, second: Second) -> Vec<Estimate> {
        let phase = &self.phase;
        let medium = Scaled::new(&self.medium, &self.chi, count, phase.edge.is_some());
        let rest = beyond_twice(&medium, count, places, self.tolerance);
        let sum = |(Place { tau, pair, geometry, .. }, rest): (&Place, &f64)| {
            let Prepared { rules, waves, .. } = &prepared[*pair];
            let second = second(rules, &medium, phase, *tau, geometry);
            let narrow = once(&medium, phase, *tau, geometry)
                + self.narrow.beyond_twice(&medium, *tau, geometry, waves);
            Estimate { value: second.value + rest + narrow, std_error: second.std_error }
        };
        places.par_iter().zip(&rest).map(sum).collect()
    }
}

/// Every order, thicknesses outside pairs.
struct Solved {
    orders: Vec<Vec<Estimate>>,
    streams: usize,
}

impl Solved {
    fn radiances(self, suns: usize, views: usize) -> Radiances {
        Radiances { suns, views, orders: self.orders, streams: self.streams }
    }

    fn of_sun(&self, sun: usize, pairs: &[Pair]) -> Radiances {
        let views = pairs.iter().filter(|pair| pair.sun == sun).count();
        let own = |order: &Vec<Estimate>| {
            order
                .iter()
                .zip(pairs.iter().cycle())
                .filter(|(_, pair)| pair.sun == sun)
                .map(|(of, _)| *of)
                .collect()
        };
        Radiances { suns: 1, views, orders: self.orders.iter().map(own).collect(), streams: self.streams }
    }
}

fn with_views<'a>(mu0: &[f64], views: &'a [View]) -> Vec<(f64, &'a [View])> {
    mu0.iter().map(|mu0| (*mu0, views)).collect()
}
