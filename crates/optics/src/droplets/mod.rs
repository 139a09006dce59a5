//! Droplet size distributions.
//!
//! [`DropletDistribution`] is what a config says; [`SizeDistribution`] is the checked law: n(r) in 1/µm with
//! ∫n dr = 1, its moments ⟨r^k⟩, the effective radius r_e = ⟨r³⟩/⟨r²⟩ and variance
//! v_e = ⟨r⁴⟩⟨r²⟩/⟨r³⟩² - 1 (Hansen & Travis 1974, eqs. 2.53, 2.54), and the radii between which it scatters.

mod gamma;
mod lognormal;
mod tabulated;

use crate::OpticsError;
use gamma::GeneralisedGamma;
use lognormal::Lognormal;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use stratiform_quantities::Range;
use tabulated::Tabulated;

/// Radii and their averages that a config may ask for, µm.
pub(crate) const RADIUS_UM: Range = Range::closed(1e-3, 1e4);

/// A droplet distribution as configs write it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "distribution", rename_all = "kebab-case", deny_unknown_fields)]
pub enum DropletDistribution {
    /// N(r) ∝ (r/r_n)^{γ-1} e^{-r/r_n} with r_e = (γ+2)r_n (Bouthors, Neyret & Lefebvre 2006, section 3.1).
    ModifiedGamma {
        /// γ.
        gamma: f64,
        /// r_e, µm.
        effective_radius_um: f64,
    },
    /// N(r) ∝ r^α e^{-b r^c}, r in µm (Deirmendjian 1969).
    GeneralisedGamma {
        /// α.
        alpha: f64,
        /// b.
        b: f64,
        /// c.
        c: f64,
    },
    /// ln r is normal: give one of the two radii and one of the two widths.
    Lognormal {
        /// r_e, µm.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        effective_radius_um: Option<f64>,
        /// Median radius, µm.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        median_radius_um: Option<f64>,
        /// Standard deviation of ln r.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        sigma: Option<f64>,
        /// v_e = e^{σ²} - 1.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        effective_variance: Option<f64>,
    },
    /// Every droplet has this radius.
    SingleSize {
        /// r, µm.
        radius_um: f64,
    },
    /// N(r) piecewise linear between the rows `radius_um,number` of a CSV file, zero outside, in any unit.
    Tabulated {
        /// The file.
        file: PathBuf,
    },
}

/// A checked distribution.
#[derive(Clone, Debug, PartialEq)]
pub struct SizeDistribution {
    law: Law,
    words: String,
}

#[derive(Clone, Debug, PartialEq)]
enum Law {
    Gamma(GeneralisedGamma),
    Lognormal(Lognormal),
    Single(f64),
    Tabulated(Tabulated),
}

impl DropletDistribution {
    /// The same, a file's path being relative to `folder`.
    #[must_use]
    pub fn relative_to(self, folder: &Path) -> Self {
        match self {
            Self::Tabulated { file } => Self::Tabulated { file: folder.join(file) },
            other => other,
        }
    }

    /// The same law at another effective radius, µm; its width in units of the radius stays.
    ///
    /// # Errors
    /// [`OpticsError`] for a tabulated distribution, and as [`resolve`](Self::resolve).
    pub fn at_effective_radius(&self, radius_um: f64) -> Result<Self, OpticsError> {
        let stretch = radius_um / self.resolve()?.effective_radius();
        let law = match *self {
            Self::ModifiedGamma { gamma, .. } => {
                Self::ModifiedGamma { gamma, effective_radius_um: radius_um }
            }
            Self::GeneralisedGamma { alpha, b, c } => {
                Self::GeneralisedGamma { alpha, b: b * libm::pow(stretch, -c), c }
            }
            Self::Lognormal { sigma, effective_variance, .. } => Self::Lognormal {
                effective_radius_um: Some(radius_um),
                median_radius_um: None,
                sigma,
                effective_variance,
            },
            Self::SingleSize { .. } => Self::SingleSize { radius_um },
            Self::Tabulated { .. } => {
                let message = "a tabulated droplet distribution has one effective radius and gives no other";
                return Err(OpticsError::Config(message.to_owned()));
            }
        };
        law.resolve().map(|_| law)
    }

