//! Estimates with errors, hashed random streams, and every comparator the project trusts.
//!
//! A comparator is library code with tests of its own: it accepts equals, rejects an error planted just
//! above its threshold, and ignores what it must ignore. Statistical ones state their false-alarm rate.

mod chi_square;
mod estimate;
mod proportions;
mod stream;
mod z;

pub use chi_square::{ChiSquare, ChiSquareError, MIN_EXPECTED, chi_square};
pub use estimate::Estimate;
pub use proportions::{Hits, p_value_of_share, p_value_of_two};
pub use stream::{Purpose, key, photon_stream};
pub use z::{family_threshold, z_score};
