//! What is wrong with a phase table or with constants, as named checks with their bounds.
//!
//! Told by the table alone: `angle-unit` (header against range), `angle-sign` (forward at 180°), `normalisation` (which convention
//! the integral means), `sampling`, `integral`. Told by Mie's phase function of the stated droplets: `forward-peak`,
//! `forward-fraction`, `asymmetry`, `wide-shape`, `fogbow-angle`, `fogbow-contrast`, `glory`. [`bounds`] says how much of each is
//! wrong, and why so much.
//!
//! One fault shows in many numbers. A check that fails only because another fault does is `follows`, not `wrong`: after
//! unit, sign and convention have been undone, what Mie's own P shows when tabulated at the same rows follows from
//! `sampling`; with a wrong peak and a right shape beyond θ_f, integral, P_f and g follow from `forward-peak`; with a wrong shape
//! beyond θ_f, g follows from that, or from P_f.

pub mod bounds;
mod check;
mod compare;
mod constants;
pub mod landmarks;
pub mod sampling;
mod table;

pub use check::{Check, Verdict};
pub use constants::{Constants, Known, check_constants};
pub use table::{Diagnosis, Question, TableFacts, diagnose, tabulated};
