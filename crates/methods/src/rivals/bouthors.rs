//! Bouthors, Neyret & Lefebvre 2006: single and double scattering by formula, the rest from a fitted one-dimensional model.
//!
//! *Real-time realistic illumination and shading of stratiform clouds* (Eurographics Workshop on Natural Phenomena 2006). Angular part:
//! section 4 (`stratiform_model::angular`), I1 + I2 + I3+; fluxes: appendix A (`stratiform_model`), T_ms and R_ms, with a table over θ_l.
//!
//! | name | table | forms | I3+ |
//! | --- | --- | --- | --- |
//! | `bouthors-printed` | appendix B | as printed, slips included | μ_l/(4πμ_v) |
//! | `bouthors-published` | appendix B | corrected | Lambertian |
//! | `bouthors-corrected` | refitted | corrected | Lambertian |
//! | `bouthors-corrected-isotropic`, `-escape` | refitted | corrected | 1/(2μ_v), K(μ_v) |
//!
//! I0, light that met forward events only, is left out: below it is missing within θ_f of the sun. Both tables belong to one cloud: domain r_e = 7 µm,
//! ω = 1, the thickness of the fit (1 m to 1 km: τ from 0.047 to 46) and θ_l up to 80°. P, P_S and P_S² are the cloud's.
//! Hufnagel & Held's class: mixed (4.1.6).

use crate::lookup::{EMITTED_TEXELS, Exact, Texels};
use crate::scalar::Scalar;
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, MethodError};
use stratiform_artifact::{ParameterRow, ParametersDocument, PublishedRow};
use stratiform_model::angular::{Angular, Emission, PhaseLookup, Sight, as_printed};
use stratiform_model::table::{Angle, ParameterGrid};
use stratiform_model::{Fluxes, Form, Thickness, Values};
use stratiform_quantities::Range;

const APPENDIX_B: &str = include_str!("../../../../reference-data/bouthors-2006/appendix-b.csv");
const REFITTED: &str = include_str!("../../../../fit-configs/appendix-b/accepted/parameters.json");

/// β of appendix B.
const BETA: f64 = 0.9961;
/// P_f as the paper states it (section 3.3).
const STATED_FORWARD_FRACTION: f64 = 0.51;
/// N0 π r_e² of the paper's cloud, 1/m.
const KAPPA_PER_M: f64 = 300e6 * std::f64::consts::PI * 49e-12;

/// Which forms, and where I3+ goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    Printed,
    Corrected(Emission),
}

/// Which parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Table {
    Published,
    Refitted,
}

struct Bouthors<F, P> {
    grid: ParameterGrid<F>,
    /// Thickness in the grid's unit per τ.
    unit: F,
    /// κ_S per τ.
    kappa_s: F,
    /// κ_S in 1/m.
    kappa_s_per_m: F,
    reading: Reading,
    phase: P,
}

impl<F: Scalar, P: PhaseLookup<F>> Bouthors<F, P> {
    /// The one-dimensional model; `None` outside the table.
    fn model(&self, tau: F, mu_l: F) -> Option<Fluxes<F>> {
        let form = if self.reading == Reading::Printed { Form::AsPrinted } else { Form::Corrected };
        let thickness = Thickness::new(self.unit * tau).ok()?;
        Some(self.grid.at(mu_l).ok()?.fluxes(form, thickness))
    }
}

impl<F: Scalar, P: PhaseLookup<F> + Send + Sync> Shade<F> for Bouthors<F, P> {
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F {
        let slab = Angular::unchecked(self.kappa_s * tau, *sight);
        let orders = self.model(tau, sight.mu_l).map(|fluxes| match self.reading {
            Reading::Printed => as_printed::orders(&slab, self.kappa_s_per_m, &self.phase, &fluxes),
            Reading::Corrected(emission) => slab.orders(&self.phase, &fluxes, emission),
        });
        orders.map_or(F::of(0.0), |orders| orders.total())
    }

