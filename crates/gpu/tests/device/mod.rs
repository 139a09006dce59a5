//! The device of the tests.

use std::io::Write as _;
use stratiform_gpu::{Gpu, GpuError};

/// The device; or, where there is none, a loud skip. With `STRATIFORM_REQUIRE_GPU=1` that is a failure.
pub fn device() -> Option<Gpu> {
    match Gpu::new() {
        Ok(gpu) => Some(gpu),
        Err(error @ GpuError::NoAdapter { .. }) if std::env::var_os("STRATIFORM_REQUIRE_GPU").is_none() => {
            // Past the test harness's capture: a skipped test must be seen.
            let _ = writeln!(std::io::stderr(), "SKIPPED (1): {error}");
            None
        }
        Err(error) => panic!("{error}"),
    }
}
