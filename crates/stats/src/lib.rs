//! Estimates with errors, hashed random streams, and every comparator the project trusts.
//!
//! A comparator is library code with tests of its own: it accepts equals, rejects an error planted just
//! above its threshold, and ignores what it must ignore. Statistical ones state their false-alarm rate.

mod chi_square;
mod estimate;
mod family;
mod kolmogorov;
mod kolmogorov_smirnov;
mod proportions;
mod stream;
mod z;

pub use chi_square::{ChiSquare, ChiSquareError, MIN_EXPECTED, chi_square, chi_square_two_sample};
pub use estimate::Estimate;
pub use family::holm;
pub use kolmogorov_smirnov::{
    KolmogorovSmirnov, KolmogorovSmirnovError, kolmogorov_smirnov, kolmogorov_smirnov_two_sample,
};
pub use proportions::{Hits, p_value_of_share, p_value_of_two};
pub use stream::{Purpose, key, photon_seed, photon_stream};
pub use z::{family_threshold, z_score};
