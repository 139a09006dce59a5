//! Error against cost of every method, over scenes; and the atlas of where each breaks.

pub mod errors;
