//! What is wrong with a phase table or with constants.

pub mod landmarks;
