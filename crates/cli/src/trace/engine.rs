//! Whoever can trace photons of one incidence into a part.

use crate::{CliError, pipeline};
use stratiform_transport::{Control, Part, Share, TraceJob};

/// A tracer set up for one incidence.
pub trait Engine {
    /// A part of no photon.
    fn part(&self) -> Part;

    /// Traces those photons of `share` that `part` lacks; `keep` sees the part whenever more photons are in it.
    ///
    /// # Errors
    /// [`CliError::Interrupted`] if `control` asks to stop: the part is then sound all the same. Any other if the engine fails.
    fn trace(
        &self,
        part: &mut Part,
        share: Share,
        control: Control<'_>,
        keep: &mut (dyn FnMut(&Part) + Send),
    ) -> Result<(), CliError>;
}

impl Engine for TraceJob<'_> {
    fn part(&self) -> Part {
        self.part()
    }

    fn trace(
        &self,
        part: &mut Part,
        share: Share,
        control: Control<'_>,
        keep: &mut (dyn FnMut(&Part) + Send),
    ) -> Result<(), CliError> {
        self.trace(part, share, control, keep).map_err(pipeline::trace_error)
    }
}
