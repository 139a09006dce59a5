//! Normalisation and sign of a table, named but not repaired.
//!
//! The integral is I = ½∫P sinΘ dΘ, P linear in Θ between rows. Conventions are powers of π apart, so that a table within
//! 15 % of one is taken to mean it (a coarse table misses its integral by 10 %). A truncated peak could make one
//! convention look like another; where Mie's P is known, its ratio to the table between 20° and 170° decides instead, unless
//! the integral fits within 2 %.
//!
//! An angle counted between the directions to the sun and to the viewer puts forward at 180°: g < -0.1, which no
//! droplet ensemble has, tells it; where Mie's P is known, the table nearer to it after mirroring is flipped.

use super::{AngleUnit, RawTable};
use crate::TablesError;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use stratiform_optics::phase::{Norm, PhaseFunction, PhaseTable};

/// What the values integrate to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normalisation {
    /// Mean 1 over the sphere, ∫P dΩ = 4π: this project's.
    MeanOne,
    /// ∫P dΩ = 1.
    PerSteradian,
    /// ∫P dcosΘ = 1.
    PerCosine,
    /// 4π times too large: ∫P dΩ = (4π)².
    FourPi,
    /// 2π times too large: ∫P dcosΘ = 4π.
    TwoPi,
    /// 2π times too small: ∫P dΩ = 2.
    PerTwoPi,
    /// Divided by the value at 0°.
    ForwardOne,
    /// None of these: intensities.
    Unnormalised,
}

/// The conventions told by their integral.
const BY_INTEGRAL: [(Normalisation, f64); 6] = [
    (Normalisation::MeanOne, 1.0),
    (Normalisation::PerSteradian, 0.25 / PI),
    (Normalisation::PerCosine, 0.5),
    (Normalisation::FourPi, 4.0 * PI),
    (Normalisation::TwoPi, 2.0 * PI),
    (Normalisation::PerTwoPi, 0.5 / PI),
];

/// How far an integral may be off its convention, as a factor.
const SLACK: f64 = 1.15;

/// Below this asymmetry parameter a table is held to be mirrored.
const MIRRORED_BELOW: f64 = -0.1;

impl Normalisation {
    /// In words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::MeanOne => "mean 1 over the sphere",
            Self::PerSteradian => "integral over solid angle 1 (1/(4 pi) of mean 1)",
            Self::PerCosine => "integral over the cosine 1 (half of mean 1)",
            Self::FourPi => "4 pi times mean 1",
            Self::TwoPi => "2 pi times mean 1",
            Self::PerTwoPi => "1/(2 pi) of mean 1",
            Self::ForwardOne => "divided by the forward value",
            Self::Unnormalised => {
                "no known one: intensities, or a part is missing (droplets given tell which)"
            }
        }
    }
}

/// What the numbers of a table seem to mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Understanding {
    /// By the range of the angles.
    pub unit: AngleUnit,
    /// By the header.
    pub stated_unit: Option<AngleUnit>,
    /// ½∫P sinΘ dΘ as it stands.
    pub integral: f64,
    /// The convention nearest to it.
    pub normalisation: Normalisation,
    /// What the values are to be divided by to have that convention's mean 1.
    pub factor: f64,
    /// Whether forward is at 180°.
    pub mirrored: bool,
}

impl Understanding {
    /// Understands `raw`; `mie` is the phase function that it should be, where known.
    ///
    /// # Errors
    /// [`TablesError`] if the values have no integral.
    pub fn of(raw: &RawTable, mie: Option<&PhaseTable>) -> Result<Self, TablesError> {
        let plain = PhaseTable::new(raw.theta_deg.clone(), raw.value.clone(), Norm::Any)?;
        let integral = integral(&raw.value, &plain);
        let mirrored = match mie {
            Some(mie) => {
                (mie.asymmetry() - plain.asymmetry()).abs() > (mie.asymmetry() + plain.asymmetry()).abs()
            }
            None => plain.asymmetry() < MIRRORED_BELOW,
        };
        let scale = mie.map(|mie| scale(raw, mirrored, mie));
        let (normalisation, factor) = normalisation(raw, integral, scale);
        Ok(Self { unit: raw.unit, stated_unit: raw.stated_unit, integral, normalisation, factor, mirrored })
    }

