//! The published Appendix B as inputs of generation, with a Henyey–Greenstein function for the cloud's.

use stratiform_artifact::{
    FittedParameter, MediumRecord, ParameterRow, ParameterTable, ParametersDocument, Provenance,
    RadianceFace, RadianceParametersDocument, RowIncidence,
};
use stratiform_codegen::{HaloTable, Inputs, PhaseRow, PhaseTables};
use stratiform_model::radiance::{EXPONENTS, POWERS, TERMS};
use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
use stratiform_quantities::{Asymmetry, ExtinctionConvention, Side};
use stratiform_stats::Estimate;

/// N0 π r_e² of the paper's cloud, 1/m.
const KAPPA: f64 = 0.046_18;
/// Published β, thickness in metres.
const BETA: f64 = 0.9961;
const FORWARD_FRACTION: f64 = 0.455;

#[derive(serde::Deserialize)]
struct PublishedRow {
    theta_l_deg: f64,
    b: f64,
    c_per_m: f64,
    kappa_c_per_m: f64,
    t: f64,
    r: f64,
}

fn published() -> Vec<PublishedRow> {
    stratiform_reference_data::rows("bouthors-2006", "appendix-b.csv").unwrap()
}

fn fitted(value: f64) -> FittedParameter {
    FittedParameter { value: Some(value), std_error: None, emitted: value }
}

fn row(theta_l_deg: RowIncidence, row: &PublishedRow, unit: f64) -> ParameterRow {
    ParameterRow {
        theta_l_deg,
        b: fitted(row.b),
        c: fitted(row.c_per_m * unit),
        kappa_c: fitted(row.kappa_c_per_m * unit),
        t: fitted(row.t),
        r: fitted(row.r),
        correlation_b_c: None,
        correlation_kappa_c_t_r: None,
        misfit: Vec::new(),
        flags: Vec::new(),
        stopped_multiple: "published".to_owned(),
        stopped_orders: "published".to_owned(),
    }
}

/// The table per `unit` metres. The paper has no diffuse row: that of 50° stands for it.
fn table(unit: f64) -> ParameterTable {
    let published = published();
    let mut rows: Vec<_> =
        published.iter().map(|r| row(RowIncidence::Degrees(r.theta_l_deg), r, unit)).collect();
    rows.push(row(RowIncidence::diffuse(), &published[5], unit));
    let slope = (1.0 - BETA) / BETA * unit;
    ParameterTable {
        beta: Estimate { value: 1.0 / (1.0 + slope), std_error: 0.0 },
        kappa_s: (1.0 - FORWARD_FRACTION) * KAPPA * unit,
        rows,
    }
}

fn phase(g: f64) -> Vec<PhaseRow> {
    let function = HenyeyGreenstein::new(Asymmetry::new(g).unwrap());
    let row = |i: i32| {
        let theta_deg = f64::from(i) * 0.1;
        let sine = libm::sin(0.5 * theta_deg.to_radians());
        PhaseRow { theta_deg, p: function.value(2.0 * sine * sine) }
    };
    (0..=1800).map(row).collect()
}

fn medium() -> MediumRecord {
    MediumRecord {
        wavelength_um: 0.55,
        extinction_convention: ExtinctionConvention::Paper,
        extinction_per_m: KAPPA,
        single_scattering_albedo: 1.0,
        asymmetry: 0.853,
        theta_f_deg: 5.0,
        forward_fraction: FORWARD_FRACTION,
    }
}

/// Some coefficients.
fn radiance() -> RadianceParametersDocument {
    let estimate = |j: usize, k: usize| Estimate { value: 0.1 * (j as f64 - 0.3 * k as f64), std_error: 0.0 };
    let rows = (0..POWERS).map(|j| (0..TERMS).map(|k| estimate(j, k)).collect());
    let coefficients: Vec<Vec<_>> = rows.collect();
    let face = |side| RadianceFace { side, coefficients: coefficients.clone(), relative_std_error: 0.0 };
    RadianceParametersDocument {
        schema: RadianceParametersDocument::SCHEMA.to_owned(),
        provenance: Provenance::new("invented".to_owned(), None, "invented"),
        medium: medium(),
        exponents: EXPONENTS.to_vec(),
        faces: Side::BOTH.map(face).to_vec(),
        misfit: Vec::new(),
    }
}

/// Inputs of generation.
pub fn inputs() -> Inputs {
    Inputs {
        parameters: ParametersDocument {
            schema: ParametersDocument::SCHEMA.to_owned(),
            provenance: Provenance::new("published".to_owned(), None, "published Appendix B"),
            medium: medium(),
            thickness_range_m: [1.0, 1000.0],
            metres: table(1.0),
            optical: table(1.0 / KAPPA),
        },
        phase: PhaseTables { full: phase(0.85), modified: phase(0.7), squared: phase(0.5) },
        halo: Some(HaloTable {
            reach: 0.2,
            longest: 20.0,
            angles: 8,
            values: (0..32).map(|i| 900.0 / f64::from(1 + i % 8)).collect(),
        }),
        radiance: Some(radiance()),
        reference: Vec::new(),
    }
}
