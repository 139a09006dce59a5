//! Numbers of a document that follow from others of it.
//!
//! What is emitted is the fitted value wherever there is one, and the table in metres is the optical one times κ (see
//! [`fit`](fn@crate::fit)). Both hold to rounding.

use crate::FitError;
use crate::document::in_metres;
use crate::regression::named;
use stratiform_artifact::{FittedParameter, ParameterRow, ParameterTable, ParametersDocument, RowIncidence};

/// A number of a document beside what follows from the rest of it.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivedNumber {
    /// Row of the table; none for what all rows share.
    pub theta_l_deg: Option<RowIncidence>,
    /// Table and name: `optical t`.
    pub name: String,
    /// What the document says.
    pub document: f64,
    /// What follows.
    pub follows: f64,
}

/// Every number of both tables that follows from others.
///
/// # Errors
/// [`FitError::Inconsistent`] if the two tables have not the same rows, or one has a number that the other lacks.
pub fn derived_numbers(document: &ParametersDocument) -> Result<Vec<DerivedNumber>, FitError> {
    let (optical, metres) = (&document.optical, &document.metres);
    let mut numbers: Vec<_> = optical.rows.iter().flat_map(|row| emitted(row, "optical")).collect();
    numbers.extend(metres.rows.iter().flat_map(|row| emitted(row, "metres")));
    let converted = in_metres(optical, document.medium.extinction_per_m);
    numbers.extend(shared(metres, &converted));
    FitError::check_length("the table in metres", metres.rows.len(), converted.rows.len())?;
    for (row, follows) in metres.rows.iter().zip(&converted.rows) {
        if row.theta_l_deg != follows.theta_l_deg {
            return Err(FitError::Inconsistent(format!(
                "the table in metres has theta_l = {} where the optical one has {}",
                row.theta_l_deg, follows.theta_l_deg
            )));
        }
        numbers.extend(in_step(row, follows)?);
    }
    Ok(numbers)
}

/// What is emitted where there is a value.
fn emitted(row: &ParameterRow, table: &str) -> Vec<DerivedNumber> {
    let number = |(name, parameter): (&str, &FittedParameter)| DerivedNumber {
        theta_l_deg: Some(row.theta_l_deg.clone()),
        name: format!("{table} {name}"),
        document: parameter.emitted,
        follows: parameter.value.unwrap_or(parameter.emitted),
    };
    named(row).into_iter().map(number).collect()
}

fn shared(metres: &ParameterTable, follows: &ParameterTable) -> [DerivedNumber; 3] {
    let (beta, again) = (metres.beta, follows.beta);
    [
        ("metres beta", beta.value, again.value),
        ("metres beta", beta.std_error, again.std_error),
        ("metres kappa_s", metres.kappa_s, follows.kappa_s),
    ]
    .map(|(name, document, follows)| DerivedNumber {
        theta_l_deg: None,
        name: name.to_owned(),
        document,
        follows,
    })
}

/// Values and errors of a row in metres beside those converted.
fn in_step(row: &ParameterRow, converted: &ParameterRow) -> Result<Vec<DerivedNumber>, FitError> {
    let mut numbers = Vec::new();
    for ((name, a), (_, b)) in named(row).into_iter().zip(named(converted)) {
        let fields = [
            ("value", a.value, b.value),
            ("error", a.std_error, b.std_error),
            ("emitted", Some(a.emitted), Some(b.emitted)),
        ];
        for (field, document, follows) in fields {
            let theta_l_deg = Some(row.theta_l_deg.clone());
            match (document, follows) {
                (Some(document), Some(follows)) => {
                    let name = format!("metres {name}");
                    numbers.push(DerivedNumber { theta_l_deg, name, document, follows });
                }
                (None, None) => (),
                _ => {
                    return Err(FitError::Inconsistent(format!(
                        "only one of the tables has a {field} of {name} at theta_l = {}",
                        row.theta_l_deg
                    )));
                }
            }
        }
    }
    Ok(numbers)
}
