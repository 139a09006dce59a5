//! `angular-books.csv`: what the radiance of the angular model integrates to, against the fluxes that it should.

use serde::{Deserialize, Serialize};
use stratiform_quantities::{Order, Side};

/// How a radiance of the angular model is written down.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AngularForm {
    /// Corrected; of orders 3 and up, Lambertian.
    Corrected,
    /// Orders 3 and up evenly from every depth: μ_l/(2πμ_v).
    Isotropic,
    /// Orders 3 and up with the escape function of thick slabs.
    Escape,
    /// As printed, κ_S in 1/m.
    AsPrinted,
    /// As printed, but for powers of κ_S left out and 1/4π put in.
    AsPrintedPerUnit,
}

/// One integral over one face's hemisphere: a row of `angular-books.csv`. Fluxes per incident flux, of the modified medium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AngularBooksRow {
    /// θ_l in degrees.
    pub theta_l_deg: f64,
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// The face the light leaves.
    pub side: Side,
    /// 1, 2 or `tail` (3 and up).
    pub order: Order,
    /// How the radiance is written down.
    pub form: AngularForm,
    /// ∫L μ_v dΩ/(μ_l F0).
    pub integral: f64,
    /// R_n or T_n of the 1-D model.
    pub one_dimensional_model: f64,
    /// R_n or T_n of the solver.
    pub solver: f64,
}
