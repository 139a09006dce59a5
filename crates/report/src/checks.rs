//! What numbers read from files must satisfy before they are drawn. JSON cannot hold a number that is not
//! finite; CSV can, so every column is checked.

use crate::{ReportError, input::PhaseRow};
use std::path::Path;
use stratiform_artifact::{
    AgreementRow, AngularBooksRow, ArtifactError, ConvergenceRow, CurvesRow, LadderRow, OpticsDocument,
    OrdersRow, ParametersDocument, PrincipalPlaneRow, PublishedRow, QuadratureRow, SolverCostRow, read_json,
};
use stratiform_quantities::{Order, Range};

const ANGLE: Range = Range::closed(0.0, 90.0);
const SCATTERING_ANGLE: Range = Range::closed(0.0, 180.0);
const POSITIVE: Range = Range::above(0.0);
const NOT_NEGATIVE: Range = Range::at_least(0.0);
const FINITE: Range = Range::closed(f64::MIN, f64::MAX);
const SHARE: Range = Range::closed(0.0, 1.0);

type Columns<'a> = [(&'a str, f64, Range)];

fn columns(path: &Path, row: Option<usize>, columns: &Columns) -> Result<(), ReportError> {
    for (name, value, range) in columns {
        let name = row.map_or_else(|| (*name).to_owned(), |row| format!("row {}, {name}", row + 1));
        range.check(&name, *value).map_err(|source| ReportError::Domain { path: path.to_owned(), source })?;
    }
    Ok(())
}

fn format_error(path: &Path, message: String) -> ReportError {
    ArtifactError::format(path, None, message).into()
}

/// A document must name its schema before its fields mean anything.
pub fn schema(path: &Path, expected: &str) -> Result<(), ReportError> {
    #[derive(serde::Deserialize)]
    struct Schema {
        schema: String,
    }
    let found = read_json::<Schema>(path)?.schema;
    if found == expected {
        return Ok(());
    }
    Err(format_error(path, format!("schema is `{found}`, this program reads `{expected}`")))
}

pub fn optics(path: &Path, optics: &OpticsDocument) -> Result<(), ReportError> {
    let density = &optics.size_density;
    let (radii, numbers) = (density.radius_um.len(), density.number_per_cm3_um.len());
    if radii != numbers || radii < 1 {
        let found = format!("{radii} radius_um and {numbers} number_per_cm3_um");
        return Err(format_error(path, format!("size_density has {found}; it needs as many, at least 1")));
    }
    if optics.wavelengths.is_empty() {
        return Err(format_error(path, "wavelengths is empty; at least one is needed".to_owned()));
    }
    for (row, (radius, number)) in density.radius_um.iter().zip(&density.number_per_cm3_um).enumerate() {
        columns(path, Some(row), &[("radius_um", *radius, NOT_NEGATIVE), ("number", *number, NOT_NEGATIVE)])?;
    }
    for (row, wavelength) in optics.wavelengths.iter().enumerate() {
        columns(path, Some(row), &[("wavelength_um", wavelength.wavelength_um, POSITIVE)])?;
    }
    Ok(())
}

pub fn parameters(path: &Path, document: &ParametersDocument) -> Result<(), ReportError> {
    let medium = &document.medium;
    columns(
        path,
        None,
        &[
            ("extinction_per_m", medium.extinction_per_m, POSITIVE),
            ("forward_fraction", medium.forward_fraction, SHARE),
            ("theta_f_deg", medium.theta_f_deg, SCATTERING_ANGLE),
        ],
    )?;
    for table in [&document.metres, &document.optical] {
        for (row, degrees) in table.rows.iter().enumerate() {
            let degrees = degrees.theta_l_deg.degrees().unwrap_or(0.0);
            columns(path, Some(row), &[("theta_l_deg", degrees, ANGLE)])?;
        }
    }
    if document.metres.rows.is_empty() {
        return Err(format_error(path, "metres.rows is empty; at least one angle is needed".to_owned()));
    }
    Ok(())
}

pub fn phase(path: &Path, rows: &[PhaseRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        let after = rows[..i].last().map_or(SCATTERING_ANGLE, |before| Range {
            min_included: false,
            ..Range::closed(before.theta_deg, SCATTERING_ANGLE.max)
        });
        columns(path, Some(i), &[("theta_deg", row.theta_deg, after), ("p", row.p, NOT_NEGATIVE)])?;
    }
    Ok(())
}

pub fn orders(path: &Path, rows: &[OrdersRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        if row.theta_l_deg != "diffuse" {
            let degrees = row.theta_l_deg.parse().unwrap_or(f64::NAN);
            columns(path, Some(i), &[("theta_l_deg", degrees, ANGLE)])?;
        }
        row.order
            .parse::<Order>()
            .map_err(|message| format_error(path, format!("row {}: {message}", i + 1)))?;
        columns(
            path,
            Some(i),
            &[
                ("thickness_m", row.thickness_m, POSITIVE),
                ("reflectance", row.reflectance, FINITE),
                ("reflectance_std_error", row.reflectance_std_error, NOT_NEGATIVE),
                ("transmittance", row.transmittance, FINITE),
                ("transmittance_std_error", row.transmittance_std_error, NOT_NEGATIVE),
            ],
        )?;
    }
    Ok(())
}

