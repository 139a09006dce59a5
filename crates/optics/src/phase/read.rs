//! Phase functions from files: `theta_deg,p` tables and moments, one χ_l a line.

use super::PhaseTable;
use super::table::{self, Norm};
use crate::OpticsError;
use serde::{Deserialize, Serialize};
use std::path::Path;
use stratiform_artifact::{ArtifactError, read_numbered_csv, read_text};
use stratiform_quantities::Range;

/// A row of a phase function file.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PhaseRow {
    /// Θ in degrees.
    pub theta_deg: f64,
    /// P.
    pub p: f64,
}

impl PhaseTable {
    /// The rows of a phase function file.
    pub fn rows(&self) -> Vec<PhaseRow> {
        let rows = self.theta_deg().iter().zip(self.values());
        rows.map(|(&theta_deg, &p)| PhaseRow { theta_deg, p }).collect()
    }

    /// Reads a file of columns `theta_deg,p`.
    ///
    /// # Errors
    /// [`OpticsError::Artifact`] naming file and line; [`OpticsError::NotNormalised`] as `norm` says.
    pub fn read(path: &Path, norm: Norm) -> Result<Self, OpticsError> {
        let rows: Vec<(u64, PhaseRow)> = read_numbered_csv(path)?;
        let (theta, p): (Vec<f64>, Vec<f64>) = rows.iter().map(|(_, row)| (row.theta_deg, row.p)).unzip();
        table::check(&theta, &p)
            .map_err(|(row, message)| ArtifactError::format(path, row.map(|i| rows[i].0), message))?;
        Self::new(theta, p, norm)
    }

    /// Reads moments and sums them; see [`from_moments`](Self::from_moments).
    ///
    /// # Errors
    /// [`OpticsError`] naming file and line, or the moments' own fault.
    pub fn read_moments(path: &Path) -> Result<Self, OpticsError> {
        Self::from_moments(&read_moments(path)?)
    }
}

/// χ_0, χ_1, … of a file with one number a line; empty lines and lines from `#` on do not count.
///
/// # Errors
/// [`ArtifactError`] naming the line of what is not a number in \[-1, 1\], or a χ_0 that is not 1.
pub fn read_moments(path: &Path) -> Result<Vec<f64>, ArtifactError> {
    let text = read_text(path)?;
    let mut moments = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let field = line.split('#').next().unwrap_or_default().trim();
        if field.is_empty() {
            continue;
        }
        let fault = |message: String| ArtifactError::format(path, Some(i as u64 + 1), message);
        let chi: f64 = field.parse().map_err(|_| fault(format!("`{field}` is not a number")))?;
        let range = if moments.is_empty() { Range::closed(1.0, 1.0) } else { Range::closed(-1.0, 1.0) };
        let name = format!("moment chi_{}", moments.len());
        moments.push(range.check(&name, chi).map_err(|error| fault(error.to_string()))?);
    }
    if moments.is_empty() {
        return Err(ArtifactError::format(path, None, "no moments in the file"));
    }
    Ok(moments)
}
