//! The complex refractive index of liquid water, m = n + ik, by linear interpolation of published tables.
//!
//! Hale & Querry 1973 (25 °C, n to about 1e-3) and Segelstein 1981, each over the part of 0.2–2.5 µm it covers.
//! Linear interpolation is that of `reference-data/water-*`; outside a table the wavelength is refused.

use crate::OpticsError;
use serde::{Deserialize, Serialize};
use stratiform_quantities::Range;

const HALE_QUERRY: &str = include_str!("../../../reference-data/water-hale-querry-1973/index.csv");
const SEGELSTEIN: &str = include_str!("../../../reference-data/water-segelstein-1981/index.csv");

/// Largest wavelength served, µm.
const LONGEST_UM: f64 = 2.5;

/// Where water's index is taken from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum WaterTable {
    /// Hale & Querry 1973, Appl. Opt. 12, 555.
    #[default]
    #[serde(rename = "hale-querry-1973")]
    HaleQuerry1973,
    /// Segelstein 1981, M.Sc. thesis.
    #[serde(rename = "segelstein-1981")]
    Segelstein1981,
}

/// The droplets' index: a table's name, or `[n, k]` at every wavelength.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "expected \"hale-querry-1973\", \"segelstein-1981\" or [n, k]")]
pub enum IndexSource {
    /// Water by a published table.
    Water(WaterTable),
    /// A constant n, k.
    Constant([f64; 2]),
}

impl Default for IndexSource {
    fn default() -> Self {
        Self::Water(WaterTable::default())
    }
}

impl IndexSource {
    /// n, k at `wavelength_um`.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] for a wavelength that the table does not cover.
    pub fn at(&self, wavelength_um: f64) -> Result<[f64; 2], OpticsError> {
        match self {
            Self::Water(table) => table.at(wavelength_um),
            Self::Constant(index) => Ok(*index),
        }
    }
}

impl WaterTable {
    /// n, k at `wavelength_um`.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] for a wavelength that the table does not cover.
    pub fn at(self, wavelength_um: f64) -> Result<[f64; 2], OpticsError> {
        let rows = self.rows();
        let covered = |i: usize| rows.get(i).map_or(0.0, |row| row[0]);
        let range = Range::closed(covered(0), covered(rows.len() - 1).min(LONGEST_UM));
        let wavelength = range.check("wavelength_um (the water table's range)", wavelength_um)?;
        let right = rows.partition_point(|row| row[0] < wavelength).clamp(1, rows.len() - 1);
        let ([l0, n0, k0], [l1, n1, k1]) = (rows[right - 1], rows[right]);
        let t = (wavelength - l0) / (l1 - l0);
        Ok([n0 + t * (n1 - n0), k0 + t * (k1 - k0)])
    }

    /// λ in µm, n, k.
    fn rows(self) -> Vec<[f64; 3]> {
        let text = match self {
            Self::HaleQuerry1973 => HALE_QUERRY,
            Self::Segelstein1981 => SEGELSTEIN,
        };
        text.lines().filter_map(row).collect()
    }
}

/// A line of three numbers; the header is none.
fn row(line: &str) -> Option<[f64; 3]> {
    let mut fields = line.split(',').map(|field| field.trim().parse().ok());
    Some([fields.next()??, fields.next()??, fields.next()??])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The library carries the tables, and they are the ones of record.
    #[test]
    fn the_built_in_tables_are_the_transcribed_ones() {
        let of_record = |source| stratiform_reference_data::read(source, "index.csv").unwrap();
        assert_eq!(HALE_QUERRY, of_record("water-hale-querry-1973"));
        assert_eq!(SEGELSTEIN, of_record("water-segelstein-1981"));
    }

    #[test]
    fn every_row_of_both_tables_is_read() {
        assert_eq!(WaterTable::HaleQuerry1973.rows().len(), HALE_QUERRY.lines().count() - 1);
        assert_eq!(WaterTable::Segelstein1981.rows().len(), SEGELSTEIN.lines().count() - 1);
    }

    /// The rows themselves, and midpoints by hand (Hale & Querry 1973, 0.55 and 0.575 µm).
    #[test]
    fn interpolation_is_linear_between_rows() {
        let [n, k] = WaterTable::HaleQuerry1973.at(0.55).unwrap();
        assert!((n - 1.333).abs() < 1e-15 && (k - 1.96e-9).abs() < 1e-22);
        let [n, k] = WaterTable::HaleQuerry1973.at(0.5625).unwrap();
        assert!((n - 1.333).abs() < 1e-15 && (k - 2.78e-9).abs() < 1e-22);
        let [n, _] = WaterTable::Segelstein1981.at(0.65).unwrap();
        assert!((n - 1.33069).abs() < 1e-5);
    }

    #[test]
    fn wavelengths_outside_are_refused() {
        for wavelength in [0.199, 2.51, f64::NAN, -1.0] {
            assert!(WaterTable::HaleQuerry1973.at(wavelength).is_err(), "{wavelength}");
        }
        assert!(WaterTable::Segelstein1981.at(0.25).is_err());
        assert!(WaterTable::HaleQuerry1973.at(0.2).is_ok() && WaterTable::HaleQuerry1973.at(2.5).is_ok());
    }
}
