//! What the eye is led to.

use serde::{Deserialize, Serialize};

/// An effect that a picture of the scene shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effect {
    /// Coloured rings round the point opposite the sun.
    Glory,
    /// The white bow, about 40° from that point.
    Fogbow,
    /// Thin cloud shining round the sun.
    SilverLining,
    /// Light between cloud and ground.
    GroundBounce,
}
