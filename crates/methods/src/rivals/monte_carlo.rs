//! Monte Carlo with a fixed number of photons for each sun.
//!
//! `stratiform_transport`: the plain three-dimensional tracer, one slab at a time, and the half-space tracer, one history for every
//! thickness; through the full or the modified medium (Bouthors et al. 2006, section 4.1). Analog, so that standard errors are binomial.
//! Fluxes; radiances by local estimates (plain tracer only), whose spikes in the full medium errors state. Hufnagel & Held's class: path
//! tracing (4.1.3). Domain: τ ≤ 1e4, since a lossless slab of τ takes 2τ scatterings a photon.
//! In the modified medium T counts light that met forward events only as unscattered, which the total does not see.

use crate::grid::FluxGrid;
use crate::promise::region;
use crate::shade::exact;
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, FluxPair, FluxPoint, MethodError, Point, Promise, Promises, Ready};
use std::sync::Arc;
use stratiform_quantities::{Incidence, Medium, Order, Range};
use stratiform_stats::Estimate;
use stratiform_transport::radiance::{MAX_CELLS, RadianceRequest, trace_radiance};
use stratiform_transport::solve::View;
use stratiform_transport::{
    Control, Stop, TraceMedium, TraceRequest, Traced, TransportError, trace_half_space, trace_plain,
};

/// Views of one trace, each with two rows.
const VIEWS: usize = MAX_CELLS / 2;

type Tracer = fn(&TraceMedium, &TraceRequest, Control<'_>) -> Result<Traced, TransportError>;

/// Which tracer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Geometry {
    Plain,
    HalfSpace,
}

struct MonteCarlo {
    card: Card,
    medium: TraceMedium,
    trace: Tracer,
    photons: u64,
}

impl MonteCarlo {
    fn sun(&self, sun: usize, mu_l: f64, tau: &[f64]) -> Result<Vec<FluxPair>, MethodError> {
        let request = TraceRequest {
            tau: tau.to_vec(),
            incidence: Incidence::beam(mu_l)?,
            stop: Stop::Photons(self.photons),
            max_order: 0,
            seed: 1,
            stream: u32::try_from(sun).unwrap_or(u32::MAX),
        };
        let traced = (self.trace)(&self.medium, &request, Control::default());
        let traced = traced.map_err(|error| self.card.failed(&error))?;
        let pair = |i| {
            let (reflectance, transmittance) = traced.estimate(i, Order::Total);
            FluxPair { reflectance, transmittance }
        };
        Ok((0..tau.len()).map(pair).collect())
    }
}

impl MonteCarlo {
    /// Local estimates of one slab and one sun. `stream` tells slabs and suns apart.
    fn views(&self, stream: usize, tau: f64, mu0: f64, views: &[View]) -> Result<Vec<Estimate>, MethodError> {
        let (photons, stream) = (self.photons, u32::try_from(stream).unwrap_or(u32::MAX));
        let request = RadianceRequest { tau, mu0, photons, max_order: 0, seed: 1, stream };
        let mut values = Vec::new();
        for views in views.chunks(VIEWS) {
            let traced = trace_radiance(&self.medium, &request, views, Control::default());
            let traced = traced.map_err(|error| self.card.failed(&error))?;
            values.extend((0..views.len()).map(|view| traced.estimate(view, Order::Total)));
        }
        Ok(values)
    }
}

impl Ready for MonteCarlo {
    fn radiances(&self, points: &[Point]) -> Result<Vec<Estimate>, MethodError> {
        self.card.gives_radiance()?;
        points.iter().try_for_each(|point| self.card.domain.check(point))?;
        let slabs = slabs(points);
        let mut values = vec![exact(0.0); points.len()];
        for (stream, slab) in slabs.iter().enumerate() {
            let Point { tau, mu_l, .. } = points[slab[0]];
            let view =
                |i: &usize| View { side: points[*i].side, mu: points[*i].mu_v, phi_deg: points[*i].phi_deg };
            let views: Vec<View> = slab.iter().map(view).collect();
            for (point, value) in slab.iter().zip(self.views(stream, tau, mu_l, &views)?) {
                values[*point] = value;
            }
        }
        Ok(values)
    }

    fn fluxes(&self, points: &[FluxPoint]) -> Result<Vec<FluxPair>, MethodError> {
        points.iter().try_for_each(|point| self.card.domain.check_flux(point))?;
        let grid = FluxGrid::of(points);
        let suns = grid.mu_l.iter().enumerate().map(|(sun, mu_l)| self.sun(sun, *mu_l, &grid.tau));
        let suns = suns.collect::<Result<Vec<_>, _>>()?;
        Ok(grid.places.iter().map(|(tau, sun)| suns[*sun][*tau]).collect())
    }
}

/// Points by thickness and sun, in the order in which these first stand.
fn slabs(points: &[Point]) -> Vec<Vec<usize>> {
    let mut slabs: Vec<Vec<usize>> = Vec::new();
    for (i, point) in points.iter().enumerate() {
        let same = |slab: &&mut Vec<usize>| {
            let first = &points[slab[0]];
            first.tau == point.tau && first.mu_l == point.mu_l
        };
        match slabs.iter_mut().find(same) {
            Some(slab) => slab.push(i),
            None => slabs.push(vec![i]),
        }
    }
    slabs
}

/// The name without its knob.
pub(crate) const fn stem(geometry: Geometry, medium: Medium) -> &'static str {
    match (geometry, medium) {
        (Geometry::Plain, Medium::Full) => "monte-carlo",
        (Geometry::Plain, Medium::Modified) => "monte-carlo-modified",
        (Geometry::HalfSpace, Medium::Full) => "half-space",
        (Geometry::HalfSpace, Medium::Modified) => "half-space-modified",
    }
}

fn traced(cloud: &Cloud, medium: Medium) -> Result<TraceMedium, TransportError> {
    match medium {
        Medium::Full => Ok(TraceMedium::full(cloud.phase().clone(), cloud.omega())),
        Medium::Modified => {
            let wide: Arc<_> = cloud.modified().clone();
            TraceMedium::modified(wide, cloud.omega(), cloud.forward_fraction())
        }
    }
}

/// Noise alone; of the modified medium, whose R and T are not quite the full one's, a little more.
fn noise(medium: Medium) -> Promise {
    let absolute = if medium == Medium::Full { 0.0 } else { 0.02 };
    Promise { absolute, ..Promise::sigmas(5.0, region([0.0, 1e4], 0.0)) }
}

/// With `photons` for each sun.
pub(crate) fn method(geometry: Geometry, medium: Medium, photons: f64) -> Simple {
    let card = Card {
        name: format!("{}:{photons:e}", stem(geometry, medium)),
        title: "Monte Carlo",
        source: "Analog photon tracing; half-space histories serve every thickness",
        class: Class::PathTracing,
        domain: Domain { tau: Range::closed(0.0, 1e4), ..Domain::EVERYWHERE },
        promises: Promises { radiance: None, flux: Some(noise(medium)) },
        radiance: geometry == Geometry::Plain,
        flux: true,
        table_bytes: None,
    };
    Simple::new(card, move |card, cloud: &Cloud| {
        let medium = traced(cloud, medium).map_err(|error| card.failed(&error))?;
        let trace: Tracer = if geometry == Geometry::Plain { trace_plain } else { trace_half_space };
        Ok(Box::new(MonteCarlo { card: card.clone(), medium, trace, photons: photons as u64 }))
    })
}
