//! Radiance leaving a slab: order 1, order 2 and the total, as reflectance factors πL/(μ0F0).
//!
//! **Orders 1 and 2** are computed with the full phase function: a closed form (`single`) and an integral over the
//! intermediate direction whose depth part is closed (`double`, `depth`, `panels`).
//!
//! **The total** = orders 1 and 2 of a δ-M scaled medium, exact, with its P'' = (P-fδ)/(1-f), plus what discrete
//! ordinates with 2n moments give for orders 3 and above (`scaled`, `mode`, `response`, `series`). With order 1 alone
//! this is TMS of Nakajima & Tanaka (1988); order 2 brings in what small-angle events do to the glory and to the aureole,
//! which their IMS approximates forward only, and the kinks at the horizon. What remains is smooth: moments beyond 2n
//! enter only where three events in a row are narrow.
//!
//! Streams are added until results agree (`solver`); the error reported is the last change. Each azimuthal
//! mode is reduced to a symmetric eigenproblem (`eigen`). Units: τ of the full medium; φ in degrees. Domain: τ from
//! 0 to 1e6; μ0 and μ from 0 (a limit) to 1, not both 0; ω from 0 to 1. In the modified medium orders count wide
//! events. Errors: [`TransportError`](crate::TransportError).

mod depth;
mod double;
mod eigen;
mod legendre;
mod mode;
mod panels;
mod phase;
mod radiances;
mod response;
mod scaled;
mod series;
mod single;
mod solver;
mod view;

pub use radiances::Radiances;
pub use solver::RadianceSolver;
pub use view::{RadianceOrder, Side, View};
