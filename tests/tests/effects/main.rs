//! The effects of the paper in the pictures of their scenes: each has its place or strength as a closed form or the solver says, and is
//! gone when what makes it is switched off.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]
#![allow(clippy::print_stdout, reason = "the figures, with --nocapture")]

#[path = "../../../crates/gpu/tests/device/mod.rs"]
mod device;

mod fogbow;
mod glory;
mod ground_light;
mod pseudo_specular;
mod silver_lining;
mod sun_disc;
