//! The linear problem of one face.

use super::RadiancePoint;
use crate::FitError;
use crate::matrix::{Matrix, dot};
use crate::qr::PivotedQr;
use stratiform_artifact::RadianceFace;
use stratiform_model::angular::PhaseLookup;
use stratiform_model::radiance::{Coefficients, POWERS, Slab, TERMS, basis, envelope, saturation};
use stratiform_quantities::Side;
use stratiform_stats::Estimate;

const COUNT: usize = TERMS * POWERS;

/// What is fitted to one face.
pub(super) struct Face {
    pub table: [[f64; TERMS]; POWERS],
    std_error: Vec<f64>,
    relative_std_error: f64,
}

impl Face {
    pub fn record(&self, side: Side) -> RadianceFace {
        let place = |(i, value): (usize, &f64)| Estimate { value: *value, std_error: self.std_error[i] };
        let all: Vec<Estimate> = self.table.iter().flatten().enumerate().map(place).collect();
        RadianceFace {
            side,
            coefficients: all.chunks(TERMS).map(<[Estimate]>::to_vec).collect(),
            relative_std_error: self.relative_std_error,
        }
    }
}

/// Weighted rows, right-hand sides and weights.
struct Problem {
    rows: Matrix,
    wanted: Vec<f64>,
    weights: Vec<f64>,
}

pub(super) fn fit_face(
    side: Side,
    points: &[RadiancePoint],
    cloud: &Coefficients<f64>,
    phase: &impl PhaseLookup<f64>,
) -> Result<Face, FitError> {
    let points: Vec<&RadiancePoint> = points.iter().filter(|point| point.side == side).collect();
    if points.len() < 2 * COUNT {
        let (got, least) = (points.len(), 2 * COUNT);
        return Err(FitError::Inconsistent(format!(
            "{got} radiances at the {side}: at least {least} are needed"
        )));
    }
    let problem = problem(&points, cloud, phase)?;
    let qr = PivotedQr::new(problem.rows.clone());
    let Some(factor) = qr.covariance_factor() else {
        return Err(FitError::Inconsistent(format!(
            "the radiances at the {side} do not determine the model"
        )));
    };
    let solution = qr.solve(&qr.project(&problem.wanted));
    let covariance = sandwich(&problem, &factor, &solution);
    let std_error = (0..COUNT).map(|i| covariance.get(i, i).max(0.0).sqrt()).collect();
    let mut table = [[0.0; TERMS]; POWERS];
    table.iter_mut().flatten().zip(&solution).for_each(|(a, value)| *a = *value);
    Ok(Face { table, std_error, relative_std_error: median_error(&problem, &covariance) })
}

fn problem(
    points: &[&RadiancePoint],
    cloud: &Coefficients<f64>,
    phase: &impl PhaseLookup<f64>,
) -> Result<Problem, FitError> {
    let mut rows = Matrix::zeros(points.len(), COUNT);
    let (mut wanted, mut weights) = (Vec::new(), Vec::new());
    for (i, point) in points.iter().enumerate() {
        super::DRAWN_TAU.check("tau", point.tau)?;
        let sight = point.sight()?;
        let more = point.radiance.value - Slab::new(cloud, point.tau, sight)?.one(phase);
        let scaled = cloud.similarity * point.tau;
        let target = libm::log(more / envelope(scaled, &sight));
        if !target.is_finite() {
            let RadiancePoint { tau, mu_l, mu_v, phi_deg, side, .. } = point;
            return Err(FitError::Inconsistent(format!(
                "the reference at tau {tau}, mu_l {mu_l}, mu_v {mu_v}, phi {phi_deg}, {side} is not above single scattering"
            )));
        }
        let weight = more / point.radiance.value;
        let (terms, u) = (basis(&sight), saturation(scaled));
        let mut power = weight;
        for j in 0..POWERS {
            for (k, term) in terms.iter().enumerate() {
                rows.set(i, j * TERMS + k, power * term);
            }
            power *= u;
        }
        wanted.push(weight * target);
        weights.push(weight);
    }
    Ok(Problem { rows, wanted, weights })
}

/// F Fᵀ (Σ r_i² a_i a_iᵀ) F Fᵀ with F Fᵀ = (AᵀA)⁻¹.
fn sandwich(problem: &Problem, factor: &Matrix, solution: &[f64]) -> Matrix {
    let fitted = problem.rows.times(solution);
    let rest: Vec<f64> = problem.wanted.iter().zip(&fitted).map(|(wanted, fitted)| wanted - fitted).collect();
    let mut answers = problem.rows.product(factor);
    (0..COUNT).for_each(|k| answers.column_mut(k).iter_mut().zip(&rest).for_each(|(a, rest)| *a *= rest));
    let meat = Matrix::square(COUNT, |i, j| dot(answers.column(i), answers.column(j)));
    let half = factor.product(&meat);
    Matrix::square(COUNT, |i, j| (0..COUNT).fold(0.0, |sum, k| sum + half.get(i, k) * factor.get(j, k)))
}

/// Median over the points of the standard error of ln M.
fn median_error(problem: &Problem, covariance: &Matrix) -> f64 {
    let mut squares = vec![0.0; problem.weights.len()];
    let spread = problem.rows.product(covariance);
    for k in 0..COUNT {
        let pairs = spread.column(k).iter().zip(problem.rows.column(k));
        squares.iter_mut().zip(pairs).for_each(|(sum, (a, b))| *sum += a * b);
    }
    let error = |(square, weight): (&f64, &f64)| square.max(0.0).sqrt() / weight;
    let mut errors: Vec<f64> = squares.iter().zip(&problem.weights).map(error).collect();
    errors.sort_by(f64::total_cmp);
    errors[errors.len() / 2]
}
