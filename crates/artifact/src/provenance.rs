//! Where an artifact comes from.

use serde::{Deserialize, Serialize};

/// Stands in every artifact.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Program name, `stratiform`.
    pub program: String,
    /// Program version.
    pub version: String,
    /// Hash of every input that the numbers depend on (not of thread counts or paths).
    pub config_hash: String,
    /// Seed of the random streams; absent where nothing is random.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// What made the numbers, e.g. `half-space Monte Carlo`, and what `std_error` means there.
    pub method: String,
}

impl Provenance {
    /// Provenance of this program's version.
    pub fn new(config_hash: String, seed: Option<u64>, method: &str) -> Self {
        Self {
            program: "stratiform".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            config_hash,
            seed,
            method: method.to_owned(),
        }
    }

    /// What the numbers' `std_error` is: one standard deviation where something is random, otherwise an estimate of the
    /// largest error.
    pub fn error_name(&self) -> &'static str {
        if self.is_random() { "standard error" } else { "estimated error" }
    }

    /// Whether random numbers were used.
    pub fn is_random(&self) -> bool {
        self.seed.is_some()
    }
}
