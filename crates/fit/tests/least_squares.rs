//! The optimiser's own behaviour: bounds, outcomes, derivatives.
#![allow(clippy::unwrap_used, reason = "a test")]

use rand::Rng;
use stratiform_fit::least_squares::{
    Bounds, Criterion, LeastSquares, Options, Outcome, numerical_jacobian, solve,
};
use stratiform_fit::{FitError, Matrix};
use stratiform_stats::{Purpose, key, photon_stream};

/// Rosenbrock's valley, (10(y - x²), 1 - x), with a factor on the derivatives.
struct Valley {
    slip: f64,
}

impl LeastSquares for Valley {
    fn residual_count(&self) -> usize {
        2
    }

    fn residuals(&self, p: &[f64], out: &mut [f64]) -> Result<(), FitError> {
        out.copy_from_slice(&[10.0 * (p[1] - p[0] * p[0]), 1.0 - p[0]]);
        Ok(())
    }

    fn jacobian(&self, p: &[f64], out: &mut Matrix) -> Result<(), FitError> {
        out.column_mut(0).copy_from_slice(&[-20.0 * p[0] * self.slip, -self.slip]);
        out.column_mut(1).copy_from_slice(&[10.0, 0.0]);
        Ok(())
    }
}

const RIGHT: Valley = Valley { slip: 1.0 };

fn valley(start: [f64; 2], bounds: [[f64; 2]; 2]) -> stratiform_fit::least_squares::Solution {
    solve(&RIGHT, &start, &Bounds::new(&bounds).unwrap(), &Options::default()).unwrap()
}

const WIDE: [f64; 2] = [-10.0, 10.0];

#[test]
fn the_free_minimum_is_reached() {
    let solution = valley([-1.2, 1.0], [WIDE, WIDE]);
    assert!(solution.outcome.has_converged(), "{}", solution.outcome);
    assert!(solution.parameters.iter().all(|p| (p - 1.0).abs() < 1e-12));
    assert_eq!(solution.on_bound, [false, false]);
}

/// With x ≤ ½ the minimum is (½, ¼): by hand, x on its bound and y = x².
#[test]
fn a_bound_is_met_exactly_and_the_rest_is_minimised() {
    for start in [[-1.2, 1.0], [0.5, -3.0], [0.4, 9.0]] {
        let solution = valley(start, [[-2.0, 0.5], WIDE]);
        assert!(solution.outcome.has_converged(), "{}", solution.outcome);
        assert_eq!(solution.parameters[0], 0.5);
        assert!((solution.parameters[1] - 0.25).abs() < 1e-12);
        assert_eq!(solution.on_bound, [true, false]);
    }
}

/// With y = 0.3 the other variable makes d/dx ½[100(0.3 - x²)² + (1 - x)²] vanish.
#[test]
fn the_gradient_vanishes_along_the_bound() {
    let solution = valley([0.0, 0.0], [WIDE, [-1.0, 0.3]]);
    let x = solution.parameters[0];
    assert_eq!(solution.parameters[1], 0.3);
    assert!((-200.0 * x * (0.3 - x * x) - (1.0 - x)).abs() < 1e-10, "{x}");
}

#[test]
fn a_start_on_a_bound_is_freed_when_the_descent_points_inward() {
    let solution = valley([-2.0, -5.0], [[-2.0, 10.0], [-5.0, 10.0]]);
    assert!(solution.parameters.iter().all(|p| (p - 1.0).abs() < 1e-12), "{:?}", solution.parameters);
}

#[test]
fn equal_bounds_hold_a_parameter() {
    let solution = valley([0.7, 0.0], [[0.7, 0.7], WIDE]);
    assert_eq!(solution.parameters[0], 0.7);
    assert!((solution.parameters[1] - 0.49).abs() < 1e-12);
    let held = valley([0.7, 0.1], [[0.7, 0.7], [0.1, 0.1]]);
    assert_eq!(
        (held.parameters.as_slice(), held.outcome),
        ([0.7, 0.1].as_slice(), Outcome::Converged(Criterion::Gtol))
    );
}

#[test]
fn wrong_derivatives_do_not_pass_for_convergence() {
    let bounds = Bounds::none(2);
    let solution = solve(&Valley { slip: -1.0 }, &[-1.2, 1.0], &bounds, &Options::default()).unwrap();
    assert_eq!(solution.outcome, Outcome::Stalled);
}

#[test]
fn too_few_steps_are_reported() {
    let options = Options { max_iterations: 3, ..Options::default() };
    let solution = solve(&RIGHT, &[-1.2, 1.0], &Bounds::none(2), &options).unwrap();
    assert_eq!((solution.outcome, solution.iterations), (Outcome::IterationLimit, 3));
}

/// √p - 2, without a value for p < 0, where the full step from p = 25 ends.
struct Root;

