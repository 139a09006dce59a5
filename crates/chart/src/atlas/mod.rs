//! Where each method breaks: planes through a base point, every value put into a class.
//!
//! A [`Plane`] runs two inputs over all they can be; a [`Sheet`] adds its clouds and the deterministic solver's truth; [`sweep`] asks a
//! method for radiances on both faces and fluxes, in double precision and as a shader would, and judges each value ([`Class`]).
//! [`answered_outside`] steps over every end of the declared ranges. Errors: [`ChartError`](crate::ChartError).

mod class;
mod clouds;
mod edges;
mod plane;
mod rows;
mod sweep;
mod truth;

pub use class::{Case, Class, F32_SHARE};
pub use clouds::{BASE_RADIUS_UM, CloudAt, Phases};
pub use edges::answered_outside;
pub use plane::{Density, Input, Place, Plane};
pub use rows::{count, document, rows};
pub use sweep::{Cell, Precision, Sheet, sweep};
pub use truth::SHARE as LARGEST_TRUTH_ERROR;
