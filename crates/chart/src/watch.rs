//! How a caller watches and stops a chart.

use crate::ChartError;
use std::sync::atomic::{AtomicBool, Ordering};

/// Hooks into a chart.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Is called after each cloud solved and each method assessed.
    pub progress: &'a (dyn Fn() + Sync),
    /// Set to true to stop.
    pub cancel: &'a AtomicBool,
}

impl Watch<'_> {
    /// Does `step` unless told to stop, and says so.
    ///
    /// # Errors
    /// [`ChartError::Cancelled`], or those of `step`.
    pub fn over<T>(&self, step: impl FnOnce() -> Result<T, ChartError>) -> Result<T, ChartError> {
        if self.cancel.load(Ordering::Relaxed) {
            return Err(ChartError::Cancelled);
        }
        let done = step()?;
        (self.progress)();
        Ok(done)
    }
}
