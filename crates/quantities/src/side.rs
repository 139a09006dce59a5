//! The two faces of a slab.

use serde::{Deserialize, Serialize};
use std::fmt;

/// The face of the slab that light leaves. Serialised as `"top"` or `"bottom"`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// The lit face: reflected light.
    Top,
    /// The other face: transmitted light.
    Bottom,
}

impl Side {
    /// Both, the lit one first.
    pub const BOTH: [Self; 2] = [Self::Top, Self::Bottom];
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Top => "top",
            Self::Bottom => "bottom",
        })
    }
}
