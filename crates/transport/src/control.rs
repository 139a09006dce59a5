//! How a caller watches and stops a running trace.

use std::sync::atomic::{AtomicBool, Ordering};

/// Is told how far a trace has come. Called from worker threads, in no particular order.
pub trait Progress: Sync {
    /// `done` photons of at most `total` are traced.
    fn advanced(&self, done: u64, total: u64);
}

impl<F: Fn(u64, u64) + Sync> Progress for F {
    fn advanced(&self, done: u64, total: u64) {
        self(done, total);
    }
}

/// Hooks into a trace; the default has none.
#[derive(Clone, Copy, Default)]
pub struct Control<'a> {
    /// Whom to tell about progress.
    pub progress: Option<&'a dyn Progress>,
    /// Set to true to stop: the trace then returns [`Cancelled`](crate::TransportError::Cancelled).
    pub cancel: Option<&'a AtomicBool>,
}

impl Control<'_> {
    pub(crate) fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    pub(crate) fn advanced(&self, done: u64, total: u64) {
        if let Some(progress) = self.progress {
            progress.advanced(done, total);
        }
    }
}
