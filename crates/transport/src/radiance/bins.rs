//! Radiance in angular bins: whole numbers of photons.

use super::RadianceRequest;
use super::flight::Flight;
use super::request::{orders, row_of};
use super::rounds;
use crate::walk::End;
use crate::{Control, TraceMedium, TransportError};
use glam::DVec3;
use std::f64::consts::PI;
use std::ops;
use stratiform_quantities::{CosZenith, Order, Range, Side};
use stratiform_stats::{Estimate, Purpose, key};

/// Photons of one share: enough to keep the lanes filled.
const SHARE: u64 = 1 << 14;

/// Bins in μ and |φ|, the same for both faces. Edges may leave out a part of the hemisphere.
#[derive(Clone, Debug, PartialEq)]
pub struct AngularBins {
    mu: Vec<f64>,
    phi_deg: Vec<f64>,
}

impl AngularBins {
    /// Bins between ascending edges: μ in \[0, 1\], |φ| in \[0, 180\] degrees (azimuths φ and -φ share a bin).
    ///
    /// # Errors
    /// [`TransportError::Edges`] unless each list has two edges at least, ascending, within its range.
    pub fn new(mu: Vec<f64>, phi_deg: Vec<f64>) -> Result<Self, TransportError> {
        edges("mu", &mu, Range::closed(0.0, 1.0))?;
        edges("phi (degrees)", &phi_deg, Range::closed(0.0, 180.0))?;
        Ok(Self { mu, phi_deg })
    }

    /// Bins along μ and along |φ|.
    pub fn shape(&self) -> (usize, usize) {
        (self.mu.len() - 1, self.phi_deg.len() - 1)
    }

    /// Bins of both faces.
    fn len(&self) -> usize {
        2 * self.shape().0 * self.shape().1
    }

    /// The bin of light leaving `side` along `direction`.
    fn place(&self, side: Side, direction: DVec3) -> Option<usize> {
        let mu = below(&self.mu, direction.z.abs())?;
        let phi = below(&self.phi_deg, libm::atan2(direction.y.abs(), direction.x).to_degrees())?;
        Some(self.index(side, mu, phi))
    }

    fn index(&self, side: Side, mu: usize, phi: usize) -> usize {
        let (mus, phis) = self.shape();
        (usize::from(side == Side::Bottom) * mus + mu) * phis + phi
    }

    /// ∫μ dμ dφ over a bin and its mirror image.
    fn projected(&self, mu: usize, phi: usize) -> f64 {
        let (low, high) = (self.mu[mu], self.mu[mu + 1]);
        (high - low) * (high + low) * (self.phi_deg[phi + 1] - self.phi_deg[phi]).to_radians()
    }
}

fn edges(name: &'static str, edges: &[f64], range: Range) -> Result<(), TransportError> {
    edges.iter().try_for_each(|edge| range.check(&format!("bin edge {name}"), *edge).map(|_| ()))?;
    match edges.windows(2).find(|pair| pair[0] >= pair[1]) {
        None if edges.len() >= 2 => Ok(()),
        wrong => Err(TransportError::Edges { name, at: wrong.map(|pair| (pair[0], pair[1])) }),
    }
}

/// The bin that holds `x`: lower edge included, of the last bin both.
fn below(edges: &[f64], x: f64) -> Option<usize> {
    let last = edges.len() - 2;
    // A count of all: a search's branches cannot be foretold.
    match edges.iter().fold(0, |count, edge| count + usize::from(*edge <= x)) {
        0 => None,
        bin if bin <= last + 1 => Some(bin - 1),
        _ => (x == edges[last + 1]).then_some(last),
    }
}

/// Traces radiance in `bins`.
///
/// # Errors
/// [`TransportError`] for τ, μ0 or photons out of domain, for too many bins, and on cancellation.
pub fn trace_radiance_bins(
    medium: &TraceMedium,
    request: &RadianceRequest,
    bins: &AngularBins,
    control: Control<'_>,
) -> Result<BinRadiance, TransportError> {
    request.check(bins.len())?;
    let key = key(request.seed, Purpose::RadianceInBins(request.stream));
    let flight = Flight::new(medium, request.bottom(medium), CosZenith::new(request.mu0)?, key);
    let trace = |photons: ops::Range<u64>| {
        let mut hits = vec![0_u64; bins.len() * request.rows()];
        flight.trace(photons, &mut |end| {
            if let Some(cell) = cell(request, bins, end) {
                hits[cell] += 1;
            }
        });
        hits
    };
    let mut hits = vec![0; bins.len() * request.rows()];
    let fold = |share: Vec<u64>| hits.iter_mut().zip(&share).for_each(|(sum, share)| *sum += share);
    rounds::run(request, SHARE, control, trace, fold)?;
    let rows = request.rows() - 1;
    for cell in 0..bins.len() {
        hits[rows * bins.len() + cell] = (0..rows).map(|row| hits[row * bins.len() + cell]).sum();
    }
    Ok(BinRadiance { bins: bins.clone(), photons: request.photons, max_order: request.max_order, hits })
}

/// Where light that left after scattering is counted.
fn cell(request: &RadianceRequest, bins: &AngularBins, end: &End) -> Option<usize> {
    let place = bins.place(end.side?, end.direction)?;
    (end.order > 0).then(|| request.row(end.order) * bins.len() + place)
}

/// Mean reflectance factors over bins, unscattered light left out.
#[derive(Clone, Debug, PartialEq)]
pub struct BinRadiance {
    bins: AngularBins,
    photons: u64,
    max_order: u32,
    /// Bins inside orders.
    hits: Vec<u64>,
}

impl BinRadiance {
    /// The bins.
    pub fn bins(&self) -> &AngularBins {
        &self.bins
    }

    /// Histories traced.
    pub fn photons(&self) -> u64 {
        self.photons
    }

    /// All rows: orders 1…N, tail and total.
    pub fn orders(&self) -> impl Iterator<Item = Order> + use<> {
        orders(self.max_order)
    }

    /// Photons that left `side` through bin number `mu`, `phi`.
    ///
    /// # Panics
    /// If there is no such bin, or the order was not traced by itself. So for every method with these arguments.
    pub fn hits(&self, side: Side, mu: usize, phi: usize, order: Order) -> u64 {
        let (mus, phis) = self.bins.shape();
        assert!(mu < mus && phi < phis, "bin {mu}, {phi} of {mus}, {phis}");
        self.hits[row_of(order, self.max_order) * self.bins.len() + self.bins.index(side, mu, phi)]
    }

    /// The mean of πL/(μ0F0) over the bin, weighted with μ dμ dφ.
    pub fn estimate(&self, side: Side, mu: usize, phi: usize, order: Order) -> Estimate {
        self.estimate_over(side, mu, phi..phi + 1, &[order])
    }

    /// The sum of several `orders` as a mean over several bins that follow each other along |φ|, at least one.
    pub fn estimate_over(&self, side: Side, mu: usize, phi: ops::Range<usize>, orders: &[Order]) -> Estimate {
        let each = phi.clone().flat_map(|phi| orders.iter().map(move |order| (phi, *order)));
        let hits = each.map(|(phi, order)| self.hits(side, mu, phi, order)).sum();
        let projected = phi.fold(0.0, |sum, phi| sum + self.bins.projected(mu, phi));
        let (share, scale) = (Estimate::from_hits(hits, self.photons), PI / projected);
        Estimate { value: scale * share.value, std_error: scale * share.std_error }
    }
}
