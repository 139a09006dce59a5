//! Single scattering exactly, everything beyond it as one fitted exponential.
//!
//! `stratiform_model::radiance`: I = I1 + D exp(Σ c_k(u) B_k), coefficients as accepted, g, P_f and P_S of the cloud. No fluxes.
//! Domain: ω = 1 and r_e from 4 to 20 µm, fitted at 7 µm and held against the others; every thickness and direction, of which τ from
//! 0.1 to 300 and θ up to 85° were fitted. `fitted` leaves out light that met forward events only, `fitted-halo` adds it
//! (`model::angular::halo`). Hufnagel & Held's class: mixed (4.1.6).

use crate::halo::{HaloTexels, of_cloud};
use crate::lookup::{EMITTED_TEXELS, Exact, Texels};
use crate::promise::region;
use crate::scalar::Scalar;
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, MethodError, Promise, Promises};
use stratiform_artifact::{RadianceFace, RadianceParametersDocument};
use stratiform_model::angular::halo::{Halo, Peak};
use stratiform_model::angular::{Angular, PhaseLookup, Sight};
use stratiform_model::radiance::{Coefficients, POWERS, Slab, TERMS};
use stratiform_quantities::{Range, Side};

const ACCEPTED: &str = include_str!("../../../../fit-configs/appendix-b/accepted/radiance_parameters.json");

const OMEGA: Range = Range::closed(1.0, 1.0);
/// The radii at which it was held against the solver.
const R_EFF_UM: Range = Range::closed(4.0, 20.0);

struct Fitted<F, P> {
    coefficients: Coefficients<F>,
    phase: P,
    halo: Option<(Peak<F>, HaloTexels<F>)>,
}

impl<F: Scalar, P: PhaseLookup<F> + Send + Sync> Shade<F> for Fitted<F, P> {
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F {
        let scattered = Slab::unchecked(&self.coefficients, tau, *sight).radiance(&self.phase);
        let Some((peak, shape)) = &self.halo else { return scattered };
        let slab = Angular::unchecked(self.coefficients.kept * tau, *sight);
        scattered + Halo::new(&slab, tau, *peak).total(&self.phase, shape)
    }

    fn fluxes(&self, _tau: F, _mu_l: F) -> (F, F) {
        (F::of(0.0), F::of(0.0))
    }
}

fn damaged(reason: &str) -> MethodError {
    MethodError::Failed { method: "fitted".to_owned(), reason: format!("built-in coefficients: {reason}") }
}

/// a_kj of a face.
fn face(faces: &[RadianceFace], side: Side) -> Result<[[f64; TERMS]; POWERS], MethodError> {
    let found = faces.iter().find(|face| face.side == side).ok_or_else(|| damaged("a face is missing"))?;
    let row = |row: &Vec<_>| row.iter().map(|a: &stratiform_stats::Estimate| a.value).collect::<Vec<f64>>();
    let rows = found.coefficients.iter().map(|terms| row(terms).try_into());
    let rows = rows.collect::<Result<Vec<[f64; TERMS]>, _>>().map_err(|_| damaged("number of terms"))?;
    rows.try_into().map_err(|_| damaged("number of powers"))
}

/// The accepted coefficients, with g and P_f of `cloud`.
fn coefficients(cloud: &Cloud) -> Result<Coefficients<f64>, MethodError> {
    let document: RadianceParametersDocument =
        serde_json::from_str(ACCEPTED).map_err(|e| damaged(&e.to_string()))?;
    let (similarity, kept) = (1.0 - cloud.asymmetry(), 1.0 - cloud.forward_fraction());
    let (top, bottom) = (face(&document.faces, Side::Top)?, face(&document.faces, Side::Bottom)?);
    let coefficients = Coefficients { similarity, kept, top, bottom };
    coefficients.check()?;
    Ok(coefficients)
}

/// Where it was fitted and held against other points, but for the aureole.
fn promise() -> Promise {
    let within = Domain { omega: OMEGA, r_eff_um: R_EFF_UM, ..region([1e-3, 1e4], 0.1736) };
    Promise::relative(0.25, within).outside_aureole(6.0)
}

/// With the accepted coefficients, with or without the halo. The phase function is exact in double precision and on
/// [`EMITTED_TEXELS`] in single; with `texels`, on that many in both.
pub(crate) fn method(with_halo: bool, texels: Option<usize>) -> Simple {
    let (stem, title) = match with_halo {
        false => ("fitted", "Fitted radiance"),
        true => ("fitted-halo", "Fitted radiance, with the halo"),
    };
    let count = texels.unwrap_or(EMITTED_TEXELS);
    let halo_bytes = if with_halo { HaloTexels::<f32>::bytes() } else { 0 };
    let card = Card {
        name: texels.map_or(stem.to_owned(), |texels| format!("{stem}:{texels}")),
        title,
        source: "This project: stratiform_model::radiance, after Nakajima & Tanaka 1988 and van de Hulst 1980",
        class: Class::Mixed,
        domain: Domain { omega: OMEGA, r_eff_um: R_EFF_UM, ..Domain::EVERYWHERE },
        promises: Promises { radiance: texels.is_none().then(promise), flux: None },
        radiance: true,
        flux: false,
        table_bytes: Some(4 * count + 2 * 4 * TERMS * POWERS + halo_bytes),
    };
    Simple::new(card, move |card, cloud| {
        let (card, coefficients) = (card.clone(), coefficients(cloud)?);
        let phase = Texels::<f32>::once(cloud, count)?;
        let halo = if with_halo { Some(of_cloud(cloud)?) } else { None };
        let single = InSingle(Fitted { coefficients: coefficients.cast::<f32>(), phase, halo });
        let halo = if with_halo { Some(of_cloud(cloud)?) } else { None };
        Ok(if texels.is_some() {
            let phase = Texels::<f64>::once(cloud, count)?;
            Box::new(Shaded { card, double: Fitted { coefficients, phase, halo }, single })
        } else {
            let double = Fitted { coefficients, phase: Exact::once(cloud), halo };
            Box::new(Shaded { card, double, single })
        })
    })
}
