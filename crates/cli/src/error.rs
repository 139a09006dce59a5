//! What the command can end with, and the exit code of each.

use stratiform_artifact::ArtifactError;
use stratiform_quantities::DomainError;

/// The ways a command fails.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// Bad input or usage: exit code 2, nothing on stdout, nothing written.
    #[error("{0}")]
    Input(String),
    /// A check failed, or a budget or tolerance could not be met: exit code 1.
    #[error("{0}")]
    Failed(String),
    /// A tolerance was not met: exit code 1, after what was reached has been printed.
    #[error("{message}")]
    Unmet {
        /// What was asked for and what was reached.
        message: String,
        /// What belongs on stdout all the same.
        data: String,
    },
    /// Ctrl-C or a termination signal: exit code 130, as shells expect.
    #[error("interrupted; no file was left half-written")]
    Interrupted,
}

impl CliError {
    /// Puts the place of the fault before the message.
    #[must_use]
    pub fn at(self, place: &str) -> Self {
        match self {
            Self::Input(message) => Self::Input(format!("{place}: {message}")),
            Self::Failed(message) => Self::Failed(format!("{place}: {message}")),
            other => other,
        }
    }

    /// The process's exit code.
    pub fn code(&self) -> u8 {
        match self {
            Self::Input(_) => 2,
            Self::Failed(_) | Self::Unmet { .. } => 1,
            Self::Interrupted => crate::interrupt::INTERRUPTED,
        }
    }
}

impl From<ArtifactError> for CliError {
    fn from(error: ArtifactError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<DomainError> for CliError {
    fn from(error: DomainError) -> Self {
        Self::Input(error.to_string())
    }
}
