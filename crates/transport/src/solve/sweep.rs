//! Light of one order after the other in one slab, on its grid.

use super::grid::Grid;
use super::orders::{Kernels, Orders};
use super::panel::Panel;
use super::slab::Pair;

/// One slab, with the panel that it shares with no other.
pub(crate) struct Sweep<'a> {
    orders: &'a Orders<'a>,
    grid: Grid,
    last: Panel,
}

/// Radiances, times √w, or sources at all points from the top: a row of directions for each point.
pub(crate) struct Field {
    down: Vec<f64>,
    up: Vec<f64>,
}

/// Sum and difference of the radiances down and up.
pub(crate) struct Mixed {
    sum: Vec<f64>,
    difference: Vec<f64>,
}

impl Mixed {
    pub(crate) fn new(field: &Field) -> Self {
        let each = || field.down.iter().zip(&field.up);
        Self { sum: each().map(|(u, v)| u + v).collect(), difference: each().map(|(u, v)| u - v).collect() }
    }

    /// Sources of the next order.
    pub(crate) fn scattered(&self, kernels: &Kernels) -> Field {
        let [even, odd] = kernels.of(&self.sum, &self.difference);
        let each = || even.iter().zip(&odd);
        Field { down: each().map(|(e, o)| e + o).collect(), up: each().map(|(e, o)| e - o).collect() }
    }
}

impl<'a> Sweep<'a> {
    pub(crate) fn new(orders: &'a Orders, tau: f64) -> Self {
        let grid = Grid::new(tau, orders.smallest_mu(), orders.intervals());
        let last = orders.panel(grid.widths[grid.widths.len() - 1]);
        Self { orders, grid, last }
    }

    /// Panels from the top, the same from the bottom.
    fn panels(&self) -> impl Iterator<Item = &Panel> {
        let own = self.grid.widths.len() - 1;
        self.grid.panels.iter().map(move |k| if *k == own { &self.last } else { self.orders.doubling(*k) })
    }

    fn count(&self) -> usize {
        self.orders.streams.count()
    }

    fn dark(&self) -> Field {
        let size = self.grid.points() * self.count();
        Field { down: vec![0.0; size], up: vec![0.0; size] }
    }

    /// Diffuse light from above that met nothing.
    pub(crate) fn unscattered(&self) -> Field {
        let (count, p) = (self.count(), self.orders.intervals());
        let mut field = self.dark();
        let mut start = self.orders.streams.root_weight.clone();
        for (panel, points) in self.panels().zip(field.down.chunks_mut(p * count)) {
            for (row, fading) in points.chunks_exact_mut(count).zip(panel.fading.chunks_exact(count)) {
                let faded = start.iter().zip(fading);
                row.iter_mut().zip(faded).for_each(|(value, (start, fading))| *value = start * fading);
            }
            let fading = &panel.fading[p * count..];
            start.iter_mut().zip(fading).for_each(|(start, fading)| *start *= fading);
        }
        let bottom = field.down.len() - count;
        field.down[bottom..].copy_from_slice(&start);
        field
    }

    /// The field of `source`, no light entering.
    pub(crate) fn transport(&self, source: &Field) -> Field {
        let mut field = self.dark();
        let panels: Vec<&Panel> = self.panels().collect();
        transport(&panels, source, &mut field, (self.orders.intervals(), self.count()));
        field
    }

    /// Flux out of the top and the bottom per unit of diffuse flux in.
    pub(crate) fn fluxes(&self, field: &Field) -> Pair {
        let (streams, count) = (self.orders.streams, self.count());
        let flux = |row: &[f64]| {
            (0..count).fold(0.0, |sum, i| sum + 2.0 * streams.mu[i] * streams.root_weight[i] * row[i])
        };
        let bottom = field.down.len() - count;
        Pair { reflectance: flux(&field.up[..count]), transmittance: flux(&field.down[bottom..]) }
    }

    /// What leaves along each beam above and below.
    pub(crate) fn along(&self, source: &Field) -> Vec<Pair> {
        let (p, last) = (self.orders.intervals(), self.grid.points() - 1);
        let count = source.down.len() / (last + 1);
        let (mut down, mut up) = (vec![0.0; count], vec![0.0; count]);
        if count == 0 {
            return Vec::new();
        }
        for (k, panel) in self.panels().enumerate() {
            panel.leave(&source.down, &mut down, |i| k * p + i);
            panel.leave(&source.up, &mut up, |i| last - k * p - i);
        }
        let pair = |(transmittance, reflectance)| Pair { reflectance, transmittance };
        down.into_iter().zip(up).map(pair).collect()
    }
}

/// Both ways through all panels, `p` intervals each.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn transport(panels: &[&Panel], source: &Field, field: &mut Field, (p, count): (usize, usize)) {
    let last = panels.len() * p;
    for (k, panel) in panels.iter().enumerate() {
        panel.cross(&source.down, &mut field.down, count, |i| k * p + i);
        panel.cross(&source.up, &mut field.up, count, |i| last - k * p - i);
    }
}
