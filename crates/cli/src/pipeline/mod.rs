//! The chain: optics; then side by side witness, colour, and all that needs neither: radiance, reference and fit; family; principal
//! plane, codegen, angular books. After these agreement and ladder; convergence and quadrature, which measure time, alone; notes,
//! report. Each stage leaves files and is skipped while its inputs are unchanged.

pub mod accepted;
mod agreement;
pub mod angular_books;
pub mod colour;
mod convergence;
mod curves;
pub mod cut;
pub mod export;
pub mod family;
pub mod fluxes;
pub mod halo;
pub mod hemisphere;
pub mod ladder;
mod notes;
pub mod optics;
pub mod photons;
mod principal_plane;
mod published;
mod quadrature;
pub mod radiance;
pub mod reference;
mod run;
pub mod solved;
mod solver_cost;
pub mod source;
mod stage;
mod table;
pub mod visible;

pub use agreement::read as read_agreement;
pub use run::{Target, provenance, run};
pub use table::parameter_table;

use crate::CliError;
use crate::interrupt::Watch;
use stratiform_artifact::hash_of;
use stratiform_quantities::{Incidence, Medium};
use stratiform_transport::{Control, Progress, TransportError};

/// Any error that means bad input.
pub fn input_error(error: impl std::fmt::Display) -> CliError {
    CliError::Input(error.to_string())
}

/// A tracer's error.
pub fn trace_error(error: TransportError) -> CliError {
    match error {
        TransportError::Cancelled => CliError::Interrupted,
        TransportError::Books { .. } | TransportError::Tolerance { .. } | TransportError::Rule { .. } => {
            CliError::Failed(error.to_string())
        }
        other => input_error(other),
    }
}

/// Watches a trace, and stops it when the user asks to.
pub fn control<'a>(progress: &'a dyn Progress, watch: &Watch) -> Control<'a> {
    Control { progress: Some(progress), cancel: Some(watch.flag()) }
}

/// The number that keeps the photons of one incidence and medium apart from all others: a hash of both, so that it
/// does not depend on what else is traced.
pub fn stream_of(incidence: Incidence, medium: Medium) -> u32 {
    stream_of_hash(&hash_of(&(incidence, medium)))
}

/// A stream's number from the first digits of a hash.
pub fn stream_of_hash(hash: &str) -> u32 {
    hash.bytes().take(8).fold(0, |word, digit| (word << 4) | (char::from(digit).to_digit(16).unwrap_or(0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_tell_incidences_and_media_apart() {
        let beam = |mu| Incidence::beam(mu).unwrap();
        let all = [
            stream_of(beam(1.0), Medium::Full),
            stream_of(beam(1.0), Medium::Modified),
            stream_of(beam(0.5), Medium::Full),
            stream_of(Incidence::Diffuse, Medium::Full),
        ];
        for (i, a) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|b| a != b));
        }
    }
}
