//! A phase function given by its Legendre series, tabulated over Θ.
//!
//! In Θ the sum of L terms is a cosine polynomial of degree L; between nodes π/(64 L) apart its cubic Hermite
//! interpolant is off by (π/64)⁴/384, 2e-8 of the largest value. A value costs four terms instead of L.

use std::f64::consts::PI;

/// Nodes per term.
const DENSITY: usize = 64;

/// Error of the interpolation, relative to the largest value.
const INTERPOLATION: f64 = 2e-8;

/// Values and slopes at equal steps in Θ.
#[derive(Clone, Debug)]
pub(super) struct SeriesTable {
    step: f64,
    /// P and step·dP/dΘ.
    nodes: Vec<(f64, f64)>,
    /// Terms up to the last that matters.
    terms: usize,
}

/// Terms (2l+1)|χ_l| below this are no waves.
const FAINT: f64 = 0.1;

impl SeriesTable {
    pub(super) fn new(chi: &[f64]) -> Self {
        let count = DENSITY * chi.len();
        let step = PI / count as f64;
        let node = |k: usize| {
            let (value, slope) = series(chi, step * k as f64);
            (value, step * slope)
        };
        let matters = |(l, chi): (usize, &f64)| (2 * l + 1) as f64 * chi.abs() > FAINT;
        let terms = 1 + chi.iter().enumerate().rposition(matters).unwrap_or(0);
        Self { step, nodes: (0..=count).map(node).collect(), terms }
    }

    /// Wave length of the last term that matters, radians.
    pub(super) fn waves(&self) -> Option<f64> {
        (self.terms > 1).then(|| 2.0 * PI / self.terms as f64)
    }

    /// Error bound of a value.
    pub(super) fn error(&self) -> f64 {
        INTERPOLATION * self.nodes.iter().fold(0.0_f64, |most, (value, _)| most.max(value.abs()))
    }

    /// P at Θ.
    pub(super) fn at(&self, theta: f64) -> f64 {
        let place = (theta / self.step).max(0.0);
        let cell = (place as usize).min(self.nodes.len() - 2);
        let x = place - cell as f64;
        let ((a, slope_a), (b, slope_b)) = (self.nodes[cell], self.nodes[cell + 1]);
        let y = 1.0 - x;
        (1.0 + 2.0 * x) * y * y * a + (1.0 + 2.0 * y) * x * x * b + x * y * (y * slope_a - x * slope_b)
    }
}

/// Σ(2l+1)χ_l P_l(cosΘ) and its derivative in Θ.
fn series(chi: &[f64], theta: f64) -> (f64, f64) {
    let (sine, x) = libm::sincos(theta);
    let (mut before, mut p) = (0.0, 1.0);
    // dP_l/dx by P'_{l+1} = P'_{l-1} + (2l+1)P_l.
    let (mut slope_before, mut slope) = (0.0, 0.0);
    let mut sum = (0.0, 0.0);
    for (l, chi) in chi.iter().enumerate() {
        let (l, odd) = (l as f64, (2 * l + 1) as f64);
        sum.0 += odd * chi * p;
        sum.1 -= odd * chi * slope * sine;
        (slope_before, slope) = (slope, slope_before + odd * p);
        (before, p) = (p, (odd * x * p - l * before) / (l + 1.0));
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Henyey–Greenstein, whose moments are powers of g.
    #[test]
    fn the_table_is_the_function() {
        let g: f64 = 0.8;
        let chi: Vec<f64> = std::iter::successors(Some(1.0), |power| Some(power * g)).take(160).collect();
        let table = SeriesTable::new(&chi);
        let peak = (1.0 + g) / ((1.0 - g) * (1.0 - g));
        for k in 0..=1000 {
            let theta = PI * f64::from(k) / 1000.0;
            let root = (1.0 + g * g - 2.0 * g * libm::cos(theta)).sqrt();
            let expected = (1.0 - g * g) / (root * root * root);
            assert!((table.at(theta) - expected).abs() < 1e-7 * peak, "{theta}");
        }
    }
}