    /// Checks the numbers, reads the file.
    ///
    /// # Errors
    /// [`OpticsError`] naming the value, the key or the place in the file that is refused.
    pub fn resolve(&self) -> Result<SizeDistribution, OpticsError> {
        let (law, words) = match self {
            Self::ModifiedGamma { gamma, effective_radius_um: r } => (
                Law::Gamma(GeneralisedGamma::modified(*gamma, *r)?),
                format!("modified gamma, gamma = {gamma}, effective radius {r} um"),
            ),
            Self::GeneralisedGamma { alpha, b, c } => (
                Law::Gamma(GeneralisedGamma::new(*alpha, *b, *c)?),
                format!("generalised gamma r^{alpha} exp(-{b} r^{c}), r in um"),
            ),
            Self::Lognormal { effective_radius_um, median_radius_um, sigma, effective_variance } => {
                let law =
                    Lognormal::new(*effective_radius_um, *median_radius_um, *sigma, *effective_variance)?;
                (Law::Lognormal(law), law.words())
            }
            Self::SingleSize { radius_um } => (
                Law::Single(RADIUS_UM.check("radius_um", *radius_um)?),
                format!("single size, radius {radius_um} um"),
            ),
            Self::Tabulated { file } => (
                Law::Tabulated(Tabulated::read(file)?),
                format!("tabulated in {}", file.file_name().unwrap_or_default().to_string_lossy()),
            ),
        };
        let distribution = SizeDistribution { law, words };
        RADIUS_UM.check("effective radius of the droplets, um,", distribution.effective_radius())?;
        Ok(distribution)
    }
}

impl SizeDistribution {
    /// The distribution in words, with its numbers.
    pub fn words(&self) -> &str {
        &self.words
    }

    /// The radius, if all droplets have the same.
    pub fn single_radius(&self) -> Option<f64> {
        match self.law {
            Law::Single(radius) => Some(radius),
            _ => None,
        }
    }

    /// n(r) per µm, ∫n dr = 1; zero for droplets of a single size, whose density is no number.
    pub fn density(&self, r: f64) -> f64 {
        match &self.law {
            Law::Gamma(law) => law.density(r),
            Law::Lognormal(law) => law.density(r),
            Law::Single(_) => 0.0,
            Law::Tabulated(law) => law.density(r),
        }
    }

    /// ⟨r^k⟩ in µm^k.
    pub fn moment(&self, k: u32) -> f64 {
        match &self.law {
            Law::Gamma(law) => law.moment(k),
            Law::Lognormal(law) => law.moment(k),
            Law::Single(radius) => (0..k).fold(1.0, |power, _| power * radius),
            Law::Tabulated(law) => law.moment(k),
        }
    }

    /// r_e in µm.
    pub fn effective_radius(&self) -> f64 {
        self.moment(3) / self.moment(2)
    }

    /// v_e; rounding below 0 counts as 0.
    pub fn effective_variance(&self) -> f64 {
        let third = self.moment(3);
        (self.moment(4) * self.moment(2) / (third * third) - 1.0).max(0.0)
    }

    /// Radii outside which less than 1e-6 of the geometrical cross-section ∫r²n dr (below) and 1e-5 of the forward
    /// peak ∫r⁴n dr (above) are left.
    pub fn scattering_range(&self) -> [f64; 2] {
        match &self.law {
            Law::Single(radius) => [*radius, *radius],
            Law::Tabulated(law) => law.support(),
            _ => self.quantiles(),
        }
    }

    /// The quantiles of [`scattering_range`](Self::scattering_range), on a logarithmic grid of radii round r_e that is
    /// as wide as the distribution: 20 √v_e, and no more than e^12.
    fn quantiles(&self) -> [f64; 2] {
        const STEPS: i32 = 4000;
        let centre = self.effective_radius();
        let span = (20.0 * self.effective_variance().sqrt()).min(12.0);
        let radius = |i: i32| centre * libm::exp(span * f64::from(i - STEPS) / f64::from(STEPS));
        let nodes: Vec<(f64, f64)> = (0..=2 * STEPS).map(radius).map(|r| (r, self.density(r))).collect();
        let total = |power| nodes.iter().map(|node| weight(power, node)).fold(0.0, |sum, w| sum + w);
        let low = passed(nodes.iter(), 2, 1e-6 * total(2)).unwrap_or(centre);
        let high = passed(nodes.iter().rev(), 4, 1e-5 * total(4)).unwrap_or(centre);
        [low, high]
    }
}

/// r^power n dr of a radius and its density, dr being in proportion to r.
fn weight(power: u32, &(r, density): &(f64, f64)) -> f64 {
    (0..=power).fold(density, |product, _| product * r)
}

/// The radius at which the sum of the weights of `nodes` passes `enough`.
fn passed<'a>(mut nodes: impl Iterator<Item = &'a (f64, f64)>, power: u32, enough: f64) -> Option<f64> {
    let mut sum = 0.0;
    let end = nodes.find(|node| {
        sum += weight(power, node);
        sum > enough
    });
    end.map(|node| node.0)
}

#[cfg(test)]
mod tests;
