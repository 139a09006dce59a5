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

fn spirv(wgsl: &str) -> Vec<u32> {
    let module = naga::front::wgsl::parse_str(wgsl).unwrap();
    let info =
        naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty())
            .validate(&module)
            .unwrap();
    let options = naga::back::spv::Options::default();
    naga::back::spv::write_vec(&module, &info, &options, None).unwrap()
}

#[test]
#[allow(unsafe_code, reason = "the modules are those of a validated text")]
fn spirv_runs_as_its_text_does() {
    let Some(gpu) = device::device() else { return };
    let module = spirv(COPY);
    let source: &[u8] = &[1, 2, 3, 4, 5, 6, 7, 8];
    // SAFETY: the module is COPY; both buffers are longer than it reaches.
    let run = |entry, bytes| unsafe { gpu.run_spirv(&module, entry, &[source], bytes, [2, 1, 1]) };
    assert_eq!(run("copy", 12).unwrap(), [1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 0, 0]);
    assert_eq!(run("copy", 0).unwrap_err(), GpuError::BufferSize { binding: 1, bytes: 0 });
}
