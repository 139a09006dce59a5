//! Means over the texels of an exchange.

/// How a period is cut: texels, and points in them that a mean is taken over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texels {
    /// Texels a side.
    pub side: usize,
    /// Points a side in a texel.
    pub samples: usize,
    /// Period, m.
    pub extent_m: f64,
}

impl Texels {
    /// As many points as bring at least one to every texel of a map with `map_side` texels over the same period: its own texels where
    /// `map_side` is a multiple of `side`.
    pub fn over(side: usize, map_side: usize, extent_m: f64) -> Self {
        Self { side, samples: map_side.div_ceil(side), extent_m }
    }

    /// Mean of `value(x, y)` over every texel, row by row from the south.
    ///
    /// # Errors
    /// That of `value`.
    pub fn means<const N: usize, E>(
        &self,
        value: impl Fn(f64, f64) -> Result<[f64; N], E>,
    ) -> Result<Vec<[f64; N]>, E> {
        (0..self.side * self.side).map(|texel| self.mean(texel, &value)).collect()
    }

    fn mean<const N: usize, E>(
        &self,
        texel: usize,
        value: &impl Fn(f64, f64) -> Result<[f64; N], E>,
    ) -> Result<[f64; N], E> {
        let n = self.samples;
        let step = self.extent_m / (self.side * n) as f64;
        let at = |texel: usize, i: usize| ((texel * n + i) as f64 + 0.5) * step;
        let mut sum = [0.0; N];
        for i in 0..n * n {
            let here = value(at(texel % self.side, i % n), at(texel / self.side, i / n))?;
            sum = std::array::from_fn(|c| sum[c] + here[c]);
        }
        Ok(sum.map(|total| total / (n * n) as f64))
    }
}
