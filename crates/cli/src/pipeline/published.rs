//! Appendix B of Bouthors, Neyret & Lefebvre 2006, as published.

use crate::CliError;
use crate::config::PublishedTable;
use std::path::Path;
use stratiform_artifact::{PublishedRow, write_csv};
use stratiform_model::Values;

/// β, the same for every angle.
pub const BETA: f64 = 0.9961;
/// Share of the phase function below 5°, from 5° to 90°, beyond (section 3.3).
pub const SHARES: [f64; 3] = [0.51, 0.48, 0.01];
/// Who published it.
pub const SOURCE: &str = "Bouthors, Neyret & Lefebvre, Real-time realistic illumination and shading of stratiform \
                          clouds, Eurographics Workshop on Natural Phenomena 2006, appendix B";

const TABLE: &str = include_str!("../../../../reference-data/bouthors-2006/appendix-b.csv");

/// The rows, by angle; none if the config names no published table.
///
/// # Errors
/// [`CliError::Input`] if the built-in table is damaged.
pub fn rows(table: Option<PublishedTable>) -> Result<Vec<PublishedRow>, CliError> {
    if table.is_none() {
        return Ok(Vec::new());
    }
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(TABLE.as_bytes());
    reader
        .deserialize()
        .collect::<Result<_, _>>()
        .map_err(|e| CliError::Input(format!("published table: {e}")))
}

/// The row's parameters, with κ_S per metre.
pub fn values(row: &PublishedRow, kappa_s_per_m: f64) -> Values<f64> {
    let PublishedRow { b, c_per_m, kappa_c_per_m, t, r, .. } = *row;
    Values { beta: BETA, b, c: c_per_m, kappa_c: kappa_c_per_m, t, r, kappa_s: kappa_s_per_m }
}

/// Writes `published.csv` if there are rows; takes away another cloud's.
///
/// # Errors
/// [`CliError::Input`] if it cannot be written.
pub fn write(dir: &Path, rows: &[PublishedRow]) -> Result<Option<String>, CliError> {
    if rows.is_empty() {
        // Nothing to remove is as good as removed.
        let _ = std::fs::remove_file(dir.join("published.csv"));
        return Ok(None);
    }
    write_csv(&dir.join("published.csv"), rows)?;
    Ok(Some("published.csv".to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The program carries the table, and it is the one of record.
    #[test]
    fn the_built_in_table_is_the_transcribed_one() {
        assert_eq!(TABLE, stratiform_reference_data::read("bouthors-2006", "appendix-b.csv").unwrap());
        assert_eq!(rows(Some(PublishedTable::Bouthors2006)).unwrap().len(), 10);
    }
}
