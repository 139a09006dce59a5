//! The halo of several forward events in a table, in either precision.

use crate::scalar::{Scalar, least};
use crate::{Cloud, MethodError};
use stratiform_model::angular::halo::{HaloLookup, Peak};
use stratiform_optics::phase::{Halo, HaloTable, versine};

/// `HaloTable` as a texture: bilinear in s = sin(Θ/2) and q, 0 beyond the last s, the last row beyond the last q.
#[derive(Clone, Debug)]
pub(crate) struct HaloTexels<F> {
    values: Vec<F>,
    angles: usize,
    paths: usize,
    /// 1 over the last s.
    per_reach: F,
    /// 1 over the last q.
    per_longest: F,
}

impl<F: Scalar> HaloTexels<F> {
    pub(crate) fn new(cloud: &Cloud) -> Result<Self, MethodError> {
        let table = HaloTable::of_cloud(&Halo::new(cloud.phase(), cloud.theta_f_deg())?)?;
        let (angles, paths) = table.size();
        let values = table.values().iter().map(|value| F::of(*value)).collect();
        let (per_reach, per_longest) = (F::of(1.0 / table.reach()), F::of(1.0 / table.longest()));
        Ok(Self { values, angles, paths, per_reach, per_longest })
    }

    pub(crate) fn bytes() -> usize {
        4 * 256 * 25
    }
}

/// P_F and the halo of `cloud`.
pub(crate) fn of_cloud<F: Scalar>(cloud: &Cloud) -> Result<(Peak<F>, HaloTexels<F>), MethodError> {
    let edge = F::of(versine(cloud.theta_f_deg().to_radians()));
    let peak = Peak { forward_fraction: F::of(cloud.forward_fraction()), edge };
    Ok((peak, HaloTexels::new(cloud)?))
}

/// Cell and place in it of `x` ∈ \[0, 1\] on `count` nodes.
fn place<F: Scalar>(x: F, count: usize) -> (usize, F) {
    let x = x * F::of((count - 1) as f64);
    let cell = (x.to_f64() as usize).min(count - 2);
    (cell, x - F::of(cell as f64))
}

impl<F: Scalar> HaloLookup<F> for HaloTexels<F> {
    fn several(&self, v: F, q: F) -> F {
        let s = (F::of(0.5) * v).sqrt() * self.per_reach;
        if s >= F::of(1.0) {
            return F::of(0.0);
        }
        let (column, across) = place(s, self.angles);
        let (row, along) = place(least(q * self.per_longest, F::of(1.0)), self.paths);
        let at = |row: usize| {
            let near = self.values[row * self.angles + column];
            near + across * (self.values[row * self.angles + column + 1] - near)
        };
        at(row) + along * (at(row + 1) - at(row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_optics::phase::{HenyeyGreenstein, Norm, PhaseFunction, PhaseTable};
    use stratiform_quantities::{Asymmetry, SingleScatteringAlbedo};

    #[test]
    fn texels_are_read_as_the_table_is() {
        let hg = HenyeyGreenstein::new(Asymmetry::new(0.98).unwrap());
        let theta: Vec<f64> = (0..=900).map(|i| 180.0 * libm::pow(f64::from(i) / 900.0, 2.0)).collect();
        let p = theta.iter().map(|t| hg.value(versine(t.to_radians()))).collect();
        let phase = PhaseTable::new(theta, p, Norm::Any).unwrap();
        let table = HaloTable::of_cloud(&Halo::new(&phase, 5.0).unwrap()).unwrap();
        let cloud = Cloud::new(phase, SingleScatteringAlbedo::CONSERVATIVE, 5.0, None).unwrap();
        let (double, single) =
            (HaloTexels::<f64>::new(&cloud).unwrap(), HaloTexels::<f32>::new(&cloud).unwrap());
        assert_eq!(HaloTexels::<f32>::bytes(), 4 * table.values().len());
        for v in [0.0, 1e-4, 3e-3, 0.02, 0.5, 2.0] {
            for q in [0.0, 0.3, 7.7, 24.0, 100.0] {
                let expected = table.value(v, q);
                assert!((double.several(v, q) - expected).abs() <= 1e-12 * expected, "{v} {q}");
                let off = f64::from(single.several(v as f32, q as f32)) - expected;
                assert!(off.abs() <= 1e-4 * expected + 1e-4, "{v} {q} {off}");
            }
        }
    }
}
