//! The table of values: seven columns in any order; others are not looked at. Lines that start with `#` are comments.

use crate::CliError;
use crate::check::config::Quantity;
use crate::numbers;
use csv::StringRecord;
use std::collections::HashMap;
use std::path::Path;
use stratiform_artifact::{RowIncidence, read_text};
use stratiform_quantities::{OpticalThickness, Order, Range};

/// The columns.
pub const COLUMNS: [&str; 7] = ["quantity", "theta_l_deg", "theta_v_deg", "phi_deg", "tau", "order", "value"];

/// Angles to the slab's normal, degrees.
const ZENITH: Range = Range::closed(0.0, 90.0);
/// Azimuths, degrees.
const AZIMUTH: Range = Range::closed(-360.0, 360.0);
/// Orders that the solver lists.
const ORDERS: Range = Range::closed(0.0, 60.0);

/// One row.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueRow {
    /// Line of the file, from 1.
    pub line: u64,
    /// What.
    pub quantity: Quantity,
    /// Incidence.
    pub theta_l_deg: RowIncidence,
    /// View, for radiance.
    pub theta_v_deg: Option<f64>,
    /// View's azimuth, for radiance.
    pub phi_deg: Option<f64>,
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// Order.
    pub order: Order,
    /// The value to judge.
    pub value: f64,
}

/// Reads and checks `file`.
///
/// # Errors
/// [`CliError::Input`] with file and line.
pub fn read(file: &Path) -> Result<Vec<ValueRow>, CliError> {
    let text = read_text(file)?;
    let at = |line: u64, message: String| CliError::Input(format!("{}:{line}: {message}", file.display()));
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let fault = |error: csv::Error| at(error.position().map_or(1, csv::Position::line), error.to_string());
    let header = reader.headers().map_err(fault)?.clone();
    let places = places(&header).map_err(|message| at(header_line(&text), message))?;
    let mut rows = Vec::new();
    let mut seen = HashMap::new();
    for record in reader.records() {
        let record = record.map_err(fault)?;
        let line = record.position().map_or(0, csv::Position::line);
        let row = row(places.map(|place| &record[place]), line).map_err(|message| at(line, message))?;
        if let Some(first) = seen.insert(row.key(), line) {
            return Err(at(line, format!("repeats line {first}")));
        }
        rows.push(row);
    }
    if rows.is_empty() {
        return Err(at(header_line(&text), "the table has no rows".to_owned()));
    }
    Ok(rows)
}

fn header_line(text: &str) -> u64 {
    text.lines().take_while(|line| line.starts_with('#') || line.trim().is_empty()).count() as u64 + 1
}

/// Where each of [`COLUMNS`] stands.
fn places(header: &StringRecord) -> Result<[usize; 7], String> {
    let mut places = [0; 7];
    for (place, column) in places.iter_mut().zip(COLUMNS) {
        let mut found = header.iter().enumerate().filter(|(_, name)| *name == column).map(|(i, _)| i);
        *place = found
            .next()
            .ok_or_else(|| format!("column `{column}` is missing; the columns are {}", COLUMNS.join(",")))?;
        if found.next().is_some() {
            return Err(format!("column `{column}` stands there twice"));
        }
    }
    Ok(places)
}

fn row(
    [quantity, theta_l, theta_v, phi, tau, order, value]: [&str; 7],
    line: u64,
) -> Result<ValueRow, String> {
    let quantity: Quantity = quantity.parse()?;
    let row = ValueRow {
        line,
        quantity,
        theta_l_deg: incidence(theta_l)?,
        theta_v_deg: view("theta_v_deg", theta_v, quantity, ZENITH)?,
        phi_deg: view("phi_deg", phi, quantity, AZIMUTH)?,
        tau: within("tau", number("tau", tau)?, OpticalThickness::RANGE)?,
        order: order.parse()?,
        value: number("value", value)?,
    };
    match row.order {
        Order::Exactly(1 | 2) | Order::Total => {}
        Order::Exactly(n) if !quantity.is_radiance() => {
            within("order", f64::from(n), ORDERS)?;
        }
        Order::Tail if !quantity.is_radiance() => {}
        other => return Err(format!("order {other} of {quantity}: only 1, 2 and total are known")),
    }
    if quantity.is_radiance() && row.theta_l_deg.degrees().is_none() {
        return Err(format!("theta_l_deg `diffuse` of {quantity}: radiance is per F0 of a beam"));
    }
    Ok(row)
}

fn number(column: &str, cell: &str) -> Result<f64, String> {
    match cell {
        "" => Err(format!("{column} is empty")),
        cell => numbers::finite(cell).map_err(|message| format!("{column}: {message}")),
    }
}

fn within(column: &str, value: f64, range: Range) -> Result<f64, String> {
    range.check(column, value).map_err(|error| error.to_string())
}

