//! The totals: T_ms = (b + (1-b)e^{-cτ})/(1 + (1-β)τ/β) of the full medium, fitted with one β for all its
//! rows.
//!
//! Parameters are β, then (b, c) of each row. The sum of squares has several minima where b is near 1. Given
//! β and c it is quadratic in b, hence a start is found by scanning β and c on logarithmic grids with the
//! best b in closed form; after the fit each row is scanned again at the fitted β, and the fit repeated from
//! any better point found.

use crate::config::ParameterBounds;
use crate::least_squares::{Bounds, LeastSquares, Options, Solution, solve};
use crate::{FitError, Matrix};
use stratiform_model::{Form, Parameters, Thickness, Values, derivatives};
use stratiform_quantities::Incidence;

/// Rows of T_ms that share β.
pub(crate) struct Totals<'a> {
    pub tau: &'a [f64],
    pub rows: Vec<&'a [f64]>,
}

/// b and c of row `row` in the parameter vector.
pub(crate) const fn place_of_b(row: usize) -> usize {
    1 + 2 * row
}

/// Bounds, and what is held: β, and c of some rows.
pub(crate) struct Held {
    pub beta: Option<f64>,
    pub c: Vec<Option<f64>>,
}

const ROUNDS: usize = 4;

impl Totals<'_> {
    fn parameters(p: &[f64], row: usize) -> Result<Parameters<f64>, FitError> {
        let (b, c) = (p[place_of_b(row)], p[place_of_b(row) + 1]);
        let values = Values { beta: p[0], b, c, kappa_c: 1.0, t: 0.0, r: 0.0, kappa_s: 0.0 };
        Ok(Parameters::new(&values, Incidence::Diffuse)?)
    }

    /// The least squares inside `bounds`, with what is `held`.
    pub fn fit(&self, bounds: &ParameterBounds, held: &Held) -> Result<Solution, FitError> {
        let allowed = Self::allowed(bounds, held);
        let box_of = Bounds::new(&allowed)?;
        let scan = Scan::new(self, &allowed);
        let mut start = scan.best_start();
        for _ in 0..ROUNDS {
            let solution = solve(self, &start, &box_of, &Options::default())?;
            match scan.improved(&solution) {
                Some(better) => start = better,
                None => return Ok(solution),
            }
        }
        solve(self, &start, &box_of, &Options::default())
    }

    /// One interval per parameter; held ones are points.
    pub fn allowed(bounds: &ParameterBounds, held: &Held) -> Vec<[f64; 2]> {
        let point = |value: &Option<f64>, interval| value.map_or(interval, |v| [v, v]);
        let mut allowed = vec![point(&held.beta, bounds.beta)];
        held.c.iter().for_each(|c| allowed.extend([bounds.b, point(c, bounds.c)]));
        allowed
    }
}

impl LeastSquares for Totals<'_> {
    fn residual_count(&self) -> usize {
        self.rows.len() * self.tau.len()
    }

    fn residuals(&self, p: &[f64], out: &mut [f64]) -> Result<(), FitError> {
        for (row, (data, out)) in self.rows.iter().zip(out.chunks_mut(self.tau.len())).enumerate() {
            let parameters = Self::parameters(p, row)?;
            for ((out, data), &tau) in out.iter_mut().zip(*data).zip(self.tau) {
                *out = parameters.fluxes(Form::Corrected, Thickness::new(tau)?).t_ms - data;
            }
        }
        Ok(())
    }

    fn jacobian(&self, p: &[f64], out: &mut Matrix) -> Result<(), FitError> {
        for row in 0..self.rows.len() {
            let parameters = Self::parameters(p, row)?;
            for (k, &tau) in self.tau.iter().enumerate() {
                let by = derivatives::t_ms(&parameters, Thickness::new(tau)?);
                let i = row * self.tau.len() + k;
                out.set(i, 0, by[0]);
                out.set(i, place_of_b(row), by[1]);
                out.set(i, place_of_b(row) + 1, by[2]);
            }
        }
        Ok(())
    }
}

/// The search over β and c.
struct Scan<'a> {
    totals: &'a Totals<'a>,
    allowed: &'a [[f64; 2]],
}

/// Points from `lower` to `upper` in geometric progression; one where they coincide.
pub(crate) fn geometric([lower, upper]: [f64; 2], count: usize) -> Vec<f64> {
    if lower == upper {
        return vec![lower];
    }
    let step = libm::log(upper / lower) / (count - 1) as f64;
    (0..count).map(|i| (lower * libm::exp(step * i as f64)).clamp(lower, upper)).collect()
}

