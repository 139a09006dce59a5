//! Q_ext, Q_sca and g from the coefficients (Bohren & Huffman 1983, eqs. 4.61, 4.62 and section 4.5).

use super::{Coefficients, SizeParameter};

/// Cross-sections over πr², and the asymmetry parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Efficiencies {
    /// Extinction.
    pub q_ext: f64,
    /// Scattering.
    pub q_sca: f64,
    /// g, the mean of cosΘ.
    pub g: f64,
}

/// Q_ext = 2/x² Σ(2n+1)Re(a_n + b_n), Q_sca = 2/x² Σ(2n+1)(|a_n|² + |b_n|²), and gQ_sca = 4/x² Σ of the products
/// of neighbouring orders.
pub fn efficiencies(x: SizeParameter, coefficients: &Coefficients) -> Efficiencies {
    let (a, b) = (&coefficients.a, &coefficients.b);
    let (mut extinction, mut scattering, mut asymmetry) = (0.0, 0.0, 0.0);
    // The small terms first.
    for i in (0..a.len()).rev() {
        let n = (i + 1) as f64;
        extinction += (2.0 * n + 1.0) * (a[i].re + b[i].re);
        scattering += (2.0 * n + 1.0) * (a[i].norm_sqr() + b[i].norm_sqr());
        asymmetry += (2.0 * n + 1.0) / (n * (n + 1.0)) * (a[i] * b[i].conj()).re;
        if i + 1 < a.len() {
            let neighbours = (a[i] * a[i + 1].conj() + b[i] * b[i + 1].conj()).re;
            asymmetry += n * (n + 2.0) / (n + 1.0) * neighbours;
        }
    }
    let per_area = 2.0 / (x.get() * x.get());
    Efficiencies {
        q_ext: per_area * extinction,
        q_sca: per_area * scattering,
        g: 2.0 * asymmetry / scattering,
    }
}
