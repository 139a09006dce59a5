//! The radii of the quadrature: a trapezoid rule in a variable u that crowds them where they matter.
//!
//! Narrow resonances, hit or missed by chance, limit the error; their variance falls fastest, for a given sum of
//! costs ∝ r, if radii are dense where droplets scatter much. du/dr is therefore √(r³n(r)) over its maximum, plus a
//! floor that keeps every part of the range sampled. Between knots r(u) is the cubic Hermite polynomial, whose
//! derivative weights the radii: the rule stays exact for smooth integrands. Halving the step keeps every radius used before.

use crate::droplets::SizeDistribution;
use stratiform_quantities::{DomainError, Range};

/// A radius in µm with its weight n(r) dr/du.
pub(super) type Node = (f64, f64);

/// Share of the largest density of radii that every radius gets at least.
const FLOOR: f64 = 0.02;

/// Knots of r(u), equidistant in ln r.
const KNOTS: usize = 2048;

/// r at u, and dr/du there.
#[derive(Clone, Copy, Debug)]
struct Knot {
    u: f64,
    r: f64,
    slope: f64,
}

/// The rule of `cells` steps: the sum of the weights times f(r) is ⟨f⟩, short of what lies outside
/// [`SizeDistribution::scattering_range`]. A single size has one radius.
///
/// # Errors
/// [`DomainError`] unless `cells` is from 1 to 2^30.
pub fn radius_rule(droplets: &SizeDistribution, cells: usize) -> Result<Vec<(f64, f64)>, DomainError> {
    Range::closed(1.0, 1_073_741_824.0).check("cells of the radius rule", cells as f64)?;
    let radii = Radii { cells, ..Radii::new(droplets) };
    let step = radii.step();
    Ok(radii.first().into_iter().map(|(radius, weight)| (radius, weight * step)).collect())
}

/// The nested radii of one distribution.
pub(super) struct Radii<'a> {
    droplets: &'a SizeDistribution,
    range: [f64; 2],
    knots: Vec<Knot>,
    cells: usize,
}

impl<'a> Radii<'a> {
    /// Fewer radii are not believed, however well they agree.
    pub(super) const FEWEST: u64 = 512;
    const FIRST: usize = 128;

    pub(super) fn new(droplets: &'a SizeDistribution) -> Self {
        let range = droplets.scattering_range();
        Self { droplets, range, knots: knots(droplets, range), cells: Self::FIRST }
    }

    /// The smallest and the largest radius.
    pub(super) fn range(&self) -> [f64; 2] {
        self.range
    }

    pub(super) fn count(&self) -> u64 {
        self.cells as u64
    }

    /// The step in u; 1 for a single size, whose only weight is 1.
    pub(super) fn step(&self) -> f64 {
        if self.droplets.single_radius().is_some() { 1.0 } else { 1.0 / self.cells as f64 }
    }

    /// The coarsest rule's radii.
    pub(super) fn first(&self) -> Vec<Node> {
        if let Some(radius) = self.droplets.single_radius() {
            return vec![(radius, 1.0)];
        }
        let share = |i: usize| if i == 0 || i == self.cells { 0.5 } else { 1.0 };
        (0..=self.cells).map(|i| self.node(i as f64 * self.step(), share(i))).collect()
    }

    /// Halves the step and returns the radii that come in between.
    pub(super) fn halve(&mut self) -> Vec<Node> {
        self.cells *= 2;
        (0..self.cells / 2).map(|i| self.node((2 * i + 1) as f64 * self.step(), 1.0)).collect()
    }

    fn node(&self, u: f64, share: f64) -> Node {
        let right = self.knots.partition_point(|knot| knot.u < u).clamp(1, self.knots.len() - 1);
        let (r, slope) = hermite(self.knots[right - 1], self.knots[right], u);
        (r, share * slope * self.droplets.density(r))
    }
}

/// The cubic through both knots with their slopes, and its derivative.
fn hermite(a: Knot, b: Knot, u: f64) -> (f64, f64) {
    let width = b.u - a.u;
    let t = (u - a.u) / width;
    let (rise, sa, sb) = (b.r - a.r, a.slope * width, b.slope * width);
    let (c2, c3) = (3.0 * rise - 2.0 * sa - sb, sa + sb - 2.0 * rise);
    (a.r + t * (sa + t * (c2 + t * c3)), (sa + t * (2.0 * c2 + 3.0 * t * c3)) / width)
}

fn knots(droplets: &SizeDistribution, [low, high]: [f64; 2]) -> Vec<Knot> {
    let ratio = libm::log(high / low) / KNOTS as f64;
    let radii: Vec<f64> = (0..=KNOTS).map(|i| low * libm::exp(ratio * i as f64)).collect();
    let matter: Vec<f64> = radii.iter().map(|r| (r * r * r * droplets.density(*r)).sqrt()).collect();
    let largest = matter.iter().fold(f64::MIN_POSITIVE, |most, w| w.max(most));
    let density: Vec<f64> = matter.iter().map(|w| w / largest + FLOOR).collect();
    let mut sums = vec![0.0; radii.len()];
    for i in 1..radii.len() {
        sums[i] = sums[i - 1] + 0.5 * (density[i - 1] + density[i]) * (radii[i] - radii[i - 1]);
    }
    let total = sums[KNOTS].max(f64::MIN_POSITIVE);
    let knot = |i: usize| Knot { u: sums[i] / total, r: radii[i], slope: total / density[i] };
    (0..=KNOTS).map(knot).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::droplets::DropletDistribution;

    /// ⟨r^k⟩ of the gamma law in closed form; the range leaves out 1e-6 of ⟨r²⟩ and 1e-5 of ⟨r⁴⟩.
    #[test]
    fn the_rule_integrates_powers_of_the_radius() {
        let law = DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 };
        let droplets = law.resolve().unwrap();
        let rule = radius_rule(&droplets, 1 << 15).unwrap();
        assert_eq!(rule.len(), (1 << 15) + 1);
        for (k, bound) in [(2, 2e-6), (3, 3e-6), (4, 1.1e-5)] {
            let power = |r: f64| (0..k).fold(1.0, |product, _| product * r);
            let mean = rule.iter().fold(0.0, |sum, (r, weight)| sum + weight * power(*r));
            let off = mean / droplets.moment(k) - 1.0;
            assert!(off.abs() < bound, "{k}: {off}");
        }
        assert!(radius_rule(&droplets, 0).is_err());
    }
}
