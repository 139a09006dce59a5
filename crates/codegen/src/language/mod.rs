//! Every target language from one text.
//!
//! The library is written once, in WGSL, in the subset below, and printed in the other languages by a small printer of
//! our own. naga would do it too, but it drops comments, renames what ends in a digit or collides, folds constants,
//! rewrites `for` as `while(true)` and needs an entry point for GLSL; emitted text is meant to be read and pasted. The
//! SPIR-V of the self-test kernel, which nobody reads, is naga's.
//!
//! The subset: `const`, `struct`, `fn` with a result; f32, u32, bool and structures of them; `let`, `var`, assignment,
//! `if`, `for` over a counter, `switch` whose cases return, `return`; calls of functions written above and of a few
//! built-ins; a structure's constructor only as a whole `return` or `let`; comments on lines of their own. Comments
//! directly above an item are its documentation. Names carry the prefix `stratiform` outside functions, are none that a
//! target reserves, and shadow nothing. What is outside it is a [`SubsetError`], not a guess.

mod c_family;
mod layout;
mod parse;
mod reserved;
mod rust;
mod scope;
mod syntax;
mod target;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may stop where it fails")]
mod tests;
mod token;

pub use target::Target;
pub(crate) use target::{Glue, Library, translate};

/// Library text that is outside the subset.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line} of the library: {message}")]
pub struct SubsetError {
    /// Line of the WGSL text, from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
}

impl SubsetError {
    fn new(line: usize, message: String) -> Self {
        Self { line, message }
    }
}
