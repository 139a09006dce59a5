//! `stratiform/errors/1`: the signed error of methods at points, and what the methods cost.
//!
//! A folder with `errors.csv` (a row for each point, a column for each method), `methods.csv` and `colour.csv`. Errors are
//! (method - truth)/truth in whole per mille, cut off at [`ErrorRow::LARGEST`]; an empty field where the method refuses, or
//! where the truth is not known.

use crate::{ArtifactError, atomic, read_csv, write_csv};
use serde::{Deserialize, Serialize};
use std::path::Path;
use stratiform_quantities::Side;

/// A listed method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ErrorMethod {
    /// As in the chart, with its knob.
    pub name: String,
    /// For people.
    pub title: String,
    /// Gives radiances.
    pub radiance: bool,
    /// Gives fluxes.
    pub flux: bool,
    /// One radiance in f32 on one thread.
    pub ns: Option<f64>,
    /// One pair of fluxes likewise.
    pub flux_ns: Option<f64>,
    /// Tables for one cloud; empty where it is no shader code.
    pub table_bytes: Option<u64>,
    /// Texels of its phase table; empty where it has none.
    pub texels: Option<u64>,
    /// Where it answers, ends included: optical thickness.
    pub tau_min: f64,
    /// Likewise.
    pub tau_max: f64,
    /// Cosine of the sun.
    pub mu_l_min: f64,
    /// Cosine of the view.
    pub mu_v_min: f64,
    /// r_e; empty where all are.
    pub r_e_min_um: Option<f64>,
    /// Likewise.
    pub r_e_max_um: Option<f64>,
}

/// Which points belong together: an axis of each lattice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ErrorBlock {
    /// Radiances over thickness, sun, view, azimuth and side.
    Grid,
    /// Towards the point opposite the sun, over Θ.
    Glory,
    /// Over Θ of the white bow.
    Fogbow,
    /// Round the sun, over Θ.
    SilverLining,
    /// R (side top) and T (side bottom).
    Flux,
}

/// A point.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorRow {
    /// Its lattice.
    pub block: ErrorBlock,
    /// r_e.
    pub effective_radius_um: f64,
    /// Optical thickness.
    pub tau: f64,
    /// Sun.
    pub theta_l_deg: f64,
    /// View.
    pub theta_v_deg: f64,
    /// Azimuth.
    pub phi_deg: f64,
    /// Θ.
    pub scattering_deg: f64,
    /// Face.
    pub side: Side,
    /// Reflectance factor or flux; absent where it is not known well enough.
    pub truth: Option<f64>,
    /// Per mille: as the columns say.
    pub values: Vec<Option<i32>>,
}

impl ErrorRow {
    /// Larger errors are written as this.
    pub const LARGEST: i32 = 9999;
}

/// `errors.csv` or `colour.csv`.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorTable {
    /// Names of the values.
    pub columns: Vec<String>,
    /// Points.
    pub rows: Vec<ErrorRow>,
}

/// The columns before the values.
const KEYS: [&str; 9] = [
    "block",
    "effective_radius_um",
    "tau",
    "theta_l_deg",
    "theta_v_deg",
    "phi_deg",
    "scattering_deg",
    "side",
    "truth",
];

type Keys = (ErrorBlock, f64, f64, f64, f64, f64, f64, Side, Option<f64>);

impl ErrorTable {
    /// Reads a file.
    ///
    /// # Errors
    /// [`ArtifactError`] with file and line.
    pub fn read(path: &Path) -> Result<Self, ArtifactError> {
        Self::parse(&atomic::read_text(path)?, path)
    }

    /// Reads a text; `origin` stands in messages.
    ///
    /// # Errors
    /// [`ArtifactError::Format`].
    pub fn parse(text: &str, origin: &Path) -> Result<Self, ArtifactError> {
        let fault = |line, message: String| ArtifactError::format(origin, line, message);
        let of_csv = |error: csv::Error| fault(error.position().map(csv::Position::line), error.to_string());
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        let headers = reader.headers().map_err(of_csv)?.clone();
        if headers.iter().take(KEYS.len()).ne(KEYS) {
            return Err(fault(Some(1), format!("the columns do not begin with {}", KEYS.join(","))));
        }
        let columns: Vec<String> = headers.iter().skip(KEYS.len()).map(str::to_owned).collect();
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(of_csv)?;
            let line = record.position().map(csv::Position::line);
            let (keys, values) = record.iter().enumerate().partition::<Vec<_>, _>(|(i, _)| *i < KEYS.len());
            let keys: csv::StringRecord = keys.into_iter().map(|(_, field)| field).collect();
            let keys: Keys = keys.deserialize(None).map_err(|error| fault(line, error.to_string()))?;
            let number = |field: &str| {
                let none = || fault(line, format!("`{field}` is no whole number"));
                if field.is_empty() { Ok(None) } else { field.parse().map(Some).map_err(|_| none()) }
            };
            rows.push(row(keys, values.iter().map(|(_, field)| number(field)).collect::<Result<_, _>>()?));
        }
        if rows.is_empty() {
            return Err(fault(None, "the table has no rows".to_owned()));
        }
        Ok(Self { columns, rows })
    }

    /// The text.
    ///
    /// # Errors
    /// [`ArtifactError::NotFinite`] if a row cannot be written.
    pub fn to_csv(&self) -> Result<String, ArtifactError> {
        let refuse = |error: String| ArtifactError::NotFinite { what: error };
        let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
        let written = (|| {
            writer.write_record(KEYS.iter().copied().chain(self.columns.iter().map(String::as_str)))?;
            self.rows.iter().try_for_each(|row| writer.serialize((keys(row), &row.values)))
        })();
        written.map_err(|error| refuse(error.to_string()))?;
        let bytes = writer.into_inner().map_err(|error| refuse(error.to_string()))?;
        String::from_utf8(bytes).map_err(|error| refuse(error.to_string()))
    }

    /// Writes [`to_csv`](Self::to_csv), whole or not at all.
    ///
    /// # Errors
    /// [`ArtifactError`].
    pub fn write(&self, path: &Path) -> Result<(), ArtifactError> {
        atomic::write_atomic(path, self.to_csv()?.as_bytes())
    }
}

