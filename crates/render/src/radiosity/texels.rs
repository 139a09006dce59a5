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

    /// Means of a map whose texels are the points, `value(i)` its texel i; `None` where they are not.
    pub fn blocks<const N: usize>(
        &self,
        map_side: usize,
        value: impl Fn(usize) -> [f64; N],
    ) -> Option<Vec<[f64; N]>> {
        let (side, n) = (self.side, self.samples);
        if map_side != side * n {
            return None;
        }
        let mean = |texel: usize| {
            let corner = texel / side * n * map_side + texel % side * n;
            let mut sum = [0.0; N];
            for i in 0..n * n {
                let here = value(corner + i / n * map_side + i % n);
                sum = std::array::from_fn(|c| sum[c] + here[c]);
            }
            sum.map(|total| total / (n * n) as f64)
        };
        Some((0..side * side).map(mean).collect())
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

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_world::Map;

    #[test]
    fn blocks_are_the_means_of_the_bilinear_map() {
        let map = Map::new(12, 30.0, (0..144).map(|i| f64::from(i * i % 17)).collect()).unwrap();
        let texels = Texels::over(4, 12, 30.0);
        let blocks = texels.blocks(12, |i| [map.values()[i]]).unwrap();
        let means = texels.means(|x, y| Ok::<_, ()>([map.value(x, y)])).unwrap();
        assert!(blocks.iter().zip(&means).all(|(a, b)| (a[0] - b[0]).abs() < 1e-12));
        assert!(Texels::over(5, 12, 30.0).blocks(12, |_| [0.0]).is_none());
    }
}
