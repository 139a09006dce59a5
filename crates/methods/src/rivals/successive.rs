//! Successive orders up to N: light scattered at most N times, exactly.
//!
//! `stratiform_transport::solve` gives each order of the fluxes (N ≤ 60), and of the radiance orders 1 (closed form, Chandrasekhar 1950) and 2
//! (an integral over the direction between); radiances beyond 2 are refused. A series cut off is below the truth: of a thick lossless slab
//! the mean number of scatterings is 2τ. Not in the survey, which names it among the off-line methods (its reference 5). Domain: τ up to 1e4.

use crate::grid::{FluxGrid, RadianceGrid};
use crate::shade::exact;
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, FluxPair, FluxPoint, MethodError, Point, Promises, Ready};
use stratiform_quantities::{Incidence, Range};
use stratiform_stats::Estimate;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, Solver};

/// Of each flux, absolute; of radiances, absolute below 1.
const TOLERANCE: f64 = 1e-4;

/// Orders of radiance that are known.
const RADIANCES: u32 = 2;

struct Successive {
    card: Card,
    orders: u32,
    fluxes: Solver,
    radiances: RadianceSolver,
}

/// Values and errors added up.
fn sum(terms: impl Iterator<Item = Estimate>) -> Estimate {
    terms.fold(exact(0.0), |sum, term| Estimate {
        value: sum.value + term.value,
        std_error: sum.std_error + term.std_error,
    })
}

impl Ready for Successive {
    fn radiances(&self, points: &[Point]) -> Result<Vec<Estimate>, MethodError> {
        self.card.gives_radiance()?;
        points.iter().try_for_each(|point| self.card.domain.check(point))?;
        let listed = &[RadianceOrder::One, RadianceOrder::Two][..self.orders.min(RADIANCES) as usize];
        let highest = listed[listed.len() - 1];
        let mut values = vec![exact(0.0); points.len()];
        for grid in RadianceGrid::cover(points) {
            let solved = self
                .radiances
                .radiance_as_reached(highest, &grid.tau, &grid.mu_l, &grid.views)
                .map_err(|error| self.card.failed(&error))?;
            for ((tau, sun, view), point) in grid.places.iter().zip(&grid.points) {
                let of = |order: &RadianceOrder| solved.estimate(*tau, *sun, *view, *order);
                values[*point] = sum(listed.iter().map(of));
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
        let beams = grid.mu_l.iter().map(|mu| Incidence::beam(*mu)).collect::<Result<Vec<_>, _>>()?;
        let solved = self.fluxes.orders(&grid.tau, &beams, self.orders);
        let solved = solved.map_err(|error| self.card.failed(&error))?;
        let pair = |(tau, sun): &(usize, usize)| {
            let of = |order| solved.estimate(*sun, *tau, order);
            let (reflected, transmitted): (Vec<_>, Vec<_>) = (0..=self.orders as usize).map(of).unzip();
            FluxPair { reflectance: sum(reflected.into_iter()), transmittance: sum(transmitted.into_iter()) }
        };
        Ok(grid.places.iter().map(pair).collect())
    }
}

/// Light scattered at most `orders` times.
pub(crate) fn method(orders: u32) -> Simple {
    let card = Card {
        name: format!("orders:{orders}"),
        title: "Successive orders",
        source: "Chandrasekhar 1950, Radiative Transfer, section 45.3 (order 1); van de Hulst 1980, chapter 4",
        class: Class::Deterministic,
        domain: Domain { tau: Range::closed(0.0, 1e4), ..Domain::EVERYWHERE },
        radiance: orders <= RADIANCES,
        flux: true,
        promises: Promises::default(),
        table_bytes: None,
    };
    Simple::new(card, move |card, cloud: &Cloud| {
        let medium = SolveMedium::full(cloud.phase().clone(), cloud.omega());
        let failed = |error| card.failed(&error);
        Ok(Box::new(Successive {
            card: card.clone(),
            orders,
            fluxes: Solver::new(medium.clone(), TOLERANCE).map_err(failed)?,
            radiances: RadianceSolver::new(medium, TOLERANCE).map_err(failed)?,
        }))
    })
}
