//! Q_ext, Q_sca and g of every lane: the sums of [`efficiencies`](crate::mie::efficiencies()), in their order.

use super::{LANES, LaneCoefficients, Lanes, ZERO};
use crate::mie::Efficiencies;

impl LaneCoefficients {
    /// The efficiencies of every lane.
    pub fn efficiencies(&self) -> [Efficiencies; LANES] {
        let [extinction, scattering, asymmetry] = sums(&self.orders).map(|sum| sum.0);
        std::array::from_fn(|l| {
            let per_area = 2.0 / (self.x[l] * self.x[l]);
            Efficiencies {
                q_ext: per_area * extinction[l],
                q_sca: per_area * scattering[l],
                g: 2.0 * asymmetry[l] / scattering[l],
            }
        })
    }
}

/// The small terms first. A lane's orders after its last are zero and add nothing.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn sums(orders: &[[Lanes; 4]]) -> [Lanes; 3] {
    let [mut extinction, mut scattering, mut asymmetry] = [[0.0; LANES]; 3];
    let mut after = &[ZERO; 4];
    for (i, parts) in orders.iter().enumerate().rev() {
        let n = (i + 1) as f64;
        let (odd, share, step) =
            (2.0 * n + 1.0, (2.0 * n + 1.0) / (n * (n + 1.0)), n * (n + 2.0) / (n + 1.0));
        let [a_re, a_im, b_re, b_im] = parts.each_ref().map(|part| &part.0);
        let [a_re_after, a_im_after, b_re_after, b_im_after] = after.each_ref().map(|part| &part.0);
        for l in 0..LANES {
            extinction[l] += odd * (a_re[l] + b_re[l]);
            scattering[l] +=
                odd * ((a_re[l] * a_re[l] + a_im[l] * a_im[l]) + (b_re[l] * b_re[l] + b_im[l] * b_im[l]));
            asymmetry[l] += share * (a_re[l] * b_re[l] + a_im[l] * b_im[l]);
            let of_a = a_re[l] * a_re_after[l] + a_im[l] * a_im_after[l];
            let of_b = b_re[l] * b_re_after[l] + b_im[l] * b_im_after[l];
            asymmetry[l] += step * (of_a + of_b);
        }
        after = parts;
    }
    [extinction, scattering, asymmetry].map(Lanes)
}