fn row(keys: Keys, values: Vec<Option<i32>>) -> ErrorRow {
    let (block, effective_radius_um, tau, theta_l_deg, theta_v_deg, phi_deg, scattering_deg, side, truth) =
        keys;
    ErrorRow {
        block,
        effective_radius_um,
        tau,
        theta_l_deg,
        theta_v_deg,
        phi_deg,
        scattering_deg,
        side,
        truth,
        values,
    }
}

fn keys(row: &ErrorRow) -> Keys {
    let angles = (row.theta_l_deg, row.theta_v_deg, row.phi_deg, row.scattering_deg);
    let (theta_l, theta_v, phi, scattering) = angles;
    (row.block, row.effective_radius_um, row.tau, theta_l, theta_v, phi, scattering, row.side, row.truth)
}

/// The folder.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorData {
    /// `methods.csv`.
    pub methods: Vec<ErrorMethod>,
    /// `errors.csv`: columns `once` and `twice`, the shares of orders 1 and 2 in the truth, then the methods.
    pub errors: ErrorTable,
    /// `colour.csv`: columns `red` and `blue`, the truth there over the truth in the middle, less 1.
    pub colour: ErrorTable,
}

impl ErrorData {
    /// The files.
    pub const FILES: [&str; 3] = ["methods.csv", "errors.csv", "colour.csv"];

    /// Columns of `errors.csv` before the methods.
    pub const ORDERS: [&str; 2] = ["once", "twice"];

    /// Reads a folder.
    ///
    /// # Errors
    /// [`ArtifactError`] with file and line.
    pub fn read(folder: &Path) -> Result<Self, ArtifactError> {
        let [methods, errors, colour] = Self::FILES.map(|name| folder.join(name));
        Self::new(read_csv(&methods)?, ErrorTable::read(&errors)?, ErrorTable::read(&colour)?, &errors)
    }

    /// Puts the parts together if they fit.
    ///
    /// # Errors
    /// [`ArtifactError::Format`] unless the columns are those of the methods.
    pub fn new(
        methods: Vec<ErrorMethod>,
        errors: ErrorTable,
        colour: ErrorTable,
        origin: &Path,
    ) -> Result<Self, ArtifactError> {
        let names = Self::ORDERS.into_iter().chain(methods.iter().map(|method| method.name.as_str()));
        if !errors.columns.iter().map(String::as_str).eq(names) {
            return Err(ArtifactError::format(origin, Some(1), "the columns are not those of methods.csv"));
        }
        Ok(Self { methods, errors, colour })
    }

    /// Writes the folder, which must exist.
    ///
    /// # Errors
    /// [`ArtifactError`].
    pub fn write(&self, folder: &Path) -> Result<(), ArtifactError> {
        let [methods, errors, colour] = Self::FILES.map(|name| folder.join(name));
        write_csv(&methods, &self.methods)?;
        self.errors.write(&errors)?;
        self.colour.write(&colour)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_reads_back_and_a_foreign_one_is_refused() {
        let row = ErrorRow {
            block: ErrorBlock::SilverLining,
            effective_radius_um: 7.0,
            tau: 0.1,
            theta_l_deg: 20.0,
            theta_v_deg: 21.5,
            phi_deg: 0.0,
            scattering_deg: 1.5,
            side: Side::Bottom,
            truth: Some(0.123),
            values: vec![Some(-12), None],
        };
        let rows = vec![row.clone(), ErrorRow { truth: None, ..row }];
        let table = ErrorTable { columns: vec!["a:1".to_owned(), "b".to_owned()], rows };
        let (text, origin) = (table.to_csv().unwrap(), Path::new("errors.csv"));
        assert_eq!(ErrorTable::parse(&text, origin).unwrap(), table);
        for (from, to) in [("tau", "t"), ("-12", "x"), ("bottom", "side"), ("-12,", "-12,1,")] {
            assert!(ErrorTable::parse(&text.replacen(from, to, 1), origin).is_err(), "{from}");
        }
    }
}
