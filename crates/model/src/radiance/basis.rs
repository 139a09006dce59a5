//! The functions of direction and of thickness that the exponent is made of.

use crate::Real;
use crate::angular::Sight;

/// Functions of direction.
pub const TERMS: usize = 16;

/// B_k = s^a p^b c^e: (a, b, e) of each k. All up to degree 2, and those of degree 3 and 4 that matter most.
pub const EXPONENTS: [[u32; 3]; TERMS] = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [2, 0, 0],
    [1, 1, 0],
    [0, 2, 0],
    [1, 0, 1],
    [0, 1, 1],
    [0, 0, 2],
    [0, 0, 3],
    [0, 0, 4],
    [3, 0, 0],
    [2, 0, 1],
    [1, 0, 2],
    [0, 1, 2],
];

/// Every B_k.
#[inline]
pub fn basis<F: Real>(sight: &Sight<F>) -> [F; TERMS] {
    let one = F::of(1.0);
    let (s, p, c) = (sight.mu_l + sight.mu_v, sight.mu_l * sight.mu_v, one - sight.v);
    let (ss, sc, cc) = (s * s, s * c, c * c);
    [one, s, p, c, ss, s * p, p * p, sc, p * c, cc, cc * c, cc * cc, ss * s, ss * c, sc * c, p * cc]
}

/// u = τ'/(1 + τ') in \[0, 1\], of τ' = (1-g)τ.
#[inline]
pub fn saturation<F: Real>(scaled: F) -> F {
    scaled / (F::of(1.0) + scaled)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_quantities::Side;

    #[test]
    fn the_terms_are_the_listed_monomials() {
        let sight = Sight::new(0.3, 0.7, 40.0, Side::Top).unwrap();
        let variables = [1.0, 0.21, 1.0 - sight.v];
        for (exponents, value) in EXPONENTS.iter().zip(basis(&sight)) {
            let expected = exponents
                .iter()
                .zip(variables)
                .fold(1.0, |product, (exponent, x)| (0..*exponent).fold(product, |power, _| power * x));
            assert!((value - expected).abs() < 1e-14);
        }
    }
}