    /// What is unusual, in words.
    pub fn unusual(&self) -> Option<String> {
        let mut words = Vec::new();
        if let Some(stated) = self.stated_unit.filter(|stated| *stated != self.unit) {
            words.push(format!("angle unit: the header says {stated}, the range says {}", self.unit));
        }
        if self.mirrored {
            words.push("angle sign flipped: forward is at 180 degrees".to_owned());
        }
        if self.normalisation != Normalisation::MeanOne {
            words.push(format!("normalisation: {}, integral {}", self.normalisation.words(), self.integral));
        }
        (!words.is_empty()).then(|| words.join("; "))
    }

    /// Angles and values with forward at 0° and the convention's factor divided out, but not normalised further.
    pub fn undone(&self, raw: &RawTable) -> (Vec<f64>, Vec<f64>) {
        let mut theta = raw.theta_deg.clone();
        let mut value: Vec<f64> = raw.value.iter().map(|p| p / self.factor).collect();
        if self.mirrored {
            theta = theta.iter().rev().map(|t| 180.0 - t).collect();
            value.reverse();
        }
        (theta, value)
    }

    /// The phase function with forward at 0° and mean 1.
    ///
    /// # Errors
    /// [`TablesError`] if the values have no integral.
    pub fn repaired(&self, raw: &RawTable) -> Result<PhaseTable, TablesError> {
        let (theta, value) = self.undone(raw);
        Ok(PhaseTable::new(theta, value, Norm::Any)?)
    }
}

/// ½∫P sinΘ dΘ of the values that `normalised` was made from: what they were divided by.
fn integral(value: &[f64], normalised: &PhaseTable) -> f64 {
    let pairs = value.iter().zip(normalised.values());
    let largest = pairs.max_by(|a, b| a.0.total_cmp(b.0));
    largest.map_or(f64::NAN, |(value, normalised)| value / normalised)
}

/// The median of the table over Mie's P between 20° and 170°.
fn scale(raw: &RawTable, mirrored: bool, mie: &PhaseTable) -> f64 {
    let mut ratios: Vec<f64> = (20..=170)
        .map(|degrees| {
            let theta = f64::from(if mirrored { 180 - degrees } else { degrees });
            interpolated(&raw.theta_deg, &raw.value, theta) / mie.at(f64::from(degrees).to_radians())
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    ratios[ratios.len() / 2]
}

/// The value at `theta` of a table linear between its rows.
fn interpolated(theta_deg: &[f64], value: &[f64], theta: f64) -> f64 {
    let right = theta_deg.partition_point(|t| *t <= theta).clamp(1, theta_deg.len() - 1);
    let [a, b] = [theta_deg[right - 1], theta_deg[right]];
    value[right - 1] + (value[right] - value[right - 1]) * (theta - a) / (b - a)
}

fn normalisation(raw: &RawTable, integral: f64, scale: Option<f64>) -> (Normalisation, f64) {
    let near = |value: f64, slack: f64| {
        let off = |norm: f64| (value / norm).max(norm / value);
        let nearest = BY_INTEGRAL.into_iter().min_by(|a, b| off(a.1).total_cmp(&off(b.1)));
        nearest.filter(|(_, norm)| off(*norm) < slack)
    };
    let by_shape = || scale.and_then(|scale| near(scale, 1.1));
    let ends = [raw.value[0], raw.value[raw.value.len() - 1]];
    if ends.iter().any(|end| (end - 1.0).abs() < 1e-6) && ends[0].max(ends[1]) <= 1.0 && integral < 0.3 {
        return (Normalisation::ForwardOne, integral);
    }
    near(integral, 1.02)
        .or_else(by_shape)
        .or_else(|| near(integral, SLACK))
        .unwrap_or((Normalisation::Unnormalised, integral))
}
