//! `phase_colour.csv`: a cloud's phase functions in linear sRGB on the angle map.
//!
//! Comments at its head say which config's cloud it is, and from which wavelengths. Texel i stands at u = i/1023 of
//! [`angle_map`]; P and P_S convolved with itself are point values there, every channel with mean 1 over the sphere.

use crate::{ArtifactError, read_numbered_csv, read_text, to_csv, write_atomic};
use serde::{Deserialize, Serialize};
use std::path::Path;
use stratiform_quantities::{Range, angle_map};

/// One texel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PhaseColourRow {
    /// From 0.
    pub index: usize,
    /// Θ in degrees.
    pub theta_deg: f64,
    /// P of the full medium.
    pub p_red: f64,
    /// Likewise.
    pub p_green: f64,
    /// Likewise.
    pub p_blue: f64,
    /// P_S convolved with itself on the sphere, of every wavelength's own P_S.
    pub squared_red: f64,
    /// Likewise.
    pub squared_green: f64,
    /// Likewise.
    pub squared_blue: f64,
}

/// The file.
#[derive(Clone, Debug, PartialEq)]
pub struct PhaseColour {
    /// `provenance.config_hash` of the parameters beside which it stands.
    pub config_hash: String,
    /// λ, µm.
    pub wavelengths_um: Vec<f64>,
    /// The texels.
    pub rows: Vec<PhaseColourRow>,
}

impl PhaseColourRow {
    /// P, then P²: red, green, blue.
    pub fn channels(&self) -> [[f64; 3]; 2] {
        [[self.p_red, self.p_green, self.p_blue], [self.squared_red, self.squared_green, self.squared_blue]]
    }
}

impl PhaseColour {
    /// Rows of the file.
    pub const TEXELS: usize = 1024;

    /// Θ of a texel, degrees.
    pub fn theta_deg(index: usize) -> f64 {
        angle_map::angle_deg(index as f64 / (Self::TEXELS - 1) as f64)
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`ArtifactError`] with file and line for a head that is not as above, a missing or displaced texel, and a value that is negative
    /// or not finite.
    pub fn read(path: &Path) -> Result<Self, ArtifactError> {
        let text = read_text(path)?;
        let head = |name: &str| {
            let found =
                text.lines().find_map(|line| line.strip_prefix("# ")?.strip_prefix(name)?.strip_prefix(' '));
            found.ok_or_else(|| {
                ArtifactError::format(path, Some(1), format!("no line `# {name} ...` at its head"))
            })
        };
        let wavelengths =
            head("wavelengths_um")?.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>();
        let wavelengths_um = wavelengths
            .map_err(|error| ArtifactError::format(path, Some(1), format!("wavelengths_um: {error}")))?;
        let config_hash = head("config")?.trim().to_owned();
        let rows: Vec<(u64, PhaseColourRow)> = read_numbered_csv(path)?;
        for (index, (line, row)) in rows.iter().enumerate() {
            check(index, row).map_err(|message| ArtifactError::format(path, Some(*line), message))?;
        }
        if rows.len() != Self::TEXELS {
            let message = format!("{} texels, not {}", rows.len(), Self::TEXELS);
            return Err(ArtifactError::format(path, rows.last().map(|(line, _)| *line), message));
        }
        Ok(Self { config_hash, wavelengths_um, rows: rows.into_iter().map(|(_, row)| row).collect() })
    }

    /// Writes it, whole or not at all.
    ///
    /// # Errors
    /// [`ArtifactError`] for a number that is not finite, or a file that cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), ArtifactError> {
        let wavelengths: String = self.wavelengths_um.iter().map(|w| format!(" {w}")).collect();
        let head = format!("# config {}\n# wavelengths_um{wavelengths}\n", self.config_hash);
        write_atomic(path, (head + &to_csv(&self.rows)?).as_bytes())
    }
}

fn check(index: usize, row: &PhaseColourRow) -> Result<(), String> {
    if row.index != index {
        return Err(format!("texel {} stands where {index} belongs", row.index));
    }
    let expected = PhaseColour::theta_deg(index);
    if (row.theta_deg - expected).abs() >= 1e-9 || row.theta_deg.is_nan() {
        return Err(format!("theta_deg = {} is not {expected}", row.theta_deg));
    }
    let values = row.channels().into_iter().flatten();
    values.into_iter().try_for_each(|value| {
        Range::at_least(0.0)
            .check("a channel of the phase function", value)
            .map(drop)
            .map_err(|e| e.to_string())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey() -> PhaseColour {
        let row = |index| PhaseColourRow {
            index,
            theta_deg: PhaseColour::theta_deg(index),
            p_red: 1.0,
            p_green: 1.0,
            p_blue: 0.1 + 0.2,
            squared_red: 1.0,
            squared_green: 1.0,
            squared_blue: 1.0,
        };
        PhaseColour {
            config_hash: "0a".to_owned(),
            wavelengths_um: vec![0.4, 0.55, 0.7],
            rows: (0..PhaseColour::TEXELS).map(row).collect(),
        }
    }

    #[test]
    fn every_bit_comes_back() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("phase_colour.csv");
        grey().write(&path).unwrap();
        assert_eq!(PhaseColour::read(&path).unwrap(), grey());
    }

    /// A comment line, the wavelengths, the header: texel 0 stands on line 4.
    #[test]
    fn damage_is_told_with_its_line() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("phase_colour.csv");
        grey().write(&path).unwrap();
        let whole = read_text(&path).unwrap();
        let lines: Vec<&str> = whole.lines().collect();
        let line7 = "3,0.003095948607152155,1.0,1.0,0.30000000000000004,1.0,1.0,1.0";
        assert_eq!(lines[6].split(',').next(), Some("3"));
        let damaged = [
            (whole.replacen(lines[6], &line7.replace("0.30000000000000004", "NaN"), 1), ":7: a channel"),
            (whole.replacen(lines[6], &line7.replace("0.30000000000000004", "-0.1"), 1), ":7: a channel"),
            (whole.replacen(lines[6], &line7.replace("3,0.003", "3,0.004"), 1), ":7: theta_deg = 0.004"),
            (whole.replacen(&format!("{}\n", lines[6]), "", 1), ":7: texel 4 stands where 3 belongs"),
            (lines[..500].join("\n"), "497 texels, not 1024"),
            (whole.replacen("# config 0a\n", "", 1), "no line `# config ...`"),
            (whole.replacen("0.55", "x", 1), "wavelengths_um: invalid float literal"),
            (String::new(), "the file is empty"),
        ];
        for (text, message) in damaged {
            std::fs::write(&path, text).unwrap();
            let error = PhaseColour::read(&path).unwrap_err().to_string();
            assert!(error.contains(message), "{message}: {error}");
        }
    }
}
