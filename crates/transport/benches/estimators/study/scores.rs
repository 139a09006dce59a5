//! What is estimated: reflectance and transmittance of the orders 0, 1, 2, of all later ones, and of all, per slab.

/// Orders 0, 1, 2 and the rest.
const BINS: usize = 4;

/// Names of the rows of each slab.
pub const NAMES: [&str; 9] = ["R1", "R2", "R3+", "R", "T0", "T1", "T2", "T3+", "T"];

/// Sums of one replicate at one incidence.
pub struct Scores {
    reflected: Vec<[f64; BINS]>,
    transmitted: Vec<[f64; BINS]>,
    /// Of all histories, so that time per flight can be told from work per photon.
    pub flights: u64,
}

impl Scores {
    pub fn new(slabs: usize) -> Self {
        Self { reflected: vec![[0.0; BINS]; slabs], transmitted: vec![[0.0; BINS]; slabs], flights: 0 }
    }

    #[inline(always)]
    pub fn reflect(&mut self, slab: usize, order: usize, share: f64) {
        self.reflected[slab][order.min(BINS - 1)] += share;
    }

    #[inline(always)]
    pub fn transmit(&mut self, slab: usize, order: usize, share: f64) {
        self.transmitted[slab][order.min(BINS - 1)] += share;
    }

    /// Each slab's own sums, where what a slab reflects was added once for it and all thicker ones.
    pub fn nested(mut self) -> Self {
        for slab in 1..self.reflected.len() {
            for bin in 0..BINS {
                self.reflected[slab][bin] += self.reflected[slab - 1][bin];
            }
        }
        self
    }

    /// [`NAMES`] of each slab, per photon.
    pub fn means(&self, photons: u64) -> Vec<f64> {
        let rows = self.reflected.iter().zip(&self.transmitted).flat_map(|(r, t)| {
            let total = |row: &[f64; BINS]| row.iter().sum::<f64>();
            [r[1], r[2], r[3], total(r), t[0], t[1], t[2], t[3], total(t)]
        });
        rows.map(|sum| sum / photons as f64).collect()
    }
}
