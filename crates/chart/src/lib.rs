//! Error against cost of every method, over scenes.
//!
//! [`Sample::of_scene`] lays a grid over a scene's ranges ([`grid`]), gets the clouds' phase functions from the disk cache
//! ([`clouds`]) and the truth from the deterministic solver on the full medium ([`truth`]). [`chart`] holds every method against
//! it: [`Statistics`] of the relative error, nanoseconds per evaluation ([`cost`]), and the [`front`] of what nothing else beats.
//! [`atlas`] shows where each one breaks. [`knobs()`] does the same for one method as its knob turns; [`errors`] makes the data of
//! the adviser. Errors: [`ChartError`].

mod assess;
pub mod atlas;
pub mod clouds;
pub mod cost;
mod error;
pub mod errors;
pub mod front;
pub mod grid;
mod knobs;
mod parallel;
mod quantity;
mod rows;
mod sample;
mod statistics;
pub mod truth;
mod watch;

pub use assess::{Assessment, assess};
pub use error::ChartError;
pub use knobs::{Knob, KnobSetting, knobs};
pub use quantity::Quantity;
pub use rows::{chart, document};
pub use sample::{CloudSample, Sample, Source};
pub use statistics::Statistics;
pub use watch::Watch;
