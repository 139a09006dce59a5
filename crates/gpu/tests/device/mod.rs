//! The device of the tests.

use std::io::Write as _;
use std::sync::atomic::{AtomicUsize, Ordering};

static SKIPPED: AtomicUsize = AtomicUsize::new(0);
use stratiform_gpu::{Gpu, GpuError};

/// The device; or, where there is none, a loud skip. With `STRATIFORM_REQUIRE_GPU=1` that is a failure.
pub fn device() -> Option<Gpu> {
    match Gpu::new() {
        Ok(gpu) => Some(gpu),
        Err(error @ GpuError::NoAdapter { .. }) if std::env::var_os("STRATIFORM_REQUIRE_GPU").is_none() => {
            let count = SKIPPED.fetch_add(1, Ordering::Relaxed) + 1;
            // Past the test harness's capture: a skipped test must be seen.
            let _ = std::io::stderr().write_all(format!("SKIPPED ({count}): {error}\n").as_bytes());
            None
        }
        Err(error) => panic!("{error}"),
    }
}
