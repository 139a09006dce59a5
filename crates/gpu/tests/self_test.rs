//! The emitted shader, executed, against the f64 model at the self-test vectors.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

#[path = "../../codegen/tests/common/mod.rs"]
mod common;
mod device;

use stratiform_codegen::{QUANTITIES, SelfTest, Target, generate, self_test_module};
use stratiform_gpu::Gpu;
use stratiform_quantities::Incidence;

/// Largest error of a flux. Measured on Mesa 22.3 llvmpipe: 1.9e-7.
const ABSOLUTE: f64 = 2e-6;
/// Largest relative error of a flux above [`FAINT`]; of T_3+ and R_3+ relative to the terms of the difference.
const RELATIVE: f64 = 2e-5;
/// Below this no relative error is asked for: a rounding of the path x = ln(1/flux) is x roundings of e^{-x}.
const FAINT: f64 = 1e-20;

fn input(test: &SelfTest) -> Vec<f32> {
    let pair = |mu_l: Incidence, tau: f64| {
        let mu = match mu_l {
            Incidence::Beam(mu) => mu.get(),
            Incidence::Diffuse => -1.0,
        };
        [mu as f32, tau as f32]
    };
    test.vectors.iter().flat_map(|vector| pair(vector.mu_l, vector.tau)).collect()
}

fn execute(gpu: &Gpu, wgsl: &str, test: &SelfTest) -> Vec<f32> {
    let bytes = 36 * test.vectors.len();
    let groups = [u32::try_from(test.vectors.len().div_ceil(64)).unwrap(), 1, 1];
    let input = input(test);
    let output =
        gpu.run(wgsl, "stratiform_self_test_kernel", &[bytemuck::cast_slice(&input)], bytes, groups).unwrap();
    bytemuck::pod_collect_to_vec(&output)
}

/// What the error of flux `i` is relative to.
fn scale([t_ms, r_ms, _, t_1, t_2, _, r_1, r_2, _]: [f64; 9], i: usize, exact: f64) -> f64 {
    match i {
        5 => exact.abs() + t_1 + t_2 + r_ms.min(t_ms),
        8 => exact.abs() + r_1 + r_2,
        _ => exact.abs(),
    }
}

/// Largest absolute and largest relative error per flux, over all vectors.
fn errors(test: &SelfTest, output: &[f32]) -> [(f64, f64); 9] {
    let mut worst = [(0.0_f64, 0.0_f64); 9];
    for (vector, shader) in test.vectors.iter().zip(output.chunks(9)) {
        for (i, (worst, shader)) in worst.iter_mut().zip(shader).enumerate() {
            let exact = vector.fluxes[i];
            let error = (f64::from(*shader) - exact).abs();
            assert!(error.is_finite());
            worst.0 = worst.0.max(error);
            if exact.abs() > FAINT {
                worst.1 = worst.1.max(error / scale(vector.fluxes, i, exact));
            }
        }
    }
    worst
}

fn report(gpu: &Gpu, worst: &[(f64, f64); 9]) {
    println!("{}\nflux      absolute relative", gpu.adapter());
    for (quantity, (absolute, relative)) in QUANTITIES.iter().zip(worst) {
        println!("{quantity:<9} {absolute:.1e}  {relative:.1e}");
    }
}

#[test]
fn the_shader_reproduces_the_model() {
    let Some(gpu) = device::device() else { return };
    let files = generate(&common::inputs(), &Target::ALL).unwrap();
    let test: SelfTest = serde_json::from_str(files.text("self_test.json").unwrap()).unwrap();
    let module = self_test_module(&files).unwrap();
    let worst = errors(&test, &execute(&gpu, &module, &test));
    report(&gpu, &worst);
    assert!(worst.iter().all(|error| error.0 < ABSOLUTE && error.1 < RELATIVE), "{worst:?}");
}

/// The committed text of the paper's cloud, as a user pastes it in.
#[test]
fn the_committed_shader_reproduces_the_model() {
    let Some(gpu) = device::device() else { return };
    let folder =
        std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/generated"));
    let read = |name: &str| (name.to_owned(), std::fs::read_to_string(folder.join(name)).unwrap());
    let files =
        ["stratiform.wgsl", "stratiform_self_test.wgsl", "self_test.json"].map(read).into_iter().collect();
    let test: SelfTest =
        serde_json::from_str(&std::fs::read_to_string(folder.join("self_test.json")).unwrap()).unwrap();
    let module = self_test_module(&files).unwrap();
    let worst = errors(&test, &execute(&gpu, &module, &test));
    report(&gpu, &worst);
    assert!(worst.iter().all(|error| error.0 < ABSOLUTE && error.1 < RELATIVE), "{worst:?}");
}

/// A slip of the size of a rounded constant is seen.
#[test]
fn a_planted_slip_in_the_shader_is_seen() {
    let Some(gpu) = device::device() else { return };
    let files = generate(&common::inputs(), &Target::ALL).unwrap();
    let test: SelfTest = serde_json::from_str(files.text("self_test.json").unwrap()).unwrap();
    let module = self_test_module(&files).unwrap();
    let planted = module.replacen("STRATIFORM_KAPPA_S: f32 = 0.545;", "STRATIFORM_KAPPA_S: f32 = 0.5451;", 1);
    assert_ne!(planted, module);
    let worst = errors(&test, &execute(&gpu, &planted, &test));
    assert!(worst[2].0 > 10.0 * ABSOLUTE && worst[2].1 > RELATIVE, "{worst:?}");
}
