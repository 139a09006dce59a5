//! Files that other renderers and solvers load, each with what that program will make of it.
//!
//! One module a program: its convention, units, and the version whose behaviour was checked stand in the module's docs.
//! Every writer is a pure function from [`PhaseTable`]s to a [`PeerFile`]; `scripts/peers-check.py` loads the files in the
//! programs themselves.
//!
//! [`PhaseTable`]: stratiform_optics::phase::PhaseTable

pub mod bevy;
mod cosine;
pub mod disort;
pub mod eradiate;
pub mod mcx;
pub mod mitsuba;
mod program;
mod tents;
mod text;
mod worth;

pub use program::{NamedFile, Program};

use crate::card::Card;

/// A file's content, and what its reader's own look-up of it is worth.
#[derive(Clone, Debug, PartialEq)]
pub struct PeerFile<T> {
    /// Text, bytes or texels.
    pub content: T,
    /// Values of each phase function; of the longest if they differ.
    pub values: usize,
    /// One for each phase function in it.
    pub cards: Vec<Card>,
}
