//! What the device refuses comes back as an error, not as a crash.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod device;

use stratiform_gpu::GpuError;

const COPY: &str = "
@group(0) @binding(0) var<storage, read> source: array<u32>;
@group(0) @binding(1) var<storage, read_write> copied: array<u32>;
@compute @workgroup_size(1)
fn copy(@builtin(global_invocation_id) id: vec3<u32>) { copied[id.x] = source[id.x]; }
";

#[test]
fn bytes_come_back_and_what_is_not_written_is_zero() {
    let Some(gpu) = device::device() else { return };
    let output = gpu.run(COPY, "copy", &[&[1, 2, 3, 4, 5, 6, 7, 8]], 12, [2, 1, 1]).unwrap();
    assert_eq!(output, [1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 0, 0]);
}

#[test]
fn bad_shaders_entries_and_sizes_are_errors() {
    let Some(gpu) = device::device() else { return };
    let refused = |wgsl: &str, entry: &str| gpu.run(wgsl, entry, &[&[0; 4]], 4, [1, 1, 1]).unwrap_err();
    assert!(matches!(refused("fn copy( {", "copy"), GpuError::Refused { .. }));
    assert!(matches!(refused(COPY, "paste"), GpuError::Refused { .. }));
    let size = gpu.run(COPY, "copy", &[&[0; 4]], 6, [1, 1, 1]).unwrap_err();
    assert_eq!(size, GpuError::BufferSize { binding: 1, bytes: 6 });
    assert!(gpu.run(COPY, "copy", &[&[9; 4]], 4, [1, 1, 1]).is_ok(), "the device stays usable");
}
