//! The Levenberg–Marquardt parameter: least |A·s + b| with |s| ≤ Δ, to 10 % of Δ.
//!
//! Moré 1978, section 5: Newton's method on 1/Δ - 1/|s(α)|, with s(α) from QR of R stacked on √α·1,
//! safeguarded by an interval that always holds the root. A is already scaled, so that the region is a
//! sphere.

use crate::matrix::norm;
use crate::{Matrix, qr::PivotedQr};

/// A step and the damping that produced it (0: the full step).
pub(super) struct DampedStep {
    pub step: Vec<f64>,
    pub damping: f64,
}

const RELATIVE_SLACK: f64 = 0.1;
const MOST_CORRECTIONS: usize = 12;

/// `minus_b` is -Qᵀb of A = QR. An infinite `radius` gives the full step.
pub(super) fn damped_step(qr: &PivotedQr, minus_b: &[f64], radius: f64) -> DampedStep {
    let full = qr.solve(minus_b);
    let length = norm(&full);
    if length <= (1.0 + RELATIVE_SLACK) * radius {
        return DampedStep { step: full, damping: 0.0 };
    }
    let triangle = qr.triangle();
    let gradient = norm(&triangle.transposed_times(minus_b));
    let mut low = if qr.has_full_rank() { newton(qr, &full, length, radius) } else { 0.0 };
    let mut high = gradient / radius;
    let mut damping = low.max(1e-3 * high);
    let mut best = DampedStep { step: full, damping };
    for _ in 0..MOST_CORRECTIONS {
        let damped = PivotedQr::new(stacked(&triangle, damping));
        let mut right = minus_b.to_vec();
        right.resize(2 * minus_b.len(), 0.0);
        best = DampedStep { step: damped.solve(&damped.project(&right)), damping };
        let length = norm(&best.step);
        if (length - radius).abs() <= RELATIVE_SLACK * radius || !length.is_finite() {
            break;
        }
        if length > radius {
            low = low.max(damping);
        } else {
            high = high.min(damping);
        }
        let next = damping + newton(&damped, &best.step, length, radius);
        damping =
            if next > low && next < high { next } else { low.max(1e-3 * high).max((low * high).sqrt()) };
    }
    best
}

/// Newton's increment of α, from |s|, Δ and the factor S of AᵀA + α: (|s| - Δ)/Δ / |S⁻ᵀ s/|s||².
fn newton(qr: &PivotedQr, step: &[f64], length: f64, radius: f64) -> f64 {
    let direction: Vec<f64> = step.iter().map(|s| s / length).collect();
    let slope = norm(&qr.solve_transposed(&direction));
    (length - radius) / radius / (slope * slope)
}

fn stacked(triangle: &Matrix, damping: f64) -> Matrix {
    let n = triangle.columns();
    let mut out = Matrix::zeros(2 * n, n);
    for j in 0..n {
        out.column_mut(j)[..n].copy_from_slice(triangle.column(j));
        out.set(n + j, j, damping.sqrt());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// |s(α)| for a diagonal A is known in closed form.
    #[test]
    fn the_step_has_the_radius_asked_for() {
        let a = Matrix::square(3, |i, j| if i == j { [1.0, 1e-3, 1e3][i] } else { 0.0 });
        let qr = PivotedQr::new(a);
        let minus_b = qr.project(&[1.0, 1.0, 1.0]);
        for radius in [1e-6, 1e-3, 0.1, 1.0, 10.0, 500.0] {
            let DampedStep { step, damping } = damped_step(&qr, &minus_b, radius);
            assert!((norm(&step) / radius - 1.0).abs() <= RELATIVE_SLACK, "{radius}: {}", norm(&step));
            for (s, d) in step.iter().zip([1.0, 1e-3, 1e3]) {
                assert!((s - d / (d * d + damping)).abs() < 1e-12 * norm(&step));
            }
        }
        assert_eq!(damped_step(&qr, &minus_b, f64::INFINITY).damping, 0.0);
    }
}
