//! Constants instead of a table: g, P_f, κ, or the parameters of an analytic phase function.

use super::Check;
use super::bounds::EXTINCTION;
use super::compare::{asymmetry, forward_fraction};
use super::sampling::trapezoids;
use crate::TablesError;
use crate::nearest::Blend;
use serde::{Deserialize, Serialize};
use stratiform_optics::phase::{Norm, PhaseFunction, PhaseTable};
use stratiform_quantities::Range;

/// Constants that somebody uses. A blend, `henyey_greenstein` or `blend`, is looked at as a phase function, the others each
/// for itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Constants {
    /// g of a Henyey–Greenstein function.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub henyey_greenstein: Option<f64>,
    /// (1-w)·HG(g1) + w·Draine(g2, α).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub blend: Option<Blend>,
    /// g, of whatever phase function.
    #[serde(default, alias = "g", skip_serializing_if = "Option::is_none")]
    pub asymmetry: Option<f64>,
    /// P_f.
    #[serde(default, alias = "P_f", skip_serializing_if = "Option::is_none")]
    pub forward_fraction: Option<f64>,
    /// κ, 1/m.
    #[serde(default, alias = "kappa", skip_serializing_if = "Option::is_none")]
    pub extinction_per_m: Option<f64>,
}

/// What Mie theory says of the droplets.
#[derive(Clone, Copy, Debug)]
pub struct Known<'a> {
    /// P.
    pub phase: &'a PhaseTable,
    /// κ, 1/m: N0 π r_e², and N0 ⟨Q_ext π r²⟩; absent without N0.
    pub extinction_per_m: Option<[f64; 2]>,
}

impl Constants {
    /// The phase function, if the constants are one's.
    ///
    /// # Errors
    /// [`TablesError`] if both kinds are given.
    pub fn phase(&self) -> Result<Option<Blend>, TablesError> {
        match (self.henyey_greenstein, self.blend) {
            (Some(g), None) => Ok(Some(Blend::henyey_greenstein(g))),
            (None, blend) => Ok(blend),
            (Some(_), Some(_)) => Err(TablesError::Container {
                format: "constants",
                reason: "henyey_greenstein and blend are both given: which is meant?".to_owned(),
            }),
        }
    }

    /// Whether there is a constant that is no phase function.
    pub fn has_single(&self) -> bool {
        self.asymmetry.is_some() || self.forward_fraction.is_some() || self.extinction_per_m.is_some()
    }

    /// Whether there is nothing to look at.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// Looks at the constants that are no phase function.
///
/// # Errors
/// [`TablesError`] if one is out of its domain.
pub fn check_constants(
    constants: &Constants,
    known: &Known<'_>,
    theta_f_deg: f64,
) -> Result<Vec<Check>, TablesError> {
    let mut checks = Vec::new();
    if let Some(g) = constants.asymmetry {
        checks.push(asymmetry(Range::closed(-1.0, 1.0).check("asymmetry", g)?, known.phase.asymmetry()));
    }
    if let Some(share) = constants.forward_fraction {
        let share = Range::closed(0.0, 1.0).check("forward_fraction", share)?;
        let mut check = forward_fraction(share, known.phase.forward_fraction(theta_f_deg)?);
        if check.is_wrong() {
            check.words.push_str(&coarse_hint(known.phase, theta_f_deg)?);
        }
        checks.push(check);
    }
    if let Some(kappa) = constants.extinction_per_m {
        let kappa = Range::above(0.0).check("extinction_per_m", kappa)?;
        checks.extend(known.extinction_per_m.map(|both| extinction(kappa, both)));
    }
    Ok(checks)
}

/// What a table of one-degree steps makes of P_f.
fn coarse_hint(mie: &PhaseTable, theta_f_deg: f64) -> Result<String, TablesError> {
    let degrees: Vec<f64> = (0..=180).map(f64::from).collect();
    let p = degrees.iter().map(|t| mie.at(t.to_radians())).collect();
    let table = PhaseTable::new(degrees, p, Norm::Any)?;
    let share = trapezoids(&table, theta_f_deg) / trapezoids(&table, 180.0);
    Ok(format!("; a table in 1-degree steps, trapezoids in the cosine, gives {share:.3}"))
}

/// Both conventions are in use: the one that κ follows is named.
fn extinction(kappa: f64, [paper, mie]: [f64; 2]) -> Check {
    let near = |truth: f64| (kappa / truth - 1.0).abs() <= EXTINCTION;
    let (truth, words) = if near(mie) {
        (mie, "1/m, as N0 <Q_ext pi r^2>, the physical extinction".to_owned())
    } else if near(paper) {
        (paper, format!("1/m, as N0 pi r_e^2; the physical extinction N0 <Q_ext pi r^2> is {mie:.4}"))
    } else {
        (mie, format!("1/m, neither N0 <Q_ext pi r^2> = {mie:.4} nor N0 pi r_e^2 = {paper:.4}"))
    };
    Check::number("extinction", kappa, truth, EXTINCTION * truth, words)
}
