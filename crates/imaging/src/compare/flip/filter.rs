//! Planes of numbers and separable filters on them; beyond an edge stands the pixel at the edge.

/// One number per pixel.
pub struct Plane {
    width: usize,
    values: Vec<f64>,
}

impl Plane {
    pub fn new(width: usize, values: Vec<f64>) -> Self {
        Self { width, values }
    }

    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Filtered by `across` along rows and by `down` along columns.
    pub fn filtered(&self, across: &Kernel, down: &Kernel) -> Self {
        self.across(across).down(down)
    }

    fn across(&self, kernel: &Kernel) -> Self {
        let rows = self.values.chunks_exact(self.width);
        let values = rows
            .flat_map(|row| (0..row.len()).map(move |x| kernel.at(x, row.len(), |neighbour| row[neighbour])));
        Self { width: self.width, values: values.collect() }
    }

    fn down(&self, kernel: &Kernel) -> Self {
        let height = self.values.len() / self.width;
        let values = (0..height).flat_map(|y| {
            (0..self.width)
                .map(move |x| kernel.at(y, height, |neighbour| self.values[neighbour * self.width + x]))
        });
        Self { width: self.width, values: values.collect() }
    }
}

/// Weights of 2 r + 1 neighbours.
pub struct Kernel(Vec<f64>);

impl Kernel {
    /// `weight` of the distances -r to r.
    pub fn new(radius: i32, weight: impl Fn(f64) -> f64) -> Self {
        Self((-radius..=radius).map(|i| weight(f64::from(i))).collect())
    }

    /// Divided so that the weights sum to 1.
    pub fn normalised(self) -> Self {
        let sum: f64 = self.0.iter().sum();
        Self(self.0.iter().map(|weight| weight / sum).collect())
    }

    /// Divided so that positive weights sum to 1 and negative ones to -1.
    pub fn balanced(self) -> Self {
        let positive: f64 = self.0.iter().filter(|w| **w > 0.0).sum();
        let negative: f64 = -self.0.iter().filter(|w| **w < 0.0).sum::<f64>();
        let scaled = |w: &f64| if *w > 0.0 { w / positive } else { w / negative };
        Self(self.0.iter().map(scaled).collect())
    }

    pub fn sum(&self) -> f64 {
        self.0.iter().sum()
    }

    fn at(&self, place: usize, length: usize, value: impl Fn(usize) -> f64) -> f64 {
        let radius = self.0.len() / 2;
        let neighbour = |i: usize| (place + i).saturating_sub(radius).min(length - 1);
        self.0.iter().enumerate().map(|(i, weight)| weight * value(neighbour(i))).sum()
    }
}
