//! A square map that repeats itself.

use crate::WorldError;

/// `side` x `side` values over `extent_m` metres each way, periodic. Value `y * side + x` is that at the texel's centre,
/// ((x + 1/2) extent/side, (y + 1/2) extent/side); between centres it is bilinear.
#[derive(Clone, Debug, PartialEq)]
pub struct Map<T> {
    side: usize,
    extent_m: f64,
    values: Vec<T>,
}

/// Four neighbours and where a point lies between them.
pub(crate) struct Cell {
    /// South-west, south-east, north-west, north-east.
    pub corners: [usize; 4],
    /// East and north shares.
    pub at: (f64, f64),
}

impl<T: Copy> Map<T> {
    /// Of `values`, row by row from the south.
    ///
    /// # Errors
    /// [`WorldError::Texels`] for a wrong number, [`WorldError::Domain`] for an extent that is not positive.
    pub fn new(side: usize, extent_m: f64, values: Vec<T>) -> Result<Self, WorldError> {
        if side == 0 || side.checked_mul(side) != Some(values.len()) {
            return Err(WorldError::Texels { side, found: values.len() });
        }
        stratiform_quantities::Range::open(0.0, f64::INFINITY).check("extent_m", extent_m)?;
        Ok(Self { side, extent_m, values })
    }

    /// Texels a side.
    pub fn side(&self) -> usize {
        self.side
    }

    /// Period, m.
    pub fn extent_m(&self) -> f64 {
        self.extent_m
    }

    /// Row by row from the south.
    pub fn values(&self) -> &[T] {
        &self.values
    }

    pub(crate) fn cell(&self, x: f64, y: f64) -> Cell {
        let (west, east, u) = self.between(x);
        let (south, north, v) = self.between(y);
        let n = self.side;
        Cell { corners: [south * n + west, south * n + east, north * n + west, north * n + east], at: (u, v) }
    }

    /// The texels on both sides of a coordinate, and its share of the way.
    fn between(&self, x: f64) -> (usize, usize, f64) {
        let scaled = x / self.extent_m * self.side as f64 - 0.5;
        let below = libm::floor(scaled);
        let side = self.side as f64;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "brought into 0..side")]
        let left = ((below - libm::floor(below / side) * side) as usize).min(self.side - 1);
        (left, (left + 1) % self.side, scaled - below)
    }
}

impl Map<f64> {
    /// The value at a point.
    pub fn value(&self, x: f64, y: f64) -> f64 {
        let Cell { corners, at } = self.cell(x, y);
        bilinear(corners.map(|i| self.values[i]), at)
    }
}

impl Map<[f64; 3]> {
    /// The value at a point.
    pub fn value(&self, x: f64, y: f64) -> [f64; 3] {
        let Cell { corners, at } = self.cell(x, y);
        std::array::from_fn(|c| bilinear(corners.map(|i| self.values[i][c]), at))
    }
}

fn bilinear([sw, se, nw, ne]: [f64; 4], (u, v): (f64, f64)) -> f64 {
    let south = sw + (se - sw) * u;
    let north = nw + (ne - nw) * u;
    south + (north - south) * v
}
