//! How much every texel of one plane lights a texel of the other: a table over the offset, periodic.
//!
//! E(p) = Σ_q w(q - p) B(q) is every rule's form. A ring rule (Bouthors, Neyret & Lefebvre 2006, section 5.3) is a sum of means over three
//! squares A_i centred on the receiver, E = Σ v_i B(A_i); the weights f of its rings S_1 = A_1, S_i = A_i - A_(i-1) give
//! v_i = f_i/(1 - a_(i-1)/a_i) - f_(i+1)/(a_(i+1)/a_i - 1), a the areas. The paper takes the means from a pyramid of levels whose texels are
//! h; here texels have any size, a texel counts by the share of it that lies in the square, and squares wider than the period wrap. `Exact` is the form
//! factor of the whole texel from the receiver's centre, images of the period summed; `LeastSquares` is its improvement for texels that are means and
//! receivers that are read bilinearly.
//!
//! Σ w = 1 and w(-d) = w(d) for every rule: what one plane gives out is what the other receives.

use super::form_factor::corner;
use super::least_squares::least_squares;
use crate::{Radiosity, RingRule};
use stratiform_quantities::{DomainError, Range};
use stratiform_world::World;

/// A rule on a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Weights {
    rule: RingRule,
    side: usize,
    h: f64,
    values: Vec<f64>,
}

/// Texels a side for which texels are at most h/2, 16 to 128 in powers of two: `LeastSquares` then errs by about 1 % of the mean.
pub fn side_for(extent_m: f64, h_m: f64) -> u32 {
    [16, 32, 64].into_iter().find(|side| extent_m <= 0.5 * h_m * f64::from(*side)).unwrap_or(128)
}

/// Periods on each side of the receiver over which images are summed; what lies further is spread evenly.
const IMAGES: usize = 4;

impl Weights {
    /// Those of a world's planes.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn between(world: &World, radiosity: &Radiosity) -> Result<Self, DomainError> {
        let texel = world.field.map().extent_m() / f64::from(radiosity.side);
        Self::new(radiosity.rings, radiosity.side as usize, texel, world.base_m)
    }

    /// Whether [`between`](Self::between) would give these.
    pub fn fit(&self, world: &World, radiosity: &Radiosity) -> bool {
        let h = world.base_m / (world.field.map().extent_m() / f64::from(radiosity.side));
        (self.rule, self.side, self.h) == (radiosity.rings, radiosity.side as usize, h)
    }

    /// Of a rule for `side` x `side` texels of `texel_m`, planes `h_m` apart.
    ///
    /// # Errors
    /// [`DomainError`] for side outside [1, 128], or a length that is not positive.
    pub fn new(rule: RingRule, side: usize, texel_m: f64, h_m: f64) -> Result<Self, DomainError> {
        Range::closed(1.0, 128.0).check("radiosity.side", side as f64)?;
        Range::above(0.0).check("texel_m", texel_m)?;
        let h = Range::above(0.0).check("base_m", h_m)? / texel_m;
        let values = match rule {
            RingRule::Exact => form_factors(side, h, IMAGES),
            RingRule::LeastSquares => least_squares(side, h),
            RingRule::AsPrinted => squares(side, [h, 2.0 * h, 8.0 * h], [0.5, 0.3, 0.2]),
            RingRule::WiderSquares => squares(side, [2.0 * h, 4.0 * h, 16.0 * h], [0.5, 0.3, 0.2]),
            RingRule::SquareWeights => squares(side, [h, 2.0 * h, 8.0 * h], [0.239, 0.315, 0.446]),
        };
        Ok(Self { rule, side, h, values })
    }

    /// Texels a side.
    pub fn side(&self) -> usize {
        self.side
    }

    /// Weight of the texel `(x, y)` to the east and north, at `y * side + x`.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// What every texel receives from `radiosity`.
    pub fn gather(&self, radiosity: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let n = self.side;
        (0..n * n)
            .map(|p| {
                let (x, y) = (p % n, p / n);
                let mut sum = [0.0; 3];
                for (q, b) in radiosity.iter().enumerate() {
                    let w = self.values[(q / n + n - y) % n * n + (q % n + n - x) % n];
                    sum = std::array::from_fn(|c| sum[c] + w * b[c]);
                }
                sum
            })
            .collect()
    }
}

/// Nested squares of these sides, in texels, whose rings have these form factors.
fn squares(side: usize, widths: [f64; 3], rings: [f64; 3]) -> Vec<f64> {
    let ratio = |i: usize| (widths[i + 1] * widths[i + 1]) / (widths[i] * widths[i]);
    let inner = |i: usize| rings[i + 1] / (ratio(i) - 1.0);
    let outer = |i: usize| rings[i + 1] * ratio(i) / (ratio(i) - 1.0);
    let shares = [rings[0] - inner(0), outer(0) - inner(1), outer(1)];
    let spans = widths.map(|width| span(side, width));
    let at = |i: usize| (0..3).map(|k| shares[k] * (spans[k][i % side] * spans[k][i / side])).sum();
    (0..side * side).map(at).collect()
}

/// Share of a span of `width` texels around the centre of texel 0 that lies in each texel of the period.
fn span(side: usize, width: f64) -> Vec<f64> {
    let n = side as f64;
    let wraps = libm::ceil(0.5 * width / n) as i64 + 1;
    let overlap = |centre: f64| ((centre + 0.5).min(0.5 * width) - (centre - 0.5).max(-0.5 * width)).max(0.0);
    (0..side)
        .map(|k| (-wraps..=wraps).map(|m| overlap(k as f64 + m as f64 * n)).sum::<f64>() / width)
        .collect()
}

/// Texels' form factors from the centre of texel 0, `images` periods each way summed in the order of offsets from the south-west; the rest is
/// shared evenly. The sum is over all offsets of at most images + 1/2 periods, those on its border counted half, so that it is symmetric.
pub(super) fn form_factors(side: usize, h: f64, images: usize) -> Vec<f64> {
    let doubled = (2 * images + 1) * side;
    let reach = doubled / 2;
    let edges: Vec<Vec<f64>> = (0..=reach + 1)
        .map(|j| (0..=reach + 1).map(|i| corner(i as f64 - 0.5, j as f64 - 0.5, h)).collect())
        .collect();
    let border = |n: usize| if 2 * n == doubled { 0.5 } else { 1.0 };
    let factor = |x: usize, y: usize| {
        let whole = (edges[y + 1][x + 1] - edges[y + 1][x]) - (edges[y][x + 1] - edges[y][x]);
        whole * border(x) * border(y)
    };
    let mut values = vec![0.0; side * side];
    let offsets = || (0..=2 * reach).map(|i| (i.abs_diff(reach), (i + side * (images + 1) - reach) % side));
    for (y, row) in offsets() {
        for (x, column) in offsets() {
            values[row * side + column] += factor(x, y);
        }
    }
    let rest = (1.0 - values.iter().sum::<f64>()) / (side * side) as f64;
    values.iter().map(|value| value + rest).collect()
}