    fn fluxes(&self, tau: F, mu_l: F) -> (F, F) {
        self.model(tau, mu_l).map_or((F::of(0.0), F::of(0.0)), |fluxes| (fluxes.r_ms, fluxes.t_ms))
    }
}

fn damaged(error: &dyn std::fmt::Display) -> MethodError {
    MethodError::Failed { method: "bouthors".to_owned(), reason: format!("built-in table: {error}") }
}

/// Appendix B with κ_S per metre.
fn published(kappa_s_per_m: f64) -> Result<Vec<Angle>, MethodError> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(APPENDIX_B.as_bytes());
    let angle = |row: Result<PublishedRow, csv::Error>| {
        let PublishedRow { theta_l_deg, b, c_per_m, kappa_c_per_m, t, r } = row.map_err(|e| damaged(&e))?;
        let (c, kappa_c) = (c_per_m, kappa_c_per_m);
        let values = Values { beta: BETA, b, c, kappa_c, t, r, kappa_s: kappa_s_per_m };
        Ok(Angle { theta_l_deg, values })
    };
    reader.deserialize().map(angle).collect()
}

/// The accepted fit, per τ.
fn refitted() -> Result<Vec<Angle>, MethodError> {
    let document: ParametersDocument = serde_json::from_str(REFITTED).map_err(|e| damaged(&e))?;
    let table = &document.optical;
    let angle = |row: &ParameterRow| {
        let (b, c, kappa_c) = (row.b.emitted, row.c.emitted, row.kappa_c.emitted);
        let (t, r, beta, kappa_s) = (row.t.emitted, row.r.emitted, table.beta.value, table.kappa_s);
        let values = Values { beta, b, c, kappa_c, t, r, kappa_s };
        row.theta_l_deg.degrees().map(|theta_l_deg| Angle { theta_l_deg, values })
    };
    Ok(table.rows.iter().filter_map(angle).collect())
}

fn prepare<F: Scalar, P>(
    table: Table,
    reading: Reading,
    cloud: &Cloud,
    phase: P,
) -> Result<Bouthors<F, P>, MethodError> {
    let kept = match reading {
        Reading::Printed => 1.0 - STATED_FORWARD_FRACTION,
        Reading::Corrected(_) => 1.0 - cloud.omega().get() * cloud.forward_fraction(),
    };
    let kappa_s_per_m = kept * KAPPA_PER_M;
    let (angles, unit) = match table {
        Table::Published => (published(kappa_s_per_m)?, 1.0 / KAPPA_PER_M),
        Table::Refitted => (refitted()?, 1.0),
    };
    let grid = ParameterGrid::new(&angles).map_err(|e| damaged(&e))?;
    let (unit, kappa_s, kappa_s_per_m) = (F::of(unit), F::of(kept), F::of(kappa_s_per_m));
    Ok(Bouthors { grid, unit, kappa_s, kappa_s_per_m, reading, phase })
}

/// With these parameters, read in this way.
pub(crate) fn method(name: &str, title: &'static str, table: Table, reading: Reading) -> Simple {
    let card = Card {
        name: name.to_owned(),
        title,
        source: "Bouthors, Neyret & Lefebvre 2006, section 4 and appendices A and B",
        class: Class::Mixed,
        domain: Domain {
            tau: Range::closed(0.047, 46.0),
            mu_l: Range::closed(0.1737, 1.0),
            omega: Range::closed(1.0, 1.0),
            r_eff_um: Range::closed(7.0, 7.0),
            ..Domain::EVERYWHERE
        },
        radiance: true,
        flux: true,
        table_bytes: Some(2 * 4 * EMITTED_TEXELS + 10 * 6 * 4),
    };
    Simple::new(card, move |card, cloud| {
        Ok(Box::new(Shaded {
            card: card.clone(),
            double: prepare::<f64, _>(table, reading, cloud, Exact::twice(cloud)?)?,
            single: InSingle(prepare(table, reading, cloud, Texels::<f32>::twice(cloud, EMITTED_TEXELS)?)?),
        }))
    })
}
