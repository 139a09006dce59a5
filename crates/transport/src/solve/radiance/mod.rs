//! Radiance leaving a slab: order 1, order 2 and the total, as reflectance factors πL/(μ0F0).
//!
//! **Orders 1 and 2** are computed with the full phase function: a closed form (`single`) and an integral over the
//! intermediate direction whose depth part is closed (`double`, `depth`, `panels`).
//!
//! **The total** is that of a δ-M scaled medium (`scaled`): its orders 1 and 2, exact, with P'' = (P-fδ)/(1-f); discrete
//! ordinates for orders 3 and above of the L moments kept (`mode`, `response`, `series`); and, in the limit of small angles, all
//! further orders of the moments left out (`narrow`). With order 1 alone this is TMS of Nakajima & Tanaka (1988). Order 2
//! brings in what one narrow event does to glory and aureole, `narrow` what more of them do.
//!
//! Streams are added until results agree (`solver`); the error reported is what convergence like 1/n, which the horizon
//! and the aureole have at worst, would leave after the last change, and a half more. Each azimuthal
//! mode is reduced to a symmetric eigenproblem (`eigen`). Units: τ of the full medium; φ in degrees. Domain: τ from
//! 0 to 1e6; μ0 and μ from 0 (a limit) to 1, not both 0; ω from 0 to 1. In the modified medium orders count wide
//! events. Errors: [`TransportError`](crate::TransportError).

mod climb;
mod depth;
mod double;
mod eigen;
mod elementary;
mod interpolant;
mod legendre;
mod mode;
mod narrow;
mod panels;
mod paths;
mod phase;
mod places;
mod radiances;
mod response;
mod scaled;
mod second;
mod series;
mod series_table;
mod single;
mod solver;
mod view;

pub use radiances::Radiances;
pub use solver::RadianceSolver;
pub use view::{RadianceOrder, View};
