//! What a method says about itself.

use crate::{Cloud, FluxPoint, MethodError, Point, Promises};
use stratiform_quantities::Range;

/// Lighting techniques as Hufnagel & Held class them (*A survey of cloud lighting and rendering techniques*, 2012, section 4.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Class {
    /// 4.1.1: one scattering, or several forward ones.
    SingleScattering,
    /// 4.1.2: diffusion.
    Diffusion,
    /// 4.1.3: path tracing.
    PathTracing,
    /// 4.1.4: path integration.
    PathIntegration,
    /// 4.1.6: parts of different kinds added, as in Bouthors 2006.
    Mixed,
    /// 4.1.7: heuristics.
    Heuristic,
    /// Not in the survey: deterministic solution of the transfer equation.
    Deterministic,
}

/// Where a method claims to hold: outside it refuses.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// Optical thickness of the full medium.
    pub tau: Range,
    /// μ_l.
    pub mu_l: Range,
    /// μ_v.
    pub mu_v: Range,
    /// ω of the full medium.
    pub omega: Range,
    /// Effective radius, µm; checked only where the cloud says one.
    pub r_eff_um: Range,
}

impl Domain {
    /// Every slab and direction there is, μ above 0.
    pub const EVERYWHERE: Self = Self {
        tau: Range::closed(0.0, 1e6),
        mu_l: Range { min_included: false, ..Range::closed(0.0, 1.0) },
        mu_v: Range { min_included: false, ..Range::closed(0.0, 1.0) },
        omega: Range::closed(0.0, 1.0),
        r_eff_um: Range::above(0.0),
    };

    /// Checks the medium.
    ///
    /// # Errors
    /// [`MethodError::Domain`].
    pub fn check_cloud(&self, cloud: &Cloud) -> Result<(), MethodError> {
        self.omega.check("omega", cloud.omega().get())?;
        if let Some(r_eff_um) = cloud.r_eff_um() {
            self.r_eff_um.check("r_eff_um", r_eff_um)?;
        }
        Ok(())
    }

    /// Checks where a radiance is asked for.
    ///
    /// # Errors
    /// [`MethodError::Domain`].
    pub fn check(&self, point: &Point) -> Result<(), MethodError> {
        self.tau.check("tau", point.tau)?;
        self.mu_l.check("mu_l", point.mu_l)?;
        self.mu_v.check("mu_v", point.mu_v)?;
        Range::closed(-360.0, 360.0).check("phi_deg", point.phi_deg)?;
        Ok(())
    }

    /// Checks where a flux is asked for.
    ///
    /// # Errors
    /// [`MethodError::Domain`].
    pub fn check_flux(&self, point: &FluxPoint) -> Result<(), MethodError> {
        self.tau.check("tau", point.tau)?;
        self.mu_l.check("mu_l", point.mu_l)?;
        Ok(())
    }
}

/// Name, origin and claims of a method.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// Stable name for files and command lines, such as `octaves` or `bouthors-corrected`; with its knob `octaves:8`.
    pub name: String,
    /// For people.
    pub title: &'static str,
    /// Paper and equation, or file of an engine.
    pub source: &'static str,
    /// Its place in the survey.
    pub class: Class,
    /// Where it claims to hold.
    pub domain: Domain,
    /// How far from the truth it claims to be.
    pub promises: Promises,
    /// Whether it gives radiances.
    pub radiance: bool,
    /// Whether it gives fluxes.
    pub flux: bool,
    /// Bytes of tables that a shader of it needs for one cloud; `None` where it is no shader code.
    pub table_bytes: Option<usize>,
}

impl Card {
    /// Whether radiances are given.
    ///
    /// # Errors
    /// [`MethodError::NotGiven`].
    pub fn gives_radiance(&self) -> Result<(), MethodError> {
        self.gives(self.radiance, "radiance")
    }

    /// Whether fluxes are given.
    ///
    /// # Errors
    /// [`MethodError::NotGiven`].
    pub fn gives_flux(&self) -> Result<(), MethodError> {
        self.gives(self.flux, "flux")
    }

    fn gives(&self, given: bool, quantity: &'static str) -> Result<(), MethodError> {
        if given { Ok(()) } else { Err(MethodError::NotGiven { method: self.name.clone(), quantity }) }
    }

    /// What the solver or tracer inside said.
    pub(crate) fn failed(&self, reason: &dyn std::fmt::Display) -> MethodError {
        MethodError::Failed { method: self.name.clone(), reason: reason.to_string() }
    }
}
