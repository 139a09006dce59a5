//! Ctrl-C and termination signals.
//!
//! Work that looks at the flag between batches stops there and says so. Everything else, and a second signal, ends the
//! process at once, which is safe: files are written whole or not at all.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);
static WATCHES: AtomicUsize = AtomicUsize::new(0);

/// Exit code of a process that a signal ended, as shells expect.
pub const INTERRUPTED: u8 = 130;

/// Installs the handler. If another is installed already, that one applies.
pub fn install() {
    let _ = ctrlc::set_handler(|| {
        if REQUESTED.swap(true, Ordering::Relaxed) || WATCHES.load(Ordering::Relaxed) == 0 {
            end();
        }
    });
}

/// Ends the process.
#[expect(clippy::exit, reason = "nobody looks at the flag")]
pub fn end() -> ! {
    std::process::exit(i32::from(INTERRUPTED));
}

/// Says that the flag is looked at for as long as this lives.
pub struct Watch(());

/// Starts to look at the flag.
pub fn watch() -> Watch {
    WATCHES.fetch_add(1, Ordering::Relaxed);
    Watch(())
}

/// Whether somebody looks at the flag.
#[cfg(test)]
pub fn is_watched() -> bool {
    WATCHES.load(Ordering::Relaxed) > 0
}

impl Watch {
    /// The flag.
    pub fn flag(&self) -> &'static AtomicBool {
        &REQUESTED
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        WATCHES.fetch_sub(1, Ordering::Relaxed);
    }
}
