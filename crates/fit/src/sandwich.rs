//! Errors of fitted parameters from the covariance of the data, where the model is not the truth.
//!
//! The fit makes p an implicit function of the data y through Jᵀr = 0. Differentiated: H dp = Jᵀ dy - H_u du,
//! with H = JᵀJ + Σrᵢ∇²rᵢ the full Hessian and u what another fit supplied. So C_p = A C_y Aᵀ + B C_u Bᵀ, A =
//! H⁻¹Jᵀ, B = -H⁻¹H_u (White 1982, Econometrica 50, 1, called the sandwich). The second term of H by central
//! differences of J.

use crate::least_squares::{LeastSquares, Solution};
use crate::matrix::dot;
use crate::qr::PivotedQr;
use crate::{FitError, Matrix};

/// How the fitted parameters answer to the data.
pub(crate) struct Sensitivity {
    free: Vec<usize>,
    /// H in D·H·D = Q·R with D = 1/√diag(JᵀJ) over the free parameters.
    factors: PivotedQr,
    scale: Vec<f64>,
    hessian: Matrix,
    jacobian: Matrix,
    supplied: Vec<(usize, f64)>,
}

/// Covariances of free parameters.
pub(crate) struct Covariance {
    free: Vec<usize>,
    values: Matrix,
}

const RELATIVE_STEP: f64 = 1e-5;

impl Sensitivity {
    /// At a minimum inside the intervals `allowed`. Parameters on a bound, or `fixed`, are taken as known, without error,
    /// but for those `supplied` with a variance. `None` where H is singular.
    pub fn new<L: LeastSquares>(
        problem: &L,
        solution: &Solution,
        allowed: &[[f64; 2]],
        supplied: &[(usize, f64)],
        fixed: &[usize],
    ) -> Result<Option<Self>, FitError> {
        let is_free = |i: &usize| !solution.on_bound[*i] && !fixed.contains(i);
        let free: Vec<usize> = (0..allowed.len()).filter(is_free).collect();
        let moved: Vec<usize> = free.iter().copied().chain(supplied.iter().map(|s| s.0)).collect();
        let hessian = hessian(problem, solution, allowed, &moved)?;
        let jacobian = solution.jacobian.clone();
        let scale: Vec<f64> =
            free.iter().map(|&i| dot(jacobian.column(i), jacobian.column(i)).sqrt()).collect();
        if scale.contains(&0.0) {
            return Ok(None);
        }
        let scaled = Matrix::square(free.len(), |i, j| hessian.get(free[i], free[j]) / scale[i] / scale[j]);
        let factors = PivotedQr::new(scaled);
        Ok(factors.has_full_rank().then_some(Self {
            free,
            factors,
            scale,
            hessian,
            jacobian,
            supplied: supplied.to_vec(),
        }))
    }

    /// H⁻¹ v over the free parameters.
    fn invert(&self, v: &[f64]) -> Vec<f64> {
        let scaled: Vec<f64> = v.iter().zip(&self.scale).map(|(v, s)| v / s).collect();
        let solved = self.factors.solve(&self.factors.project(&scaled));
        solved.iter().zip(&self.scale).map(|(v, s)| v / s).collect()
    }

    /// C_p from blocks of C_y that follow each other along the data.
    pub fn covariance(&self, blocks: &[Matrix]) -> Covariance {
        let n = self.free.len();
        let mut values = Matrix::zeros(n, n);
        let mut offset = 0;
        for block in blocks {
            let mut answers = Matrix::zeros(block.rows(), n);
            let columns: Vec<Vec<f64>> = (0..block.rows()).map(|i| self.to_datum(offset + i)).collect();
            for (i, column) in columns.iter().enumerate() {
                (0..n).for_each(|j| answers.set(i, j, column[j]));
            }
            for j in 0..n {
                let spread = block.times(answers.column(j));
                (0..n).for_each(|i| values.set(i, j, values.get(i, j) + dot(answers.column(i), &spread)));
            }
            offset += block.rows();
        }
        for &(parameter, variance) in &self.supplied {
            let by: Vec<f64> = self.free.iter().map(|&i| -self.hessian.get(i, parameter)).collect();
            let answer = self.invert(&by);
            for j in 0..n {
                (0..n).for_each(|i| values.set(i, j, values.get(i, j) + answer[i] * answer[j] * variance));
            }
        }
        Covariance { free: self.free.clone(), values }
    }

    /// dp/dyᵢ.
    fn to_datum(&self, i: usize) -> Vec<f64> {
        let row: Vec<f64> = self.free.iter().map(|&j| self.jacobian.get(i, j)).collect();
        self.invert(&row)
    }
}

