//! What is refused.

use stratiform_artifact::ArtifactError;
use stratiform_quantities::DomainError;

/// Why there is no advice.
#[derive(Debug, thiserror::Error)]
pub enum AdviseError {
    /// The data cannot be read.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// A budget, or a scene beyond what the data cover.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A budget that is no number.
    #[error("`{text}` is no error: give a share such as 0.02 or a percentage such as 2%")]
    Share {
        /// What was typed.
        text: String,
    },
    /// Neither error nor cost is limited.
    #[error("no budget: give --max-error or --max-ns")]
    NoBudget,
    /// Data without a lattice that is needed.
    #[error("the error data have no rows of {block}")]
    Missing {
        /// The block.
        block: String,
    },
}
