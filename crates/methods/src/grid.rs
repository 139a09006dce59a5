//! Lists of points as grids of thicknesses, suns and views, which solvers answer at once.

use crate::{FluxPoint, Point};
use stratiform_transport::solve::View;

/// Distinct numbers of a list with the place of each point in them.
fn places<T: PartialEq + Copy>(values: impl Iterator<Item = T>) -> (Vec<T>, Vec<usize>) {
    let mut distinct: Vec<T> = Vec::new();
    let place = values
        .map(|value| {
            distinct.iter().position(|other| *other == value).unwrap_or_else(|| {
                distinct.push(value);
                distinct.len() - 1
            })
        })
        .collect();
    (distinct, place)
}

/// A grid of radiances and where each point lies in it.
pub(crate) struct RadianceGrid {
    pub(crate) tau: Vec<f64>,
    pub(crate) mu_l: Vec<f64>,
    pub(crate) views: Vec<View>,
    /// (thickness, sun, view) of each point.
    pub(crate) places: Vec<(usize, usize, usize)>,
    /// Places in the caller's list.
    pub(crate) points: Vec<usize>,
}

/// A grid may hold so many times the points asked for.
const SPARSEST: usize = 4;

impl RadianceGrid {
    fn of(points: &[Point], chosen: Vec<usize>) -> Self {
        let at = |i: &usize| &points[*i];
        let (tau, taus) = places(chosen.iter().map(|i| at(i).tau));
        let (mu_l, suns) = places(chosen.iter().map(|i| at(i).mu_l));
        let view = |p: &Point| View { side: p.side, mu: p.mu_v, phi_deg: p.phi_deg };
        let (views, towards) = places(chosen.iter().map(|i| view(at(i))));
        let places = (0..chosen.len()).map(|i| (taus[i], suns[i], towards[i])).collect();
        Self { tau, mu_l, views, places, points: chosen }
    }

    fn cells(&self) -> usize {
        self.tau.len() * self.mu_l.len() * self.views.len()
    }

    /// Grids that hold all points: one, or one for each sun, or one for each sun and thickness, so that few cells are empty.
    pub(crate) fn cover(points: &[Point]) -> Vec<Self> {
        let whole = Self::of(points, (0..points.len()).collect());
        if whole.cells() <= SPARSEST * points.len() {
            return vec![whole];
        }
        let by_sun = whole.split(points, whole.mu_l.len(), |place| place.1);
        let thin = |grid: Self| {
            if grid.cells() <= SPARSEST * grid.points.len() {
                return vec![grid];
            }
            grid.split(points, grid.tau.len(), |place| place.0)
        };
        by_sun.into_iter().flat_map(thin).collect()
    }

    fn split(
        &self,
        points: &[Point],
        parts: usize,
        by: impl Fn(&(usize, usize, usize)) -> usize,
    ) -> Vec<Self> {
        let mut chosen = vec![Vec::new(); parts];
        for (place, point) in self.places.iter().zip(&self.points) {
            chosen[by(place)].push(*point);
        }
        chosen.into_iter().map(|chosen| Self::of(points, chosen)).collect()
    }
}

/// Thicknesses and suns of a list of flux points, with the places of each.
pub(crate) struct FluxGrid {
    pub(crate) tau: Vec<f64>,
    pub(crate) mu_l: Vec<f64>,
    /// (thickness, sun) of each point.
    pub(crate) places: Vec<(usize, usize)>,
}

impl FluxGrid {
    pub(crate) fn of(points: &[FluxPoint]) -> Self {
        let (tau, taus) = places(points.iter().map(|point| point.tau));
        let (mu_l, suns) = places(points.iter().map(|point| point.mu_l));
        Self { tau, mu_l, places: taus.into_iter().zip(suns).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_quantities::Side;

    /// Every point is found in one grid, at its own numbers.
    #[test]
    fn grids_hold_all_points() {
        let point = |i: u32| Point {
            tau: f64::from(i % 3 + 1),
            mu_l: f64::from(i % 7 + 1) / 7.0,
            mu_v: f64::from(i % 5 + 1) / 5.0,
            phi_deg: f64::from(i % 11),
            side: Side::BOTH[i as usize % 2],
        };
        let points: Vec<Point> = (0..40).map(point).collect();
        let mut seen = vec![0; points.len()];
        for grid in RadianceGrid::cover(&points) {
            for ((tau, sun, view), at) in grid.places.iter().zip(&grid.points) {
                let (p, v) = (&points[*at], &grid.views[*view]);
                assert!(grid.tau[*tau] == p.tau && grid.mu_l[*sun] == p.mu_l);
                assert!(v.mu == p.mu_v && v.phi_deg == p.phi_deg && v.side == p.side);
                seen[*at] += 1;
            }
        }
        assert!(seen.iter().all(|count| *count == 1));
    }
}