pub fn convergence(path: &Path, rows: &[ConvergenceRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        columns(
            path,
            Some(i),
            &[
                ("theta_l_deg", row.theta_l_deg, ANGLE),
                ("tau", row.tau, NOT_NEGATIVE),
                ("photons", row.photons as f64, POSITIVE),
                ("seconds", row.seconds, NOT_NEGATIVE),
                ("error", row.error, NOT_NEGATIVE),
                ("std_error", row.std_error, NOT_NEGATIVE),
            ],
        )?;
    }
    Ok(())
}

pub fn solver_cost(path: &Path, rows: &[SolverCostRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        columns(
            path,
            Some(i),
            &[
                ("streams", row.streams as f64, POSITIVE),
                ("tau", row.tau, NOT_NEGATIVE),
                ("thicknesses", row.thicknesses as f64, POSITIVE),
                ("seconds", row.seconds, NOT_NEGATIVE),
            ],
        )?;
    }
    Ok(())
}

pub fn principal_plane(path: &Path, rows: &[PrincipalPlaneRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        columns(
            path,
            Some(i),
            &[
                ("theta_l_deg", row.theta_l_deg, ANGLE),
                ("thickness_m", row.thickness_m, POSITIVE),
                ("theta_v_deg", row.theta_v_deg, Range::closed(-90.0, 90.0)),
                ("value", row.value, FINITE),
                ("std_error", row.std_error.unwrap_or_default(), NOT_NEGATIVE),
            ],
        )?;
    }
    Ok(())
}

pub fn agreement(path: &Path, rows: &[AgreementRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        let errors = [row.solved_error, row.traced_std_error].map(Option::unwrap_or_default);
        columns(
            path,
            Some(i),
            &[
                ("solved", row.solved, FINITE),
                ("solved_error", errors[0], NOT_NEGATIVE),
                ("traced", row.traced, FINITE),
                ("traced_std_error", errors[1], NOT_NEGATIVE),
                ("z", row.z.unwrap_or_default(), FINITE),
            ],
        )?;
    }
    Ok(())
}

pub fn ladder(path: &Path, rows: &[LadderRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        let [rms, worst, tau, expected] =
            [row.rms, row.worst, row.worst_tau, row.expected_rms].map(Option::unwrap_or_default);
        columns(
            path,
            Some(i),
            &[
                ("rms", rms, NOT_NEGATIVE),
                ("worst", worst, NOT_NEGATIVE),
                ("worst_tau", tau, NOT_NEGATIVE),
                ("expected_rms", expected, NOT_NEGATIVE),
            ],
        )?;
    }
    Ok(())
}

pub fn quadrature(path: &Path, rows: &[QuadratureRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        columns(
            path,
            Some(i),
            &[
                ("wavelength_um", row.wavelength_um, POSITIVE),
                ("radii", row.radii as f64, POSITIVE),
                ("seconds", row.seconds, NOT_NEGATIVE),
                ("asymmetry", row.asymmetry, NOT_NEGATIVE),
                ("forward_fraction", row.forward_fraction, NOT_NEGATIVE),
                ("moments", row.moments, NOT_NEGATIVE),
                ("phase_below_60_deg", row.phase_below_60_deg, NOT_NEGATIVE),
                ("phase_beyond_60_deg", row.phase_beyond_60_deg, NOT_NEGATIVE),
            ],
        )?;
    }
    Ok(())
}

pub fn angular_books(path: &Path, rows: &[AngularBooksRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        columns(
            path,
            Some(i),
            &[
                ("theta_l_deg", row.theta_l_deg, ANGLE),
                ("tau", row.tau, POSITIVE),
                ("integral", row.integral, FINITE),
                ("one_dimensional_model", row.one_dimensional_model, FINITE),
                ("solver", row.solver, FINITE),
            ],
        )?;
    }
    Ok(())
}

pub fn published(path: &Path, rows: &[PublishedRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        columns(
            path,
            Some(i),
            &[
                ("theta_l_deg", row.theta_l_deg, ANGLE),
                ("b", row.b, FINITE),
                ("c_per_m", row.c_per_m, FINITE),
                ("kappa_c_per_m", row.kappa_c_per_m, FINITE),
                ("t", row.t, FINITE),
                ("r", row.r, FINITE),
            ],
        )?;
    }
    Ok(())
}

pub fn curves(path: &Path, rows: &[CurvesRow]) -> Result<(), ReportError> {
    for (i, row) in rows.iter().enumerate() {
        columns(
            path,
            Some(i),
            &[
                ("theta_l_deg", row.theta_l_deg, ANGLE),
                ("thickness_m", row.thickness_m, POSITIVE),
                ("value", row.value, FINITE),
            ],
        )?;
    }
    Ok(())
}
