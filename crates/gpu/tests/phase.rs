//! The emitted phase look-up, executed, against the function that the tables were made from.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

#[path = "../../codegen/tests/common/mod.rs"]
mod common;
mod device;

use stratiform_codegen::{Target, generate};
use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
use stratiform_quantities::Asymmetry;

const ENTRY: &str = "
@group(0) @binding(1) var<storage, read> test_v: array<f32>;
@group(0) @binding(2) var<storage, read_write> test_p: array<f32>;
@compute @workgroup_size(64)
fn test_phase(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= arrayLength(&test_v)) { return; }
    let v = test_v[id.x];
    test_p[4u * id.x] = stratiform_phase(v);
    test_p[4u * id.x + 1u] = stratiform_phase_modified(v);
    test_p[4u * id.x + 2u] = stratiform_phase_squared(v);
    test_p[4u * id.x + 3u] = stratiform_phase_angle(stratiform_phase_coordinate(stratiform_arc(v)));
}
";

/// Columns p, then p_squared, of phase_warped.csv.
fn table(csv: &str) -> Vec<f32> {
    let column =
        |i: usize| csv.lines().skip(1).map(move |line| line.split(',').nth(i).unwrap().parse().unwrap());
    column(2).chain(column(3)).collect()
}

/// 1 - cosΘ from Θ = 1e-3° to 180°, graded towards both ends.
fn arguments() -> Vec<f32> {
    let angle = |i: i32| {
        if i <= 200 { 1e-3 * libm::exp(0.0571 * f64::from(i)) } else { 90.0 + 0.45 * f64::from(i - 200) }
    };
    let v =
        |degrees: f64| 2.0 * libm::sin(0.5 * degrees.to_radians()) * libm::sin(0.5 * degrees.to_radians());
    (0..=400).map(|i| v(angle(i)) as f32).collect()
}

#[test]
fn the_phase_look_up_reproduces_its_tables() {
    let Some(gpu) = device::device() else { return };
    let files = generate(&common::inputs(), &Target::ALL).unwrap();
    let module = format!("{}{ENTRY}", files.text("stratiform_phase.wgsl").unwrap());
    let (table, v) = (table(files.text("phase_warped.csv").unwrap()), arguments());
    let bindings: [&[u8]; 2] = [bytemuck::cast_slice(&table), bytemuck::cast_slice(&v)];
    let groups = [u32::try_from(v.len().div_ceil(64)).unwrap(), 1, 1];
    let output = gpu.run(&module, "test_phase", &bindings, 16 * v.len(), groups).unwrap();
    let output: Vec<f32> = bytemuck::pod_collect_to_vec(&output);
    let [full, squared] = [0.85, 0.5].map(|g| HenyeyGreenstein::new(Asymmetry::new(g).unwrap()));
    let edge = 2.0 * libm::sin(2.5_f64.to_radians()) * libm::sin(2.5_f64.to_radians());
    let mut worst = [0.0_f64; 4];
    for (v, shader) in v.iter().map(|v| f64::from(*v)).zip(output.chunks(4)) {
        let wide = if v < edge { 0.0 } else { full.value(v) / (1.0 - 0.455) };
        let angle = 2.0 * libm::asin((0.5 * v).sqrt().min(1.0));
        for ((worst, shader), exact) in
            worst.iter_mut().zip(shader).zip([full.value(v), wide, squared.value(v), angle])
        {
            let scale = if exact == 0.0 { 1.0 } else { exact };
            *worst = worst.max((f64::from(*shader) - exact).abs() / scale);
        }
    }
    println!(
        "largest relative error of P, P_S, P_S convolved, angle: {:.1e} {:.1e} {:.1e} {:.1e}",
        worst[0], worst[1], worst[2], worst[3]
    );
    assert!(worst[..3].iter().all(|error| *error < 2e-4) && worst[3] < 2e-6, "{worst:?}");
}
