//! The window shows radiance as a PNG does.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;

use stratiform_gpu::Gpu;
use stratiform_imaging::Tone;
use stratiform_viewer::TONE;

const MAIN: &str = "
@group(0) @binding(0) var<storage, read> radiance: array<vec4<f32>>;
@group(0) @binding(1) var<storage, read_write> stored: array<vec4<f32>>;
@compute @workgroup_size(1)
fn show_all(@builtin(global_invocation_id) id: vec3<u32>) {
    let one = radiance[id.x];
    stored[id.x] = vec4<f32>(shown(one.xyz, one.w), 1.0);
}
";

/// Half of a byte's step would be 2e-3; the driver's exp and pow are good to a few 1e-6.
const BOUND: f64 = 1e-4;

/// Colours and exposures: darkness, both pieces of the transfer curve, the shoulder, far above white, outside the gamut, below black.
fn samples() -> Vec<[f32; 4]> {
    let greys = (0..64)
        .map(|i| (1_u64 << (i / 2)) as f32 * if i % 2 == 0 { 1e-6 } else { 1.4e-6 })
        .map(|l| [l, 0.7 * l, 0.3 * l, 0.0]);
    let odd = [[0.0; 4], [0.3, 0.2, -0.05, 1.0], [-0.1, -0.2, 0.01, 0.0], [1e4, 1e3, -1.0, 3.0]];
    let exposed = (-8..8).map(|ev| [0.2, 0.25, 0.3, 0.5 * ev as f32]);
    greys.chain(odd).chain(exposed).collect()
}

/// Largest difference from the imaging crate's tone, whose exposure is off by `shift`.
fn worst(gpu: &Gpu, shift: f64) -> f64 {
    let samples = samples();
    let bytes: Vec<u8> = samples.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
    let text = [TONE, MAIN].join("\n");
    let output = gpu.run(&text, "show_all", &[&bytes], bytes.len(), [samples.len() as u32, 1, 1]).unwrap();
    let shown = output.as_chunks::<4>().0.iter().map(|four| f64::from(f32::from_le_bytes(*four)));
    let expected = samples.iter().flat_map(|[r, g, b, ev]| {
        let [r, g, b] = Tone::at(f64::from(*ev) + shift).stored([*r, *g, *b]);
        [r, g, b, 1.0]
    });
    shown.zip(expected).map(|(shown, expected)| (shown - expected).abs()).fold(0.0, f64::max)
}

#[test]
fn the_tone_is_that_of_the_files() {
    let Some(gpu) = device::device() else { return };
    let worst_here = worst(&gpu, 0.0);
    assert!(worst_here < BOUND, "{worst_here}");
    assert!(worst(&gpu, 0.01) > 10.0 * BOUND, "a hundredth of a stop is seen");
}
