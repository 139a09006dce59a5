//! The truth of a picture: paths of light through the height field, traced backwards from the camera, with an error for every pixel.
//!
//! **Paths.** Free paths are exponential in the exact length within the cloud (`layer`: no majorant), events are sampled from the full
//! phase function. An event is wide if Θ ≥ θ_f, else forward. Sky and ground are met where paths get to them: no weights but those of
//! colour. Absorption and the ground's share are Russian roulette; there is no cut.
//!
//! **Sunlight** (`sunlight`) is a beam that paths cannot meet by chance: each wide event and each touch of the ground asks how much of it
//! arrives. P up to 4000 would make this useless, so the last leg carries all its forward events at once: light arrives as
//! e^{-κ(1-ωP_f)l}, turned m times by P_F, m Poisson of mean ωκP_f l. Every path with a wide event or the ground is counted once, by the
//! last of them; the only neglect is sideways displacement on the last leg (3e-4 of a free path). Light without any (`halo`) is the
//! small-angle sum along the camera's ray bent to the sun at one event. Paths never collect the sun where they leave.
//!
//! **Colour** (`phases`). One channel per path is sampled; the three share it by the balance heuristic (Veach & Guibas 1995): a
//! channel's weight is Π P_c over the mean of the three products, at most 3.
//!
//! Units: metres; linear sRGB radiance in units of the sun's irradiance. Domain: sun above the horizon, camera above the ground, θ_f in
//! (0, 90)°, ω in \[0, 1\]. Errors: [`PathtraceError`]. The same seed gives the same bytes for any number of threads.

mod carrier;
#[cfg(test)]
mod energy;
mod error;
mod halo;
mod layer;
mod light;
mod path;
mod phases;
mod random;
mod request;
mod scene;
mod sunlight;
mod tally;
mod trace;
mod truth;

pub use error::PathtraceError;
pub use request::{Crop, Request, Stop};
pub use trace::trace;
pub use truth::Truth;
