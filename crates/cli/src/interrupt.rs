//! Ctrl-C and termination signals set a flag that long work looks at between batches.

use std::sync::atomic::{AtomicBool, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);

/// Installs the handler. Without one (if another is installed already) the default applies, which ends the
/// process at once: files are written atomically, so that is safe too.
pub fn install() {
    let _ = ctrlc::set_handler(|| REQUESTED.store(true, Ordering::Relaxed));
}

/// The flag.
pub fn flag() -> &'static AtomicBool {
    &REQUESTED
}
