//! The nearest analytic phase functions, with their measured error.
//!
//! All have one form, P = (1-w)·HG(g1) + w·Draine(g2, α): a Henyey–Greenstein function (w = 0), two of them (α = 0), and
//! Henyey–Greenstein with Draine's function (J. Jendersie, E. d'Eon, An Approximate Mie Scattering Function for Fog and Cloud
//! Rendering, SIGGRAPH Talks 2023), whose w_D, g_HG, g_D, α are w, g1, g2, α here.
//!
//! There is no one nearest function. Two objectives are offered, and every result states both and what it does to g, to P_f and to
//! what is seen:
//! * [`Objective::Scattered`], the total variation ¼∫|P-Q| dcosΘ: the share of scattered light sent into a wrong direction.
//!   It has no weights to choose and bounds the error of any single scattering; the forward peak, half of the light, dominates it.
//! * [`Objective::Seen`], the root mean square of ln(Q/P) over the sphere: least squares of the logarithm weighted by solid angle.
//!   A relative error counts the same everywhere, so that it fits what an eye sees in sky directions; the peak, a few
//!   thousandths of the sphere, is given away.
//!
//! Besides there is the function with the cloud's own g, which keeps the reflectance of thick layers, and as a rival Jendersie and
//! d'Eon's closed form in the droplet diameter.

mod blend;
mod closed_form;
mod document;
mod measure;
mod search;

pub use blend::{Blend, BlendPhase};
pub use closed_form::{DIAMETER_UM, jendersie_deon, nearest_diameter};
pub use document::{NearestDocument, NearestPhases, NearestRow};
pub use measure::{Measured, measure};
pub use search::{Family, Objective, fit};

use crate::TablesError;
use stratiform_optics::phase::{PhaseFunction, PhaseTable};

/// Every approximation of `table`, measured. θ_f is that of P_f. The closed form stands there with the diameter that suits
/// `table` best, and with `diameter_um`.
///
/// # Errors
/// [`TablesError`] if `theta_f_deg` or `diameter_um` is out of domain.
pub fn nearest(
    table: &PhaseTable,
    theta_f_deg: f64,
    diameter_um: Option<f64>,
) -> Result<NearestPhases, TablesError> {
    let row = |family: Family, by: &str, diameter: Option<f64>, blend: Blend| {
        let measured = measure(table, blend, theta_f_deg)?;
        Ok(NearestRow::new(family.name(), by, diameter, blend, &measured))
    };
    let by_g = Blend::henyey_greenstein(table.asymmetry());
    let mut rows = vec![row(Family::HenyeyGreenstein, "asymmetry", None, by_g)];
    for family in [Family::HenyeyGreenstein, Family::TwoLobe, Family::HgDraine] {
        for objective in [Objective::Scattered, Objective::Seen] {
            rows.push(row(family, objective.name(), None, fit(table, family, objective)?));
        }
    }
    let best = nearest_diameter(table, Objective::Scattered)?;
    for diameter in std::iter::once(best).chain(diameter_um) {
        let blend = jendersie_deon(diameter)?;
        rows.push(row(Family::HgDraine, "jendersie-deon-2023", Some(diameter), blend));
    }
    let rows = rows.into_iter().collect::<Result<_, TablesError>>()?;
    Ok(NearestPhases { theta_f_deg, rows })
}
