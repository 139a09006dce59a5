//! Radiances that are asked for: thicknesses outside, suns, their views inside.

use super::view::{Geometry, View};
use crate::TransportError;
use stratiform_quantities::OpticalThickness;

/// A sun and one of its views.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub(super) sun: usize,
    /// As asked.
    pub(super) mu0: f64,
    pub(super) view: View,
    pub(super) geometry: Geometry,
}

/// A pair at one thickness.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) tau: f64,
    pub(super) sun: usize,
    /// The place of its pair.
    pub(super) pair: usize,
    pub(super) geometry: Geometry,
}

/// Every pair.
///
/// # Errors
/// [`TransportError::Domain`] for μ0 or a view, or if both cosines are 0; [`TransportError::NoIncidence`],
/// [`TransportError::NoView`].
pub(super) fn pairs(suns: &[(f64, &[View])]) -> Result<Vec<Pair>, TransportError> {
    if suns.is_empty() {
        return Err(TransportError::NoIncidence);
    }
    let mut pairs = Vec::new();
    for (sun, &(mu0, views)) in suns.iter().enumerate() {
        if views.is_empty() {
            return Err(TransportError::NoView);
        }
        for &view in views {
            pairs.push(Pair { sun, mu0, view, geometry: Geometry::new(mu0, &view)? });
        }
    }
    Ok(pairs)
}

/// Every pair at every thickness.
///
/// # Errors
/// [`TransportError::Domain`] for τ, [`TransportError::NoThickness`].
pub(super) fn places(tau: &[f64], pairs: &[Pair]) -> Result<Vec<Place>, TransportError> {
    if tau.is_empty() {
        return Err(TransportError::NoThickness);
    }
    for &tau in tau {
        OpticalThickness::new(tau)?;
    }
    let at = |&tau: &f64| {
        let place = move |(pair, of): (usize, &Pair)| Place { tau, sun: of.sun, pair, geometry: of.geometry };
        pairs.iter().enumerate().map(place)
    };
    Ok(tau.iter().flat_map(at).collect())
}
