//! Reflectance and transmittance of each scattering order, by successive orders.
//!
//! The same diffusely lit problem as the totals: order 0 is e^{-t/μ}; each order's field is scattered
//! (kernel) and transported (grid) into the next, and its source function integrated towards any μ0 gives,
//! by reciprocity, R_n(μ0) and T_n(μ0) for all incidences at once. Chosen over the transform of totals at
//! complex ω: no complex eigenproblem, all orders keep their relative size, and orders 0–2 cost next to
//! nothing.
//!
//! Light that was scattered n times does not reach a depth of n + 12√n + 40 (Poisson tail below 1e-13):
//! thicker slabs are cut there.

use super::grid::{Collocation, Grid};
use super::kernel::Kernel;
use super::matrix::{Matrix, add_scaled, dot};
use super::quadrature::Streams;
use super::slab::Pair;

/// What one number of streams needs for orders in any slab.
pub(crate) struct Orders {
    streams: Streams,
    omega: f64,
    even: Matrix,
    odd: Matrix,
    collocation: Collocation,
    intervals: usize,
    max_order: usize,
}

/// A direction of incidence: μ0 and the kernel into it.
pub(crate) struct View {
    mu0: f64,
    even: Vec<f64>,
    odd: Vec<f64>,
}

/// Radiances, times √w, at all points: a row of streams for each point.
struct Field {
    down: Vec<f64>,
    up: Vec<f64>,
}

impl Orders {
    pub(crate) fn new(kernel: &Kernel, count: usize, intervals: usize, omega: f64, max_order: usize) -> Self {
        let streams = Streams::new(count);
        let (even, odd) = kernel.between(&streams);
        Self { streams, omega, even, odd, collocation: Collocation::new(intervals), intervals, max_order }
    }

    pub(crate) fn view(&self, kernel: &Kernel, mu0: f64) -> View {
        let (even, odd) = kernel.towards(mu0, &self.streams);
        View { mu0, even, odd }
    }

    /// Orders 0…N of a slab, a list for each incidence; `None` is diffuse light.
    pub(crate) fn of_slab(&self, tau: f64, views: &[Option<View>]) -> Vec<Vec<Pair>> {
        let mut lists: Vec<Vec<Pair>> =
            views.iter().map(|view| vec![self.unscattered(tau, view.as_ref())]).collect();
        let n = self.max_order as f64;
        let deepest = n + 12.0 * n.sqrt() + 40.0;
        if tau == 0.0 {
            lists.iter_mut().for_each(|list| list.resize(self.max_order + 1, NOTHING));
            return lists;
        }
        let sweep = Sweep::new(self, tau.min(deepest));
        let mut field = sweep.unscattered();
        for _ in 0..self.max_order {
            let before = field;
            field = sweep.transport(&self.scatter(&before));
            for (list, view) in lists.iter_mut().zip(views) {
                let mut pair = match view {
                    Some(view) => sweep.towards(view, &before),
                    None => sweep.fluxes(&field),
                };
                if tau > deepest {
                    pair.transmittance = 0.0;
                }
                list.push(pair);
            }
        }
        lists
    }

    fn unscattered(&self, tau: f64, view: Option<&View>) -> Pair {
        let streams = &self.streams;
        let transmittance = match view {
            _ if tau == 0.0 => 1.0,
            Some(view) => libm::exp(-tau / view.mu0),
            None => streams
                .mu
                .iter()
                .zip(&streams.weight)
                .fold(0.0, |sum, (mu, w)| sum + 2.0 * w * mu * libm::exp(-tau / mu)),
        };
        Pair { reflectance: 0.0, transmittance }
    }

    /// Source functions of the next order: ½ω(E(u+v) ± O(u-v)).
    fn scatter(&self, field: &Field) -> Field {
        let count = self.streams.count();
        let mut source = Field { down: vec![0.0; field.down.len()], up: vec![0.0; field.up.len()] };
        let (mut even, mut odd) = (vec![0.0; count], vec![0.0; count]);
        let fields = field.down.chunks(count).zip(field.up.chunks(count));
        let sources = source.down.chunks_mut(count).zip(source.up.chunks_mut(count));
        for ((u, v), (down, up)) in fields.zip(sources) {
            even.fill(0.0);
            odd.fill(0.0);
            for j in 0..count {
                add_scaled(&mut even, u[j] + v[j], self.even.row(j));
                add_scaled(&mut odd, u[j] - v[j], self.odd.row(j));
            }
            for i in 0..count {
                down[i] = 0.5 * self.omega * (even[i] + odd[i]);
                up[i] = 0.5 * self.omega * (even[i] - odd[i]);
            }
        }
        source
    }
}

const NOTHING: Pair = Pair { reflectance: 0.0, transmittance: 0.0 };

/// One slab on its grid.
struct Sweep<'a> {
    orders: &'a Orders,
    grid: Grid,
    /// For each width, point i and source j (the last: radiance at the start) a row of streams.
    through: Vec<Vec<f64>>,
}

