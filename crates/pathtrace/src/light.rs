//! What one path brings, told apart by contribution.

use stratiform_world::Contribution;

/// Linear sRGB of each contribution.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Light(pub(crate) [[f64; 3]; Contribution::ALL.len()]);

impl Light {
    /// Adds `radiance`.
    pub(crate) fn add(&mut self, contribution: Contribution, radiance: [f64; 3]) {
        let part = &mut self.0[contribution.index()];
        *part = std::array::from_fn(|c| part[c] + radiance[c]);
    }

    /// All contributions together.
    pub(crate) fn total(&self) -> [f64; 3] {
        self.0.iter().fold([0.0; 3], |sum, part| std::array::from_fn(|c| sum[c] + part[c]))
    }
}

/// Mean of three.
pub(crate) fn mean([a, b, c]: [f64; 3]) -> f64 {
    (a + b + c) * (1.0 / 3.0)
}
