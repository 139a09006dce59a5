//! Light that met only forward events, by its number of events (Bouthors, Neyret & Lefebvre 2006, section 4.2, corrected).
//!
//! After a path of optical thickness q light has met n events of P_F with probability e^-q y^n/n!, y = P_f q. Angles add up on
//! the sphere as moments multiply (Goudsmit & Saunderson 1940), so that two or more events have the distribution
//!
//! ```text
//! several(Θ, q) = Σ_l (2l+1) (e^{yχ_l} - 1 - yχ_l)/(e^y - 1 - y) P_l(cosΘ)        mean 1 over the sphere
//! ```
//!
//! One event is P_F itself, with its edge at θ_f; from two on the sum converges and is smooth. The error of the number of
//! moments is below 1e-4 of the peak. [`HaloTable`] holds it for lookups, bilinear in s = sin(Θ/2) = √(v/2) and in q.

use super::{PhaseTable, angle, legendre};
use crate::OpticsError;
use stratiform_quantities::Range;

/// Forward events of one medium.
#[derive(Clone, Debug)]
pub struct Halo {
    forward_fraction: f64,
    /// Moments of P_F.
    chi: Vec<f64>,
}

impl Halo {
    /// P_F and P_f of `phase`.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] unless 0 < θ_f < 180°; [`OpticsError::NotNormalised`] if nothing is scattered below it.
    pub fn new(phase: &PhaseTable, theta_f_deg: f64) -> Result<Self, OpticsError> {
        let forward = phase.forward_part(theta_f_deg)?;
        let forward_fraction = phase.forward_fraction(theta_f_deg)?;
        Ok(Self { forward_fraction, chi: forward.moments_to_square() })
    }

    /// P_f.
    pub fn forward_fraction(&self) -> f64 {
        self.forward_fraction
    }

    /// Moments of the distribution of light that met two or more events, each forward.
    pub fn moments(&self, q: f64) -> Vec<f64> {
        let y = self.forward_fraction * q;
        let whole = beyond_one(y, 1.0);
        self.chi.iter().map(|chi| if whole > 0.0 { beyond_one(y, *chi) / whole } else { chi * chi }).collect()
    }

    /// That distribution at each angle, radians.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] unless q ≥ 0.
    pub fn several(&self, q: f64, theta: &[f64]) -> Result<Vec<f64>, OpticsError> {
        Range::at_least(0.0).check("q", q)?;
        let sums = legendre::sum(&self.moments(q), theta);
        Ok(sums.into_iter().map(|value| value.max(0.0)).collect())
    }
}

/// e^{-y}(e^{yχ} - 1 - yχ), without cancellation.
fn beyond_one(y: f64, chi: f64) -> f64 {
    let a = y * chi;
    if a.abs() < 1.0 {
        let tail = (1..=17).rev().fold(1.0, |sum, k| 1.0 + a / (f64::from(k) + 2.0) * sum);
        return 0.5 * a * a * tail * libm::exp(-y);
    }
    libm::exp(a - y) - (1.0 + a) * libm::exp(-y)
}

/// The distribution over s = sin(Θ/2) and q, evenly spaced: 0 beyond the last s, the last row's shape beyond the last q.
#[derive(Clone, Debug, PartialEq)]
pub struct HaloTable {
    /// Number of s.
    angles: usize,
    /// Last s.
    reach: f64,
    /// Last q.
    longest: f64,
    /// Row by row of q.
    values: Vec<f64>,
}

impl HaloTable {
    /// `angles` values of s for each of `paths` values of q from 0 to `longest`.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] unless there are 2 of each, θ_reach is in (0, 180]° and `longest` > 0.
    pub fn new(
        halo: &Halo,
        (angles, reach_deg): (usize, f64),
        (paths, longest): (usize, f64),
    ) -> Result<Self, OpticsError> {
        let several = Range::at_least(2.0);
        several.check("angles", angles as f64)?;
        several.check("paths", paths as f64)?;
        let domain = Range { min_included: false, ..Range::closed(0.0, 180.0) };
        let reach = libm::sin(0.5 * domain.check("reach_deg", reach_deg)?.to_radians());
        Range::above(0.0).check("longest", longest)?;
        let theta: Vec<f64> = (0..angles)
            .map(|i| {
                let s = reach * i as f64 / (angles - 1) as f64;
                angle(2.0 * s * s)
            })
            .collect();
        let row = |k: usize| halo.several(longest * k as f64 / (paths - 1) as f64, &theta);
        let rows = (0..paths).map(row).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { angles, reach, longest, values: rows.concat() })
    }

    /// A table for all that is seen: below 1e-6 of the light is left at q = 24 in clouds (P_f about one half), and less than 1e-3 of
    /// it is beyond 45°.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of_cloud(halo: &Halo) -> Result<Self, OpticsError> {
        Self::new(halo, (256, 45.0), (25, 24.0))
    }

    /// Number of s and of q.
    pub fn size(&self) -> (usize, usize) {
        (self.angles, self.values.len() / self.angles)
    }

    /// sin(Θ/2) of the last column.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// q of the last row.
    pub fn longest(&self) -> f64 {
        self.longest
    }

    /// Row by row of q.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The distribution at v = 1 - cosΘ after a path q, for v ∈ \[0, 2\] and q ≥ 0.
    pub fn value(&self, v: f64, q: f64) -> f64 {
        let (angles, paths) = self.size();
        let (i, across) = place((0.5 * v).sqrt() / self.reach, angles);
        if i + across >= (angles - 1) as f64 {
            return 0.0;
        }
        let (k, along) = place((q / self.longest).min(1.0), paths);
        let at = |k: usize| {
            let row = &self.values[k * angles..][i as usize..];
            row[0] + across * (row[1] - row[0])
        };
        let (near, far) = (at(k as usize), at((k as usize + 1).min(paths - 1)));
        near + along * (far - near)
    }
}