impl<'a> Sweep<'a> {
    fn new(orders: &'a Orders, tau: f64) -> Self {
        let mu = &orders.streams.mu;
        let grid = Grid::new(tau, mu[mu.len() - 1], orders.intervals);
        let through = grid.widths.iter().map(|width| through(orders, *width)).collect();
        Self { orders, grid, through }
    }

    fn unscattered(&self) -> Field {
        let streams = &self.orders.streams;
        let mut field = Field { down: vec![0.0; self.size()], up: vec![0.0; self.size()] };
        let p = self.orders.intervals;
        let mut depth = 0.0;
        for (start, &panel) in self.grid.panels.iter().enumerate() {
            let width = self.grid.widths[panel];
            for i in 0..=p {
                let sine = libm::sin(0.5 * std::f64::consts::PI * i as f64 / p as f64);
                let t = depth + width * sine * sine;
                let row = (start * p + i) * streams.count();
                for (m, mu) in streams.mu.iter().enumerate() {
                    field.down[row + m] = streams.root_weight[m] * libm::exp(-t / mu);
                }
            }
            depth += width;
        }
        field
    }

    fn size(&self) -> usize {
        self.grid.points() * self.orders.streams.count()
    }

    /// The field of `source`, no light entering.
    fn transport(&self, source: &Field) -> Field {
        let (count, p, panels) = (self.orders.streams.count(), self.orders.intervals, &self.grid.panels);
        let mut field = Field { down: vec![0.0; self.size()], up: vec![0.0; self.size()] };
        let last = self.grid.points() - 1;
        for (k, &panel) in panels.iter().enumerate() {
            let points = |i: usize| (k * p + i) * count;
            self.panel(&self.through[panel], &source.down, &mut field.down, points);
        }
        for (k, &panel) in panels.iter().rev().enumerate() {
            let points = |i: usize| (last - k * p - i) * count;
            self.panel(&self.through[panel], &source.up, &mut field.up, points);
        }
        field
    }

    /// Points 1…p of a panel from the sources there and the radiance at point 0; `at` finds a point's row.
    fn panel(&self, through: &[f64], source: &[f64], field: &mut [f64], at: impl Fn(usize) -> usize) {
        let (count, p) = (self.orders.streams.count(), self.orders.intervals);
        let start: Vec<f64> = field[at(0)..at(0) + count].to_vec();
        for i in 0..p {
            let target = &mut field[at(i + 1)..at(i + 1) + count];
            for j in 0..=p {
                let row = (i * (p + 1) + j) * count;
                let from = if j == p { &start[..] } else { &source[at(j + 1)..at(j + 1) + count] };
                let terms = through[row..row + count].iter().zip(from);
                target.iter_mut().zip(terms).for_each(|(t, (factor, value))| *t += factor * value);
            }
        }
    }

    /// Flux out of the top and the bottom per unit of diffuse flux in.
    fn fluxes(&self, field: &Field) -> Pair {
        let streams = &self.orders.streams;
        let count = streams.count();
        let flux = |row: &[f64]| {
            (0..count).fold(0.0, |sum, i| sum + 2.0 * streams.mu[i] * streams.root_weight[i] * row[i])
        };
        let bottom = field.down.len() - count;
        Pair { reflectance: flux(&field.up[..count]), transmittance: flux(&field.down[bottom..]) }
    }

    /// Radiance leaving towards μ0 above and below, of light that is scattered once more than `before`.
    fn towards(&self, view: &View, before: &Field) -> Pair {
        let count = self.orders.streams.count();
        let half = 0.5 * self.orders.omega;
        let (mut down, mut up) = (Vec::new(), Vec::new());
        for (u, v) in before.down.chunks(count).zip(before.up.chunks(count)) {
            let even = dot(&view.even, u) + dot(&view.even, v);
            let odd = dot(&view.odd, u) - dot(&view.odd, v);
            down.push(half * (even + odd));
            up.push(half * (even - odd));
        }
        up.reverse();
        Pair { reflectance: self.along(view.mu0, &up), transmittance: self.along(view.mu0, &down) }
    }

    /// Radiance at the end of a ray with cosine `mu0` through all panels (a mirror image both ways).
    fn along(&self, mu0: f64, source: &[f64]) -> f64 {
        let p = self.orders.intervals;
        if mu0 == 0.0 {
            return source[source.len() - 1];
        }
        let rows: Vec<Vec<f64>> =
            self.grid.widths.iter().map(|width| self.orders.collocation.leaving(width / mu0)).collect();
        self.grid.panels.iter().enumerate().fold(0.0, |radiance, (k, &panel)| {
            let row = &rows[panel];
            row[p] * radiance + dot(&row[..p], &source[k * p + 1..=(k + 1) * p])
        })
    }
}

/// Transport coefficients of one width, streams innermost.
fn through(orders: &Orders, width: f64) -> Vec<f64> {
    let (count, p) = (orders.streams.count(), orders.intervals);
    let mut table = vec![0.0; p * (p + 1) * count];
    for (m, mu) in orders.streams.mu.iter().enumerate() {
        for (i, row) in orders.collocation.through(width / mu).iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                table[(i * (p + 1) + j) * count + m] = *value;
            }
        }
    }
    table
}
