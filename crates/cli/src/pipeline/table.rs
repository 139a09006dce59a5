//! The regenerated table beside the published one, for people.

use super::published;
use crate::CliError;
use crate::config::PublishedTable;
use std::fmt::Write;
use stratiform_artifact::{FittedParameter, ParametersDocument, PublishedRow};

/// `value(error)`: the error counts in units of the value's last digit, of which it has two.
fn with_error(value: f64, error: f64) -> String {
    if error.is_nan() || error <= 0.0 {
        return format!("{value:.4}");
    }
    let digits = (1.0 - libm::floor(libm::log10(error))).clamp(0.0, 12.0) as usize;
    let unit = error * libm::pow(10.0, digits as f64);
    format!("{value:.digits$}({unit:.0})")
}

fn cell(parameter: &FittedParameter) -> String {
    match (parameter.value, parameter.std_error) {
        (None, _) => "-".to_owned(),
        (Some(value), Some(error)) => with_error(value, error),
        (Some(value), None) => format!("{value:.4} !"),
    }
}

fn line(text: &mut String, head: &str, cells: [String; 5]) {
    let [b, c, kappa_c, t, r] = cells;
    let _ = writeln!(text, "{head:>9}  {b:>14} {c:>14} {kappa_c:>14} {t:>14} {r:>14}");
}

fn published_cells(row: &PublishedRow) -> [String; 5] {
    [row.b, row.c_per_m, row.kappa_c_per_m, row.t, row.r].map(|value| format!("{value:.4}"))
}

/// The table as text: each angle's fitted parameters, and below them the published ones, if any.
///
/// # Errors
/// [`CliError::Input`] if the built-in published table is damaged.
pub fn parameter_table(
    document: &ParametersDocument,
    table: Option<PublishedTable>,
) -> Result<String, CliError> {
    let mut text = String::new();
    let medium = &document.medium;
    let _ = writeln!(
        text,
        "wavelength {} um, kappa = {:.5} 1/m ({}), P_f({} deg) = {:.4}, g = {:.4}",
        medium.wavelength_um,
        medium.extinction_per_m,
        medium.extinction_convention,
        medium.theta_f_deg,
        medium.forward_fraction,
        medium.asymmetry
    );
    let beta = document.metres.beta;
    let theirs = table.map_or(String::new(), |_| format!(" (published {})", published::BETA));
    let _ = writeln!(text, "beta = {}{theirs}\n", with_error(beta.value, beta.std_error));
    line(&mut text, "theta_l", ["b", "c (1/m)", "kappa_c (1/m)", "t", "r"].map(str::to_owned));
    let published = published::rows(table)?;
    for row in &document.metres.rows {
        line(
            &mut text,
            &row.theta_l_deg.to_string(),
            [&row.b, &row.c, &row.kappa_c, &row.t, &row.r].map(cell),
        );
        if let Some(theirs) = published.iter().find(|p| Some(p.theta_l_deg) == row.theta_l_deg.degrees()) {
            line(&mut text, "published", published_cells(theirs));
        }
        if !row.flags.is_empty() {
            let _ = writeln!(text, "{:>9}  {}", "flags", row.flag_names());
        }
    }
    let _ = writeln!(
        text,
        "\n1.234(56) means 1.234 with {} of 0.056; - is not identifiable; ! has no error (fixed or on a bound)",
        if document.provenance.is_random() { "a standard error" } else { "an estimated error" }
    );
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_have_two_digits_in_units_of_the_last() {
        assert_eq!(with_error(1.179_6, 0.001_23), "1.1796(12)");
        assert_eq!(with_error(0.026_5, 0.000_045), "0.026500(45)");
        assert_eq!(with_error(12.3, 4.5), "12.3(45)");
        assert_eq!(with_error(0.5, 0.0), "0.5000");
    }
}
