//! The picture of a world in real time: compute passes around the committed generated text.

pub mod radiosity;
mod settings;

pub use settings::{Contributions, Model, Radiosity, RingRule, Settings};
