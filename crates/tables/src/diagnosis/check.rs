//! One thing looked at.

use serde::{Deserialize, Serialize};

/// What came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Within its bound.
    Ok,
    /// A fault.
    Wrong,
    /// Out of its bound because of another fault.
    Follows,
}

/// A named quantity, what it is, what it should be, and how far off it may be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Check {
    /// Name, as in the docs of [`diagnosis`](super).
    pub name: String,
    /// What came out.
    pub verdict: Verdict,
    /// The value found; none where it would be infinite.
    pub found: Option<f64>,
    /// The value expected.
    pub expected: Option<f64>,
    /// How far they may be apart, absolute.
    pub bound: Option<f64>,
    /// The fault that this one follows from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub follows_from: Option<String>,
    /// What is wrong, in words.
    pub words: String,
}

impl Check {
    /// A number against its bound.
    pub(super) fn number(
        name: &str,
        found: f64,
        expected: f64,
        bound: f64,
        words: impl Into<String>,
    ) -> Self {
        let ok = (found - expected).abs() <= bound;
        Self {
            name: name.to_owned(),
            verdict: if ok { Verdict::Ok } else { Verdict::Wrong },
            found: Some(found).filter(|found| found.is_finite()),
            expected: Some(expected),
            bound: Some(bound),
            follows_from: None,
            words: words.into(),
        }
    }

    /// Something that is so or is not.
    pub(super) fn plain(name: &str, ok: bool, words: impl Into<String>) -> Self {
        Self {
            name: name.to_owned(),
            verdict: if ok { Verdict::Ok } else { Verdict::Wrong },
            found: None,
            expected: None,
            bound: None,
            follows_from: None,
            words: words.into(),
        }
    }

    pub(super) fn is_wrong(&self) -> bool {
        self.verdict == Verdict::Wrong
    }

    /// A fault becomes a consequence of `cause`.
    pub(super) fn follow(&mut self, cause: &str) {
        if self.is_wrong() {
            self.verdict = Verdict::Follows;
            self.follows_from = Some(cause.to_owned());
        }
    }
}
