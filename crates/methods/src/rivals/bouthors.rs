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
//! | `bouthors-corrected-halo` | refitted | corrected, with I0 (section 4.2) | Lambertian |
//! | `bouthors-family` | refitted for r_e from 4 to 20 µm | corrected | above Lambertian, below K(μ_v) |
//!
//! I0, light that met forward events only, is left out of the others: below it is missing near the sun. P, P_S and P_S² are the cloud's.
//!
//! Domain: ω = 1 and the table's r_e, 7 µm but for the family; τ from 0.047 (the fit's 1 m), with appendix B from 1: thinner slabs get
//! a negative R_3+ from it, and a negative radiance; θ_l up to 80°, refitted up to the horizon. All were fitted up to τ = 46 and are
//! extrapolated beyond, where T_ms falls like 1/τ as it must.
//! Hufnagel & Held's class: mixed (4.1.6).

mod tables;

pub(crate) use tables::Table;

use crate::halo::{HaloTexels, of_cloud};
use crate::lookup::{EMITTED_TEXELS, Exact, Texels};
use crate::scalar::Scalar;
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, MethodError, Promise, Promises};
use stratiform_model::angular::halo::{Halo, Peak};
use stratiform_model::angular::{Angular, Emission, PhaseLookup, Sight, as_printed};
use stratiform_model::table::ParameterGrid;
use stratiform_model::{Fluxes, Form, Thickness};
use stratiform_quantities::{Range, Side};
use tables::{KAPPA_PER_M, damaged};

/// P_f as the paper states it (section 3.3).
const STATED_FORWARD_FRACTION: f64 = 0.51;

/// b, 1/c, 1/κ_c, t, 1/r and μ_l of ten angles.
const PARAMETER_BYTES: usize = 10 * 6 * 4;

/// Which forms, and where I3+ goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    Printed,
    Corrected(Emission),
    /// The shape of I3+ that is nearest on each side: Lambertian above, the escape function below.
    NearestShapes,
    /// I0 too, I3+ Lambertian.
    WithHalo,
}

impl Reading {
    /// The shape of I3+ on `side`.
    fn emission(self, side: Side) -> Emission {
        match (self, side) {
            (Self::Corrected(emission), _) => emission,
            (Self::NearestShapes, Side::Bottom) => Emission::Escape,
            _ => Emission::Lambertian,
        }
    }
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
    halo: Option<(Peak<F>, HaloTexels<F>)>,
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
            reading => slab.orders(&self.phase, &fluxes, reading.emission(sight.side)),
        });
        let halo = self
            .halo
            .as_ref()
            .map_or(F::of(0.0), |(peak, shape)| Halo::new(&slab, tau, *peak).total(&self.phase, shape));
        halo + orders.map_or(F::of(0.0), |orders| orders.total())
    }

    fn fluxes(&self, tau: F, mu_l: F) -> (F, F) {
        self.model(tau, mu_l).map_or((F::of(0.0), F::of(0.0)), |fluxes| (fluxes.r_ms, fluxes.t_ms))
    }
}

fn prepare<F: Scalar, P>(
    table: Table,
    reading: Reading,
    cloud: &Cloud,
    phase: P,
) -> Result<Bouthors<F, P>, MethodError> {
    let kept = match reading {
        Reading::Printed => 1.0 - STATED_FORWARD_FRACTION,
        _ => 1.0 - cloud.omega().get() * cloud.forward_fraction(),
    };
    let kappa_s_per_m = kept * KAPPA_PER_M;
    let (angles, unit) = table.angles(cloud, kept)?;
    let grid = ParameterGrid::new(&angles).map_err(|e| damaged(&e))?;
    let (unit, kappa_s, kappa_s_per_m) = (F::of(unit), F::of(kept), F::of(kappa_s_per_m));
    let halo = if reading == Reading::WithHalo { Some(of_cloud(cloud)?) } else { None };
    Ok(Bouthors { grid, unit, kappa_s, kappa_s_per_m, reading, phase, halo })
}

/// Where both the table and the forms hold.
fn domain(table: Table) -> Domain {
    let (tau, mu_l) = match table {
        Table::Published => (1.0, 0.1737),
        Table::Refitted | Table::Family => (0.047, 1e-4),
    };
    Domain {
        tau: Range::closed(tau, 1e4),
        mu_l: Range::closed(mu_l, 1.0),
        omega: Range::closed(1.0, 1.0),
        r_eff_um: table.radius_um(),
        ..Domain::EVERYWHERE
    }
}

