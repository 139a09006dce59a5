//! From reference fluxes to the parameters of the one-dimensional model.
//!
//! * [`least_squares`]: bounded Levenberg–Marquardt on [`argmin`], for any problem.
//! * [`fit`]: β, b, c from the totals of the full medium, κ_c, t, r from the orders of the modified one, at
//!   uniform absolute weight on the config's thickness grid. The weights do not follow the reference's noise,
//!   because the model is not the truth: where it fails, better data must not change what is fitted. The
//!   noise enters the errors only.
//! * [`compare`]: whether two fits agree within their errors.
//!
//! Thickness is optical thickness of the full medium throughout; the document carries metres beside it.

mod compare;
mod config;
mod consistency;
mod document;
mod error;
mod identifiable;
pub mod least_squares;
mod matrix;
mod multiple;
mod orders;
mod orders_fit;
mod qr;
mod radiance;
mod reference;
mod regression;
mod sandwich;
mod totals_fit;

pub use compare::{Comparison, Deviation, compare};
pub use config::{FitConfig, ParameterBounds, ThicknessGrid};
pub use consistency::{DerivedNumber, derived_numbers};
pub use document::{ALBEDO, fit};
pub use error::FitError;
pub use matrix::Matrix;
pub use radiance::{
    Draw, Drawn, RadianceConfig, RadianceDraw, RadiancePlan, RadiancePoint, SunViews, fit_radiance, misfit,
    radiance_coefficients,
};
pub use reference::{ORDERS, Reference};
pub use regression::{HeldParameter, ModelBounds, held_parameters};
