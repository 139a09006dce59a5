//! Passes over buffers that stay on the device.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod device;

use device::device;
use stratiform_gpu::{Access, GpuError, Pass};

const DOUBLE: &str = "
@group(0) @binding(0) var<storage, read> source: array<u32>;
@group(0) @binding(1) var<storage, read_write> result: array<u32>;
@compute @workgroup_size(4) fn double(@builtin(global_invocation_id) id: vec3<u32>) { result[id.x] = 2u * source[id.x]; }
";

#[test]
fn each_pass_sees_what_the_one_before_it_wrote() {
    let Some(gpu) = device() else { return };
    let kernel = gpu.kernel(DOUBLE, "double", &[Access::Read, Access::Write]).unwrap();
    let a = gpu.upload(&[1_u32, 2, 3, 4].map(u32::to_le_bytes).concat()).unwrap();
    let b = gpu.zeroed(16).unwrap();
    let pass = |from, into| [from, into];
    let (there, back) = (pass(&a, &b), pass(&b, &a));
    let passes = [
        Pass { name: "there", kernel: &kernel, buffers: &there, groups: [1, 1, 1] },
        Pass { name: "back", kernel: &kernel, buffers: &back, groups: [1, 1, 1] },
    ];
    let seconds = gpu.time_passes(&passes).unwrap();
    assert!(seconds.is_none_or(|seconds| seconds.len() == 2 && seconds.iter().all(|s| *s >= 0.0)));
    assert_eq!(gpu.download(&a).unwrap(), [4_u32, 8, 12, 16].map(u32::to_le_bytes).concat());
}

#[test]
fn what_does_not_fit_is_refused() {
    let Some(gpu) = device() else { return };
    assert!(matches!(gpu.kernel("nonsense", "double", &[]), Err(GpuError::Refused { .. })));
    assert!(matches!(gpu.upload(&[1, 2, 3]), Err(GpuError::BufferSize { .. })));
    assert!(matches!(gpu.zeroed(1 << 40), Err(GpuError::OutOfMemory { .. })));
    let kernel = gpu.kernel(DOUBLE, "double", &[Access::Read, Access::Write]).unwrap();
    let only = [&gpu.zeroed(16).unwrap()];
    let pass = Pass { name: "short of one", kernel: &kernel, buffers: &only, groups: [1, 1, 1] };
    assert!(matches!(gpu.submit_passes(&[pass]), Err(GpuError::Refused { .. })));
}

#[test]
fn a_device_that_is_lost_says_so_whatever_it_is_asked() {
    let Some(gpu) = device() else { return };
    let kernel = gpu.kernel(DOUBLE, "double", &[Access::Read, Access::Write]).unwrap();
    let (a, b) = (gpu.zeroed(16).unwrap(), gpu.zeroed(16).unwrap());
    let buffers = [&a, &b];
    let passes = [Pass { name: "late", kernel: &kernel, buffers: &buffers, groups: [1, 1, 1] }];
    gpu.lose();
    let lost =
        |result: Result<(), GpuError>| assert!(matches!(result, Err(GpuError::Lost { .. })), "{result:?}");
    lost(gpu.upload(&[0; 4]).map(|_| ()));
    lost(gpu.replace(&a, &[0; 4]));
    lost(gpu.download(&a).map(|_| ()));
    lost(gpu.kernel(DOUBLE, "double", &[Access::Read, Access::Write]).map(|_| ()));
    lost(gpu.submit_passes(&passes));
    lost(gpu.time_passes(&passes).map(|_| ()));
    lost(gpu.clone().wait());
    lost(gpu.run(DOUBLE, "double", &[&[0; 16]], 16, [1, 1, 1]).map(|_| ()));
}