fn incidence(cell: &str) -> Result<RowIncidence, String> {
    if cell == "diffuse" {
        return Ok(RowIncidence::diffuse());
    }
    Ok(RowIncidence::Degrees(within("theta_l_deg", number("theta_l_deg", cell)?, ZENITH)?))
}

/// An angle of view: needed for radiance, empty for fluxes.
fn view(column: &str, cell: &str, quantity: Quantity, range: Range) -> Result<Option<f64>, String> {
    match (quantity.is_radiance(), cell) {
        (false, "") => Ok(None),
        (false, cell) => Err(format!("{column} = {cell}: {quantity} is a flux and has no view")),
        (true, cell) => within(column, number(column, cell)?, range).map(Some),
    }
}

impl ValueRow {
    /// Everything but the value.
    fn key(&self) -> impl Eq + std::hash::Hash + use<> {
        let bits = |value: f64| (value + 0.0).to_bits();
        (
            self.quantity,
            self.theta_l_deg.degrees().map(bits),
            self.theta_v_deg.map(bits),
            self.phi_deg.map(bits),
            bits(self.tau),
            self.order,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "quantity,theta_l_deg,theta_v_deg,phi_deg,tau,order,value\n";

    fn parse(text: &str) -> Result<Vec<ValueRow>, String> {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("v.csv");
        std::fs::write(&file, text).unwrap();
        read(&file).map_err(|error| error.to_string().replace(&file.display().to_string(), "v.csv"))
    }

    #[test]
    fn columns_stand_in_any_order_and_others_are_ignored() {
        let text = "# made by a shader\nvalue,note,order,tau,phi_deg,theta_v_deg,theta_l_deg,quantity\n\
                    0.25, fine ,total,1e1,,,diffuse,reflectance\n\
                    0.5,,1,2,-180,30,60,radiance_top\n";
        let rows = parse(text).unwrap();
        assert_eq!((rows[0].line, rows[0].tau, rows[0].order), (3, 10.0, Order::Total));
        assert_eq!(rows[0].theta_l_deg, RowIncidence::diffuse());
        assert_eq!((rows[1].theta_v_deg, rows[1].phi_deg), (Some(30.0), Some(-180.0)));
        assert_eq!((rows[1].order, rows[1].quantity), (Order::Exactly(1), Quantity::RadianceTop));
    }

    #[test]
    fn faults_are_named_with_their_line() {
        let cases = [
            ("", "v.csv: the file is empty"),
            ("quantity,theta_l_deg\n", "v.csv:1: column `theta_v_deg` is missing"),
            ("#\nquantity,theta_l_deg\n", "v.csv:2: column"),
            (
                "value,quantity,theta_l_deg,theta_v_deg,phi_deg,tau,order,value\n",
                "`value` stands there twice",
            ),
        ];
        for (text, says) in cases {
            let error = parse(text).unwrap_err();
            assert!(error.contains(says), "{error}");
        }
        for (rows, says) in [
            ("", "v.csv:1: the table has no rows"),
            ("reflectanse,0,,,1,total,0\n", "v.csv:2: quantity `reflectanse` is none of"),
            ("reflectance,0,,,1,total,nan\n", "v.csv:2: value: `nan` is not a finite number"),
            ("reflectance,0,,,1,total,inf\n", "value: `inf`"),
            ("reflectance,0,,,1,total,\n", "v.csv:2: value is empty"),
            ("reflectance,0,,,nan,total,1\n", "tau: `nan`"),
            ("reflectance,0,,,-1,total,1\n", "tau = -1 is outside [0, 1000000]"),
            ("reflectance,91,,,1,total,1\n", "theta_l_deg = 91 is outside [0, 90]"),
            ("reflectance,noon,,,1,total,1\n", "theta_l_deg: `noon`"),
            ("reflectance,0,10,,1,total,1\n", "theta_v_deg = 10: reflectance is a flux"),
            ("reflectance,0,,10,1,total,1\n", "phi_deg = 10: reflectance is a flux"),
            ("reflectance,0,,,1,all,1\n", "order `all`"),
            ("reflectance,0,,,1,61,1\n", "order = 61 is outside [0, 60]"),
            ("radiance_top,0,,0,1,total,1\n", "theta_v_deg is empty"),
            ("radiance_top,0,95,0,1,total,1\n", "theta_v_deg = 95 is outside [0, 90]"),
            ("radiance_bottom,0,5,400,1,total,1\n", "phi_deg = 400 is outside [-360, 360]"),
            ("radiance_bottom,0,5,0,1,tail,1\n", "order tail of radiance_bottom"),
            ("radiance_bottom,diffuse,5,0,1,total,1\n", "radiance is per F0 of a beam"),
            ("reflectance,0,,,1,total,1\nreflectance,0.0,,,1.0,total,2\n", "v.csv:3: repeats line 2"),
            ("reflectance,0,,,1,total\n", "v.csv:2: "),
        ] {
            let error = parse(&format!("{HEADER}{rows}")).unwrap_err();
            assert!(error.contains(says), "{rows}: {error}");
        }
    }
}
