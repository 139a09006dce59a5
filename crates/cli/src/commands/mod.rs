//! One file per command: from what was typed to what is printed.

pub mod advise;
pub mod atlas;
pub mod chart;
pub mod check;
pub mod codegen;
pub mod compare;
pub mod errors;
pub mod export;
pub mod merge;
pub mod mie;
pub mod nearest;
pub mod optics;
pub mod order_rows;
pub mod phase_check;
pub mod picture;
pub mod radiance;
pub mod render;
pub mod report;
pub mod shell;
pub mod solve;
pub mod stages;
pub mod trace;
mod traced_radiance;
pub mod truth;
pub mod view;
mod views;