/// JᵀJ + Σr∇²r; the second term only in the columns of the `moved` parameters.
fn hessian<L: LeastSquares>(
    problem: &L,
    solution: &Solution,
    allowed: &[[f64; 2]],
    moved: &[usize],
) -> Result<Matrix, FitError> {
    let (p, jacobian) = (&solution.parameters, &solution.jacobian);
    let mut hessian = Matrix::square(p.len(), |i, j| dot(jacobian.column(i), jacobian.column(j)));
    let (mut at, mut there) = (p.clone(), jacobian.clone());
    for &j in moved {
        let h = RELATIVE_STEP * p[j].abs().max(RELATIVE_STEP);
        let [lower, upper] = allowed[j];
        // A supplied parameter has no room between its bounds: one step down from it is inside every model's
        // domain.
        let ends =
            if lower < upper { [(p[j] - h).max(lower), (p[j] + h).min(upper)] } else { [p[j] - h, p[j]] };
        for (end, sign) in ends.into_iter().zip([-1.0, 1.0]) {
            at[j] = end;
            problem.jacobian(&at, &mut there)?;
            for (i, value) in there.transposed_times(&solution.residuals).into_iter().enumerate() {
                hessian.set(i, j, hessian.get(i, j) + sign * value / (ends[1] - ends[0]));
            }
        }
        at[j] = p[j];
    }
    Ok(hessian)
}

impl Covariance {
    fn place(&self, parameter: usize) -> Option<usize> {
        self.free.iter().position(|&i| i == parameter)
    }

    /// Standard error of a parameter; `None` where it was not free.
    pub fn std_error(&self, parameter: usize) -> Option<f64> {
        self.place(parameter).map(|i| self.values.get(i, i).max(0.0).sqrt())
    }

    /// Correlation of two parameters; `None` where one was not free or has no error.
    pub fn correlation(&self, a: usize, b: usize) -> Option<f64> {
        let (i, j) = (self.place(a)?, self.place(b)?);
        let product = (self.values.get(i, i) * self.values.get(j, j)).sqrt();
        (product > 0.0).then(|| (self.values.get(i, j) / product).clamp(-1.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::least_squares::{Bounds, Options, solve};

    /// e^{-px} + q fitted to data it cannot follow.
    struct Decay(Vec<f64>);

    impl Decay {
        fn shifted(&self, by: &[f64], factor: f64) -> Self {
            Self(self.0.iter().zip(by).map(|(y, d)| y + factor * d).collect())
        }

        fn fit(&self, q: [f64; 2]) -> Solution {
            let bounds = Bounds::new(&[[0.0, 10.0], q]).unwrap();
            solve(self, &[1.0, q[0]], &bounds, &Options::default()).unwrap()
        }
    }

    impl LeastSquares for Decay {
        fn residual_count(&self) -> usize {
            self.0.len()
        }

        fn residuals(&self, p: &[f64], out: &mut [f64]) -> Result<(), FitError> {
            for (k, (r, y)) in out.iter_mut().zip(&self.0).enumerate() {
                *r = libm::exp(-p[0] * k as f64) + p[1] - y;
            }
            Ok(())
        }

        fn jacobian(&self, p: &[f64], out: &mut Matrix) -> Result<(), FitError> {
            for k in 0..self.0.len() {
                out.set(k, 0, -(k as f64) * libm::exp(-p[0] * k as f64));
                out.set(k, 1, 1.0);
            }
            Ok(())
        }
    }

    const Q: [f64; 2] = [-5.0, 5.0];

    fn data() -> (Decay, [f64; 5]) {
        (Decay(vec![0.7, 1.2, -0.3, 0.6, -0.1]), [0.3, -1.0, 0.5, 0.2, 0.7])
    }

    /// Refits with the data moved along one direction give dp; the covariance of that direction must be
    /// dp·dpᵀ. Without the second derivatives of the model it would be far off here.
    #[test]
    fn the_sensitivity_is_that_of_refits() {
        let (decay, direction) = data();
        let solution = decay.fit(Q);
        let answer = |sign: f64| decay.shifted(&direction, sign * 1e-5).fit(Q).parameters;
        let (plus, minus) = (answer(1.0), answer(-1.0));
        let change = |i: usize| (plus[i] - minus[i]) / 2e-5;
        let block = Matrix::square(5, |i, j| direction[i] * direction[j]);
        let sensitivity = Sensitivity::new(&decay, &solution, &[[0.0, 10.0], Q], &[], &[]).unwrap().unwrap();
        let covariance = sensitivity.covariance(&[block]);
        for i in 0..2 {
            assert!((covariance.std_error(i).unwrap() / change(i).abs() - 1.0).abs() < 1e-6);
        }
        assert!((covariance.correlation(0, 1).unwrap() - (change(0) * change(1)).signum()).abs() < 1e-9);
        let first_order = dot(solution.jacobian.column(0), solution.jacobian.column(0));
        let second_order = sensitivity.hessian.get(0, 0) / first_order - 1.0;
        assert!(second_order.abs() > 0.1, "{second_order}");
    }

    #[test]
    fn a_supplied_parameter_hands_its_error_on() {
        let decay = data().0;
        let at = |q: f64| decay.fit([q, q]);
        let solution = at(0.1);
        let allowed = [[0.0, 10.0], [0.1, 0.1]];
        let sensitivity = Sensitivity::new(&decay, &solution, &allowed, &[(1, 0.04)], &[]).unwrap().unwrap();
        let covariance = sensitivity.covariance(&[Matrix::zeros(5, 5)]);
        let change = (at(0.1 + 1e-5).parameters[0] - at(0.1 - 1e-5).parameters[0]) / 2e-5;
        assert!((covariance.std_error(0).unwrap() / (0.2 * change.abs()) - 1.0).abs() < 1e-4);
        assert!(covariance.std_error(1).is_none() && covariance.correlation(0, 1).is_none());
    }
}