impl LeastSquares for Root {
    fn residual_count(&self) -> usize {
        1
    }

    fn residuals(&self, p: &[f64], out: &mut [f64]) -> Result<(), FitError> {
        out[0] = p[0].sqrt() - 2.0;
        Ok(())
    }

    fn jacobian(&self, p: &[f64], out: &mut Matrix) -> Result<(), FitError> {
        out.set(0, 0, 0.5 / p[0].sqrt());
        Ok(())
    }
}

#[test]
fn steps_out_of_the_domain_are_taken_back() {
    let free = Bounds::none(1);
    let solution = solve(&Root, &[25.0], &free, &Options::default()).unwrap();
    assert!((solution.parameters[0] - 4.0).abs() < 1e-12, "{} {:?}", solution.outcome, solution.parameters);
    let outcome = solve(&Root, &[-1.0], &free, &Options::default()).unwrap().outcome;
    assert_eq!(outcome, Outcome::NotFinite);
}

#[test]
fn impossible_problems_are_refused() {
    let bounds = Bounds::new(&[[0.0, 1.0]]).unwrap();
    let error = |start: &[f64]| solve(&Root, start, &bounds, &Options::default()).unwrap_err().to_string();
    assert_eq!(error(&[2.0]), "start[0] = 2 is outside [0, 1]");
    assert_eq!(error(&[f64::NAN]), "start[0] = NaN is outside [0, 1]");
    assert_eq!(error(&[0.5, 0.5]), "the start has 2 entries, expected 1");
    assert!(Bounds::new(&[[1.0, 0.0]]).is_err() && Bounds::new(&[[f64::NAN, 0.0]]).is_err());
    assert!(solve(&Root, &[1.0, 1.0], &Bounds::none(2), &Options::default()).is_err());
}

#[test]
fn differences_agree_with_the_analytic_jacobian() {
    let p = [-1.2, 1.0];
    let (mut analytic, mut numeric) = (Matrix::zeros(2, 2), Matrix::zeros(2, 2));
    RIGHT.jacobian(&p, &mut analytic).unwrap();
    numerical_jacobian(&RIGHT, &p, 1.0, &mut numeric).unwrap();
    for i in 0..2 {
        for j in 0..2 {
            assert!((analytic.get(i, j) - numeric.get(i, j)).abs() < 1e-10);
        }
    }
}

/// A·p - y, whose minimum in a box is unique.
struct Linear {
    a: Matrix,
    y: Vec<f64>,
}

impl LeastSquares for Linear {
    fn residual_count(&self) -> usize {
        self.y.len()
    }

    fn residuals(&self, p: &[f64], out: &mut [f64]) -> Result<(), FitError> {
        let model = self.a.times(p);
        out.iter_mut().zip(model).zip(&self.y).for_each(|((r, m), y)| *r = m - y);
        Ok(())
    }

    fn jacobian(&self, _p: &[f64], out: &mut Matrix) -> Result<(), FitError> {
        out.clone_from(&self.a);
        Ok(())
    }
}

/// Random problems of four correlated parameters in a box: at the minimum the gradient vanishes, or points out of the
/// box at a bound (Karush, Kuhn & Tucker).
#[test]
fn the_minimum_in_a_box_fulfils_its_conditions() {
    let mut rng = photon_stream(key(7, Purpose::Calibration), 0);
    let mut uniform = || f64::from(rng.next_u32()) / 4_294_967_296.0 - 0.5;
    let mut bound = 0;
    for case in 0..500 {
        let mut a = Matrix::zeros(7, 4);
        for j in 0..4 {
            let common = uniform();
            a.column_mut(j).iter_mut().for_each(|v| *v = common + 0.5 * uniform());
        }
        let problem = Linear { a, y: (0..7).map(|_| uniform()).collect() };
        let intervals: Vec<[f64; 2]> =
            (0..4).map(|_| [-0.5 + 0.4 * uniform(), 0.5 + 0.4 * uniform()]).collect();
        let bounds = Bounds::new(&intervals).unwrap();
        let solution = solve(&problem, &[0.0; 4], &bounds, &Options::default()).unwrap();
        assert!(solution.outcome.has_converged(), "{case}: {}", solution.outcome);
        let gradient = problem.a.transposed_times(&solution.residuals);
        for (i, g) in gradient.into_iter().enumerate() {
            let [lower, upper] = intervals[i];
            let p = solution.parameters[i];
            assert!((lower..=upper).contains(&p));
            let outward = if p == lower { g } else { -g };
            let fulfilled = if solution.on_bound[i] { outward > -1e-9 } else { g.abs() < 1e-9 };
            assert!(fulfilled, "{case}: gradient {g} at {p} in [{lower}, {upper}]");
            bound += u32::from(solution.on_bound[i]);
        }
    }
    assert!((500..1500).contains(&bound), "{bound} of 2000 on a bound: the test tests little");
}