impl<'a> Scan<'a> {
    const BETAS: usize = 60;
    const RATES: usize = 60;

    fn new(totals: &'a Totals<'a>, allowed: &'a [[f64; 2]]) -> Self {
        Self { totals, allowed }
    }

    /// β with slopes (1-β)/β in geometric progression.
    fn betas(&self, slopes: [f64; 2]) -> Vec<f64> {
        let [lower, upper] = self.allowed[0];
        let beta = |slope: &f64| (1.0 / (1.0 + slope)).clamp(lower, upper);
        geometric(slopes, Self::BETAS).iter().map(beta).collect()
    }

    /// The b of least squares for this row, β and c, and the sum of squares.
    fn best_b(&self, row: usize, beta: f64, decays: &[f64]) -> (f64, f64) {
        let [lower, upper] = self.allowed[place_of_b(row)];
        let slope = (1.0 - beta) / beta;
        let term = |k: usize| {
            let base = 1.0 / (1.0 + slope * self.totals.tau[k]);
            ((1.0 - decays[k]) * base, self.totals.rows[row][k] - decays[k] * base)
        };
        let (mut product, mut square) = (0.0, 0.0);
        for (a, y) in (0..decays.len()).map(term) {
            product += a * y;
            square += a * a;
        }
        let b = (product / square).clamp(lower, upper);
        let sum = (0..decays.len()).map(term).fold(0.0, |sum, (a, y)| sum + (a * b - y) * (a * b - y));
        (b, sum)
    }

    /// Rates c of this row with e^{-cτ} on the grid.
    fn rates(&self, row: usize) -> Vec<(f64, Vec<f64>)> {
        let decays = |c: f64| self.totals.tau.iter().map(|tau| libm::exp(-c * tau)).collect();
        geometric(self.allowed[place_of_b(row) + 1], Self::RATES)
            .into_iter()
            .map(|c| (c, decays(c)))
            .collect()
    }

    /// The best (b, c) of this row at `beta`, and its sum of squares.
    fn best_pair(&self, row: usize, beta: f64, rates: &[(f64, Vec<f64>)]) -> ([f64; 2], f64) {
        let mut best = ([f64::NAN; 2], f64::INFINITY);
        for (c, decays) in rates {
            let (b, sum) = self.best_b(row, beta, decays);
            if sum < best.1 {
                best = ([b, *c], sum);
            }
        }
        best
    }

    /// Scans β over its bounds, then twice more around the best: a wrong β drives the c of rows with b near 1
    /// to the wrong side, from where the fit does not come back. 1e-6 stands for the slope of β = 1.
    fn best_start(&self) -> Vec<f64> {
        let rates: Vec<_> = (0..self.totals.rows.len()).map(|row| self.rates(row)).collect();
        let slope = |beta: f64| ((1.0 - beta) / beta).max(1e-6);
        let [lower, upper] = self.allowed[0].map(slope);
        let (mut slopes, mut best) = ([upper, lower], (Vec::new(), f64::INFINITY));
        for _ in 0..3 {
            for beta in self.betas(slopes) {
                let (point, sum) = self.best_at(beta, &rates);
                if sum < best.1 {
                    best = (point, sum);
                }
            }
            let step = libm::pow(slopes[1] / slopes[0], 1.0 / (Self::BETAS - 1) as f64);
            let centre = best.0.first().map_or(upper, |beta| slope(*beta));
            slopes = [(centre / step).max(upper), (centre * step).min(lower)];
        }
        best.0
    }

    /// β with the best (b, c) of every row, and the sum of squares.
    fn best_at(&self, beta: f64, rates: &[Vec<(f64, Vec<f64>)>]) -> (Vec<f64>, f64) {
        let (mut point, mut sum) = (vec![beta], 0.0);
        for (row, rates) in rates.iter().enumerate() {
            let (pair, square) = self.best_pair(row, beta, rates);
            point.extend(pair);
            sum += square;
        }
        (point, sum)
    }

    /// The fitted point with every row replaced for which the scan at the fitted β finds a lower sum.
    fn improved(&self, solution: &Solution) -> Option<Vec<f64>> {
        let mut point = solution.parameters.clone();
        let count = self.totals.tau.len();
        for (row, residuals) in solution.residuals.chunks(count).enumerate() {
            let fitted = residuals.iter().fold(0.0, |sum, r| sum + r * r);
            let (pair, sum) = self.best_pair(row, point[0], &self.rates(row));
            if sum < fitted * (1.0 - 1e-6) - 1e-24 {
                point[place_of_b(row)..place_of_b(row) + 2].copy_from_slice(&pair);
            }
        }
        (point != solution.parameters).then_some(point)
    }
}