/// Cell and place in it of `x` ∈ \[0, 1\] on `count` nodes.
fn place(x: f64, count: usize) -> (f64, f64) {
    let x = x * (count - 1) as f64;
    (x.floor(), x - x.floor())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::{HenyeyGreenstein, Norm, PhaseFunction, versine};
    use stratiform_quantities::Asymmetry;

    fn peaked() -> PhaseTable {
        let hg = HenyeyGreenstein::new(Asymmetry::new(0.98).unwrap());
        let theta: Vec<f64> = (0..=1800).map(|i| 180.0 * libm::pow(f64::from(i) / 1800.0, 2.0)).collect();
        let p = theta.iter().map(|t| hg.value(versine(t.to_radians()))).collect();
        PhaseTable::new(theta, p, Norm::Any).unwrap()
    }

    /// ½∫ f sinΘ dΘ by the trapezoid rule on s: sinΘ dΘ = 4 s ds.
    fn mean(f: impl Fn(f64) -> f64) -> f64 {
        let cells = 40_000;
        (0..cells).fold(0.0, |sum, i| {
            let s = (f64::from(i) + 0.5) / f64::from(cells);
            sum + 2.0 * s * f(2.0 * s * s) / f64::from(cells)
        })
    }

    #[test]
    fn the_table_holds_the_whole_light_and_its_spread() {
        let halo = Halo::new(&peaked(), 5.0).unwrap();
        let table = HaloTable::of_cloud(&halo).unwrap();
        for q in [0.0, 0.3, 2.0, 7.5, 24.0] {
            let whole = mean(|v| table.value(v, q));
            assert!((whole - 1.0).abs() < 2e-3, "q {q}: {whole}");
            // Mean of cosΘ: χ_1 of the distribution.
            let cosine = mean(|v| (1.0 - v) * table.value(v, q));
            let exact = halo.moments(q)[1];
            assert!((whole - cosine - (1.0 - exact)).abs() < 0.02 * (1.0 - exact) + 2e-4, "q {q}");
        }
    }

    /// Two events by direct convolution over the sphere: P_F*P_F(Θ) = (1/4π)∫P_F(Θ')P_F(Θ'') dΩ'.
    #[test]
    fn thin_slabs_have_the_convolution_of_the_peak_with_itself() {
        let phase = peaked();
        let (halo, forward) = (Halo::new(&phase, 5.0).unwrap(), phase.forward_part(5.0).unwrap());
        for theta in [0.0_f64, 0.02, 0.06, 0.12] {
            let (steps, turns) = (1500, 360);
            let edge = 5_f64.to_radians();
            let mut sum = 0.0;
            for i in 0..steps {
                let first = edge * (f64::from(i) + 0.5) / f64::from(steps);
                let ring = (0..turns).fold(0.0, |ring, k| {
                    let psi = std::f64::consts::PI * (f64::from(k) + 0.5) / f64::from(turns);
                    let across = versine(first - theta);
                    let half = libm::sin(0.5 * psi);
                    let v = across + 2.0 * libm::sin(first) * libm::sin(theta) * half * half;
                    ring + if angle(v) < edge { forward.value(v) } else { 0.0 }
                });
                sum += 0.5 * libm::sin(first) * forward.at(first) * ring / f64::from(turns);
            }
            let direct = sum * edge / f64::from(steps);
            let found = halo.several(0.0, &[theta]).unwrap()[0];
            assert!((found - direct).abs() < 3e-3 * direct + 1e-2, "{theta}: {found} {direct}");
        }
    }

    #[test]
    fn moments_are_those_of_the_poisson_sum() {
        let halo = Halo::new(&peaked(), 5.0).unwrap();
        for q in [1e-6, 0.4, 3.0, 50.0] {
            let (y, chi) = (halo.forward_fraction() * q, halo.chi[40]);
            let (mut term, mut events, mut scattered) = (libm::exp(-y), 0.0, 0.0);
            for n in 1..400 {
                term *= y / f64::from(n);
                if n >= 2 {
                    events += term;
                    scattered += term * libm::pow(chi, f64::from(n));
                }
            }
            let found = halo.moments(q)[40];
            assert!((found / (scattered / events) - 1.0).abs() < 1e-12, "{q}");
        }
    }

    #[test]
    fn sizes_and_paths_out_of_domain_are_refused() {
        let halo = Halo::new(&peaked(), 5.0).unwrap();
        assert!(HaloTable::new(&halo, (1, 45.0), (2, 1.0)).is_err());
        assert!(HaloTable::new(&halo, (2, 181.0), (2, 1.0)).is_err());
        assert!(HaloTable::new(&halo, (2, 45.0), (2, f64::NAN)).is_err());
        assert!(halo.several(-1.0, &[0.0]).is_err());
        assert!(Halo::new(&peaked(), 0.0).is_err());
    }
}