/// Fluxes with the refitted table, where it was fitted, but for the lowest sun; the published one is off by 0.1 at low sun, and the printed forms more.
fn promise(table: Table, reading: Reading) -> Option<Promise> {
    let fitted =
        Domain { tau: Range::closed(0.047, 46.0), mu_l: Range::closed(0.1737, 1.0), ..domain(table) };
    (table == Table::Refitted && reading != Reading::Printed).then(|| Promise::absolute(0.05, fitted))
}

fn card(name: String, title: &'static str, (table, reading): (Table, Reading), texels: usize) -> Card {
    let halo = if reading == Reading::WithHalo { HaloTexels::<f32>::bytes() } else { 0 };
    Card {
        name,
        title,
        source: "Bouthors, Neyret & Lefebvre 2006, section 4 and appendices A and B",
        class: Class::Mixed,
        domain: domain(table),
        promises: Promises { radiance: None, flux: promise(table, reading) },
        radiance: true,
        flux: true,
        table_bytes: Some(2 * 4 * texels + PARAMETER_BYTES + halo),
    }
}

/// With these parameters, read in this way. Phase functions are exact in double precision and on [`EMITTED_TEXELS`] in single; with
/// `texels`, on that many in both.
pub(crate) fn method(
    (stem, texels): (&str, Option<usize>),
    title: &'static str,
    table: Table,
    reading: Reading,
) -> Simple {
    let name = texels.map_or(stem.to_owned(), |texels| format!("{stem}:{texels}"));
    let count = texels.unwrap_or(EMITTED_TEXELS);
    Simple::new(card(name, title, (table, reading), count), move |card, cloud| {
        let single = InSingle(prepare(table, reading, cloud, Texels::<f32>::twice(cloud, count)?)?);
        let card = card.clone();
        Ok(if texels.is_some() {
            let double = prepare::<f64, _>(table, reading, cloud, Texels::<f64>::twice(cloud, count)?)?;
            Box::new(Shaded { card, double, single })
        } else {
            let double = prepare::<f64, _>(table, reading, cloud, Exact::twice(cloud)?)?;
            Box::new(Shaded { card, double, single })
        })
    })
}

#[cfg(test)]
mod tests {
    use super::tables::{published, refitted};
    use super::*;

    /// Appendix A by hand at θ_l = 0, H = 100 m, with the row as printed: T_ms = (b + (1-b) e^-cH) β/(H - (H-1) β).
    #[test]
    fn the_published_table_gives_the_papers_transmittance() {
        let angles = published(0.49 * KAPPA_PER_M).unwrap();
        let grid = ParameterGrid::<f64>::new(&angles).unwrap();
        let fluxes = grid.at(1.0).unwrap().fluxes(Form::Corrected, Thickness::new(100.0).unwrap());
        let expected = (1.1796 - 0.1796 * libm::exp(-1.38)) * 0.9961 / (100.0 - 99.0 * 0.9961);
        assert!((fluxes.t_ms / expected - 1.0).abs() < 1e-12);
        assert!((KAPPA_PER_M - 0.04618).abs() < 5e-6, "{KAPPA_PER_M}");
    }

    /// I3+ alone: without phase functions the radiance of the isotropic shape is R_3+/(2μ_v), of the printed one half of it.
    #[test]
    fn emission_is_read_as_named() {
        struct Nothing;
        impl PhaseLookup<f64> for Nothing {
            fn full(&self, _v: f64) -> f64 {
                0.0
            }
            fn wide(&self, _v: f64) -> f64 {
                0.0
            }
            fn wide_squared(&self, _v: f64) -> f64 {
                0.0
            }
        }
        let grid = ParameterGrid::new(&refitted().unwrap()).unwrap();
        let model = |reading| Bouthors {
            grid: grid.clone(),
            unit: 1.0,
            kappa_s: 0.5,
            kappa_s_per_m: 0.02,
            reading,
            phase: Nothing,
            halo: None,
        };
        let sight = Sight::new(0.8, 0.4, 90.0, Side::Top).unwrap();
        let [isotropic, flat, printed] = [
            Reading::Corrected(Emission::Isotropic),
            Reading::Corrected(Emission::Lambertian),
            Reading::Printed,
        ]
        .map(|reading| model(reading).radiance(20.0, &sight));
        assert!((isotropic / flat - 1.0 / 0.8).abs() < 1e-12);
        assert!((isotropic / printed - 2.0).abs() < 1e-12, "reflection: the same R_3+ in both forms");
    }
}
