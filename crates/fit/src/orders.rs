//! The orders: T_1, T_2, R_1, R_2 of the modified medium, fitted by κ_c, t, r of each row.
//!
//! T_1 and R_1 are linear in t and r once κ_c is given. A scan of κ_c on a logarithmic grid gives the starts:
//! every local minimum of the scan, of which the lowest fitted one is kept.

use crate::config::ParameterBounds;
use crate::least_squares::{Bounds, LeastSquares, Options, Solution, solve};
use crate::multiple::geometric;
use crate::{FitError, Matrix};
use stratiform_model::{Form, Parameters, Thickness, Values, derivatives};
use stratiform_quantities::Incidence;

/// The orders of one row.
pub(crate) struct Orders<'a> {
    pub tau: &'a [f64],
    pub data: &'a [Vec<f64>; 4],
}

const SCANNED: usize = 60;

impl Orders<'_> {
    fn parameters(p: &[f64]) -> Result<Parameters<f64>, FitError> {
        let values = Values { beta: 1.0, b: 1.0, c: 0.0, kappa_c: p[0], t: p[1], r: p[2], kappa_s: 0.0 };
        Ok(Parameters::new(&values, Incidence::Diffuse)?)
    }

    /// One interval per parameter.
    pub fn allowed(bounds: &ParameterBounds) -> [[f64; 2]; 3] {
        [bounds.kappa_c, bounds.t, bounds.r]
    }

    /// The least squares inside `bounds`.
    pub fn fit(&self, bounds: &ParameterBounds) -> Result<Solution, FitError> {
        let allowed = Self::allowed(bounds);
        let box_of = Bounds::new(&allowed)?;
        let mut best: Option<Solution> = None;
        for start in self.starts(&allowed)? {
            let solution = solve(self, &start, &box_of, &Options::default())?;
            if best.as_ref().is_none_or(|b| solution.sum_of_squares() < b.sum_of_squares()) {
                best = Some(solution);
            }
        }
        best.ok_or_else(|| FitError::Inconsistent("the scan of kappa_c found no start".into()))
    }

    /// The local minima of the scan.
    fn starts(&self, allowed: &[[f64; 2]; 3]) -> Result<Vec<[f64; 3]>, FitError> {
        let mut scan = Vec::with_capacity(SCANNED);
        let mut residuals = vec![0.0; self.residual_count()];
        for kappa_c in geometric(allowed[0], SCANNED) {
            let point = self.point(kappa_c, allowed);
            self.residuals(&point, &mut residuals)?;
            scan.push((point, residuals.iter().fold(0.0, |sum, r| sum + r * r)));
        }
        let sum = |i: usize| scan.get(i).map_or(f64::INFINITY, |(_, sum): &([f64; 3], f64)| *sum);
        let lowest = |i: &usize| sum(*i) <= sum(i + 1) && (*i == 0 || sum(*i) < sum(i - 1));
        Ok((0..scan.len()).filter(lowest).map(|i| scan[i].0).collect())
    }

    /// t and r from T_1 and R_1 at this κ_c.
    fn point(&self, kappa_c: f64, allowed: &[[f64; 2]; 3]) -> [f64; 3] {
        let fitted = |data: &[f64], shape: &dyn Fn(f64) -> f64, [lower, upper]: [f64; 2]| {
            let (mut product, mut square) = (0.0, 0.0);
            for (y, tau) in data.iter().zip(self.tau) {
                let s = shape(kappa_c * tau);
                product += y * s;
                square += s * s;
            }
            if square > 0.0 { (product / square).clamp(lower, upper) } else { lower }
        };
        let t = fitted(&self.data[0], &|x| x * libm::exp(-x), allowed[1]);
        let r = fitted(&self.data[2], &|x| -0.5 * libm::expm1(-2.0 * x), allowed[2]);
        [kappa_c, t, r]
    }
}

impl LeastSquares for Orders<'_> {
    fn residual_count(&self) -> usize {
        self.data.len() * self.tau.len()
    }

    fn residuals(&self, p: &[f64], out: &mut [f64]) -> Result<(), FitError> {
        let parameters = Self::parameters(p)?;
        for (k, &tau) in self.tau.iter().enumerate() {
            let fluxes = parameters.fluxes(Form::Corrected, Thickness::new(tau)?);
            for (q, flux) in [fluxes.t_1, fluxes.t_2, fluxes.r_1, fluxes.r_2].into_iter().enumerate() {
                out[q * self.tau.len() + k] = flux - self.data[q][k];
            }
        }
        Ok(())
    }

    fn jacobian(&self, p: &[f64], out: &mut Matrix) -> Result<(), FitError> {
        let parameters = Self::parameters(p)?;
        let of = [derivatives::t_1, derivatives::t_2, derivatives::r_1, derivatives::r_2];
        for (k, &tau) in self.tau.iter().enumerate() {
            for (q, derivative) in of.iter().enumerate() {
                for (j, by) in derivative(&parameters, Thickness::new(tau)?).into_iter().enumerate() {
                    out.set(q * self.tau.len() + k, j, by);
                }
            }
        }
        Ok(())
    }
}
