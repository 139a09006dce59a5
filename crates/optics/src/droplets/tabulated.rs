//! n(r) piecewise linear between the rows of a file, zero outside. Moments are exact integrals of the pieces.

use super::RADIUS_UM;
use serde::Deserialize;
use std::path::Path;
use stratiform_artifact::{ArtifactError, read_numbered_csv};

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tabulated {
    radius: Vec<f64>,
    density: Vec<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    radius_um: f64,
    number: f64,
}

impl Tabulated {
    pub(super) fn read(path: &Path) -> Result<Self, ArtifactError> {
        let rows: Vec<(u64, Row)> = read_numbered_csv(path)?;
        let mut previous = 0.0;
        for (line, row) in &rows {
            let refuse = |message: String| ArtifactError::format(path, Some(*line), message);
            RADIUS_UM.check("radius_um", row.radius_um).map_err(|error| refuse(error.to_string()))?;
            if !(row.number.is_finite() && row.number >= 0.0) {
                return Err(refuse(format!("number = {} is outside [0, infinity)", row.number)));
            }
            if row.radius_um <= previous {
                return Err(refuse(format!("radius_um = {} does not increase", row.radius_um)));
            }
            previous = row.radius_um;
        }
        let mut table = Self {
            radius: rows.iter().map(|(_, row)| row.radius_um).collect(),
            density: rows.iter().map(|(_, row)| row.number).collect(),
        };
        let total = table.moment(0);
        if !(total.is_finite() && total > 0.0) {
            return Err(ArtifactError::format(
                path,
                None,
                format!("the numbers integrate to {total}, not to a positive number"),
            ));
        }
        table.density.iter_mut().for_each(|number| *number /= total);
        Ok(table)
    }

    pub(super) fn support(&self) -> [f64; 2] {
        [self.radius[0], self.radius[self.radius.len() - 1]]
    }

    pub(super) fn density(&self, r: f64) -> f64 {
        let [first, last] = self.support();
        if !(first..=last).contains(&r) {
            return 0.0;
        }
        let i = self.radius.partition_point(|&node| node < r).clamp(1, self.radius.len() - 1);
        let t = (r - self.radius[i - 1]) / (self.radius[i] - self.radius[i - 1]);
        self.density[i - 1] + t * (self.density[i] - self.density[i - 1])
    }

    /// Per piece ∫ r^k n dr by Simpson's rule on the pieces of degree k + 1 ≤ 5, through Gauss's three points.
    pub(super) fn moment(&self, k: u32) -> f64 {
        let offset = 0.6_f64.sqrt();
        let piece = |i: usize| {
            let (centre, half) =
                (0.5 * (self.radius[i] + self.radius[i + 1]), 0.5 * (self.radius[i + 1] - self.radius[i]));
            let slope = 0.5 * (self.density[i + 1] - self.density[i]);
            let middle = 0.5 * (self.density[i] + self.density[i + 1]);
            [(-offset, 5.0 / 9.0), (0.0, 8.0 / 9.0), (offset, 5.0 / 9.0)].iter().fold(0.0, |sum, (t, w)| {
                let r = centre + t * half;
                sum + w * half * (0..k).fold(middle + t * slope, |power, _| power * r)
            })
        };
        (0..self.radius.len() - 1).fold(0.0, |sum, i| sum + piece(i))
    }
}
