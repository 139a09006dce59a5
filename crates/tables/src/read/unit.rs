//! Degrees, radians or cosines: what the range of the angles says, and what the header says.

use super::Fault;
use super::layout::Row;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::fmt;

/// What the angle's column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AngleUnit {
    /// Θ in degrees.
    Degrees,
    /// Θ in radians.
    Radians,
    /// cosΘ.
    Cosine,
}

impl fmt::Display for AngleUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Degrees => "degrees",
            Self::Radians => "radians",
            Self::Cosine => "cosines",
        })
    }
}

impl AngleUnit {
    /// First and last value of a whole sphere, and how far rounding may move them (π as 3.14; cosines as 1.00000).
    const fn ends(self) -> ([f64; 2], f64) {
        match self {
            Self::Degrees => ([0.0, 180.0], 1e-3),
            Self::Radians => ([0.0, PI], 2e-3),
            Self::Cosine => ([-1.0, 1.0], 1e-5),
        }
    }

    /// What the header says, if anything.
    pub(super) fn stated(header: &str) -> Option<Self> {
        let header = header.to_lowercase();
        let words: Vec<&str> = header.split(|c: char| !c.is_alphanumeric()).collect();
        let has = |list: &[&str]| words.iter().any(|word| list.contains(word));
        if has(&["deg", "degree", "degrees"]) || header.contains('°') {
            Some(Self::Degrees)
        } else if has(&["rad", "radian", "radians"]) {
            Some(Self::Radians)
        } else if has(&["cos", "mu", "costheta", "cosine", "cosines"]) {
            Some(Self::Cosine)
        } else {
            None
        }
    }

    /// What the range of the angles says.
    pub(super) fn found(rows: &[&Row], column: usize) -> Result<Self, Fault> {
        let angle = |row: &&&Row| row.cells[column];
        let low = rows.iter().map(|row| angle(&row)).fold(f64::INFINITY, f64::min);
        let high = rows.iter().map(|row| angle(&row)).fold(f64::NEG_INFINITY, f64::max);
        let fits = |unit: &Self| {
            let ([first, last], slack) = unit.ends();
            (low - first).abs() <= slack && (high - last).abs() <= slack
        };
        [Self::Degrees, Self::Radians, Self::Cosine].into_iter().find(fits).ok_or_else(|| {
            let message = format!(
                "the angles run from {low} to {high}, not over 0 to 180 degrees, 0 to pi radians or -1 to 1 as cosines"
            );
            Fault::at(rows[rows.len() - 1].line, message)
        })
    }

    /// Θ in degrees; the ends of the sphere exactly.
    pub(super) fn degrees(self, value: f64) -> f64 {
        let ([first, last], slack) = self.ends();
        let near = |end: f64| (value - end).abs() <= slack.min(1e-9);
        let [at_first, at_last] = if self == Self::Cosine { [180.0, 0.0] } else { [0.0, 180.0] };
        match self {
            _ if near(first) => at_first,
            _ if near(last) => at_last,
            Self::Degrees => value,
            Self::Radians => value.to_degrees(),
            Self::Cosine => libm::acos(value.clamp(-1.0, 1.0)).to_degrees(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_tell_units() {
        assert_eq!(AngleUnit::stated("theta_deg,p"), Some(AngleUnit::Degrees));
        assert_eq!(AngleUnit::stated("Theta [rad]  P11"), Some(AngleUnit::Radians));
        assert_eq!(AngleUnit::stated("mu p"), Some(AngleUnit::Cosine));
        assert_eq!(AngleUnit::stated("angle, radiance"), None);
    }
}
