//! The solver with a fixed number of streams.
//!
//! `stratiform_transport::solve` with N streams per hemisphere whatever their error: radiances with orders 1 and 2 exact and the rest
//! by discrete ordinates of a δ-M scaled medium (Nakajima & Tanaka 1988; Stamnes et al. 1988), fluxes by discrete ordinates of every
//! moment. Errors of radiances are those of the rule of order 2 alone. Not in the survey. Domain: all, N ∈ [2, 128].

use crate::grid::{FluxGrid, RadianceGrid};
use crate::promise::region;
use crate::shade::exact;
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, FluxPair, FluxPoint, MethodError, Point, Promise, Promises, Ready};
use stratiform_quantities::Incidence;
use stratiform_stats::Estimate;
use stratiform_transport::solve::{RadianceSolver, SolveMedium, Solver};

/// Of the rule of order 2 and of the azimuth series.
const TOLERANCE: f64 = 1e-4;

/// Of radiances of order one.
const ROUNDING: f64 = 1e-12;

struct Streams {
    card: Card,
    streams: usize,
    fluxes: Solver,
    radiances: RadianceSolver,
}

impl Ready for Streams {
    fn radiances(&self, points: &[Point]) -> Result<Vec<Estimate>, MethodError> {
        points.iter().try_for_each(|point| self.card.domain.check(point))?;
        let mut values = vec![exact(0.0); points.len()];
        for grid in RadianceGrid::cover(points) {
            let solved = self
                .radiances
                .radiance_with_streams(self.streams, &grid.tau, &grid.mu_l, &grid.views)
                .map_err(|error| self.card.failed(&error))?;
            for ((tau, sun, view), point) in grid.places.iter().zip(&grid.points) {
                values[*point] = trimmed(solved[(tau * grid.mu_l.len() + sun) * grid.views.len() + view]);
            }
        }
        Ok(values)
    }

    fn fluxes(&self, points: &[FluxPoint]) -> Result<Vec<FluxPair>, MethodError> {
        points.iter().try_for_each(|point| self.card.domain.check_flux(point))?;
        if points.is_empty() {
            return Ok(Vec::new());
        }
        let grid = FluxGrid::of(points);
        let beams: Vec<Incidence> =
            grid.mu_l.iter().map(|mu| Incidence::beam(*mu)).collect::<Result<_, _>>()?;
        let solved = self.fluxes.totals_with_streams(self.streams, &grid.tau, &beams);
        let solved = solved.map_err(|error| self.card.failed(&error))?;
        let pair = |(tau, sun): &(usize, usize)| {
            let (r, t) = solved[sun * grid.tau.len() + tau];
            FluxPair { reflectance: trimmed(exact(r)), transmittance: trimmed(exact(t)) }
        };
        Ok(grid.places.iter().map(pair).collect())
    }
}

/// Behind absorbing slabs light is below the rounding of the sums that it is made of, and may come out negative: 0 then.
fn trimmed(estimate: Estimate) -> Estimate {
    if (-ROUNDING..0.0).contains(&estimate.value) { Estimate { value: 0.0, ..estimate } } else { estimate }
}

/// With `streams` per hemisphere.
pub(crate) fn method(streams: usize) -> Simple {
    let card = Card {
        name: format!("solver:{streams}"),
        title: "Discrete ordinates",
        source: "Stamnes et al. 1988; Nakajima & Tanaka 1988",
        class: Class::Deterministic,
        domain: Domain::EVERYWHERE,
        promises: Promises {
            radiance: Some(Promise::relative(0.1, region([0.0, 1e4], 0.1))),
            flux: Some(Promise::absolute(5e-3, region([0.0, 1e4], 0.0))),
        },
        radiance: true,
        flux: true,
        table_bytes: None,
    };
    Simple::new(card, move |card, cloud: &Cloud| {
        let medium = SolveMedium::full(cloud.phase().clone(), cloud.omega());
        let failed = |error| card.failed(&error);
        Ok(Box::new(Streams {
            card: card.clone(),
            streams,
            fluxes: Solver::new(medium.clone(), TOLERANCE).map_err(failed)?,
            radiances: RadianceSolver::new(medium, TOLERANCE).map_err(failed)?,
        }))
    })
}
