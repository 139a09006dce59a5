//! Every emitted language, compiled by its users' tools and executed, against the f64 model at the self-test vectors.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use std::sync::OnceLock;
use stratiform_gpu::{Gpu, GpuError};
use stratiform_tests::languages::comparator::{errors, summary, wrong};
use stratiform_tests::languages::signatures::signatures;
use stratiform_tests::languages::tools::{ToolError, available, skip, words_of};
use stratiform_tests::languages::{Emitted, Output, native, shaders};

fn emitted() -> &'static Emitted {
    static EMITTED: OnceLock<Emitted> = OnceLock::new();
    EMITTED.get_or_init(Emitted::committed)
}

/// The device, opened once; or a loud skip. With `STRATIFORM_REQUIRE_GPU=1` that is a failure.
fn device() -> Option<&'static Gpu> {
    static DEVICE: OnceLock<Result<Gpu, GpuError>> = OnceLock::new();
    match DEVICE.get_or_init(Gpu::new) {
        Ok(gpu) => Some(gpu),
        Err(error @ GpuError::NoAdapter { .. }) if std::env::var_os("STRATIFORM_REQUIRE_GPU").is_none() => {
            skip(error);
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// The text with the first digits of the modified medium's extinction one thousandth larger.
fn planted(text: &str) -> String {
    let (number, larger) = constant();
    let changed = text.replacen(&number, &larger, 1);
    assert_ne!(changed, text, "the text holds {number}");
    changed
}

/// The modified medium's extinction as written in every language, and a thousandth more.
fn constant() -> (String, String) {
    let wgsl = emitted().text("stratiform.wgsl");
    let (_, rest) = wgsl.split_once("STRATIFORM_KAPPA_S: f32 = ").unwrap();
    let number = rest.split(';').next().unwrap().to_owned();
    let larger = format!("{}", number.parse::<f32>().unwrap() * 1.001);
    (number, larger)
}

/// The right text gives the model's fluxes and passes its own self-test; the planted one fails both.
fn holds(language: &str, run: impl Fn(&str) -> Option<Output>, text: &str) {
    let Some(output) = run(text) else { return };
    let measured = errors(&emitted().test, &output.fluxes);
    println!("{language:<24} {}", summary(&measured));
    assert!(wrong(&measured).is_empty(), "{language}: {:?}", wrong(&measured));
    assert_eq!(output.wrong, 0, "{language}: the embedded self-test");
    let output = run(&planted(text)).unwrap();
    assert!(!wrong(&errors(&emitted().test, &output.fluxes)).is_empty(), "{language}: planted");
    assert!(output.wrong > 0, "{language}: the embedded self-test, planted");
}

fn native(result: Result<Output, ToolError>) -> Option<Output> {
    available(result, &["clang", "clang++"])
}

#[test]
fn c_reproduces_the_model() {
    let (text, input) = (emitted().text("stratiform.h"), emitted().input());
    for (compiler, standard) in [("gcc", "-std=c99"), ("clang", "-std=c99")] {
        holds(&format!("C by {compiler}"), |text| native(native::c(compiler, standard, text, &input)), &text);
    }
}

#[test]
fn cpp_reproduces_the_model() {
    let (text, input) = (emitted().text("stratiform.h"), emitted().input());
    for (compiler, standard) in [("g++", "-std=c++17"), ("clang++", "-std=c++17")] {
        holds(
            &format!("C++ by {compiler}"),
            |text| native(native::c(compiler, standard, text, &input)),
            &text,
        );
    }
}

#[test]
fn rust_reproduces_the_model() {
    let (text, input) = (emitted().text("stratiform.rs"), emitted().input());
    for edition in ["2021", "2024"] {
        holds(&format!("Rust {edition}"), |text| native(native::rust(edition, text, &input)), &text);
    }
}

#[test]
fn metal_reproduces_the_model() {
    let (text, input) = (emitted().text("stratiform.metal"), emitted().input());
    holds("Metal on the processor", |text| native(native::metal(text, &input)), &text);
}

/// Compiles, and runs where there is a device.
fn compiled(language: &str, compile: impl Fn(&str) -> Result<Vec<u32>, ToolError>, text: &str) {
    let run = |text: &str| {
        let module = available(compile(text), &[shaders::DXC])?;
        device().map(|gpu| shaders::run(gpu, &module, emitted()).unwrap())
    };
    holds(language, run, text);
}

#[test]
fn glsl_reproduces_the_model() {
    compiled("GLSL 450", shaders::glsl_compute, &emitted().text("stratiform.450.glsl"));
}

#[test]
fn hlsl_reproduces_the_model() {
    let text = emitted().text("stratiform.hlsl");
    compiled("HLSL by glslang", shaders::hlsl_by_glslang, &text);
    compiled("HLSL by DXC", shaders::hlsl_by_dxc, &text);
}

#[test]
fn older_glsl_compiles() {
    for (file, version) in [("stratiform.330.glsl", "330"), ("stratiform.300es.glsl", "300 es")] {
        let text = emitted().text(file);
        available(shaders::glsl_fragment(version, &text), &[]);
        let broken = shaders::glsl_fragment(version, &text.replacen("exp(", "expo(", 1));
        assert!(!matches!(broken, Ok(())), "{file}: a planted slip");
    }
}

#[test]
fn wgsl_reproduces_the_model() {
    let Some(gpu) = device() else { return };
    let run = |text: &str| Some(shaders::run_wgsl(gpu, text, emitted()).unwrap());
    holds("WGSL", run, &emitted().text("stratiform.wgsl"));
}

/// The emitted kernel, and the same with one constant's bits changed.
#[test]
fn the_spirv_kernel_reproduces_the_model() {
    let bytes = emitted().bytes("stratiform_self_test.spv");
    available(shaders::validate_spirv(&bytes), &[]);
    let Some(gpu) = device() else { return };
    let module = words_of(&bytes);
    let measure = |module: &[u32]| {
        let fluxes = shaders::run_kernel(gpu, module, "stratiform_self_test_kernel", emitted()).unwrap();
        errors(&emitted().test, &fluxes)
    };
    let measured = measure(&module);
    println!("SPIR-V kernel            {}", summary(&measured));
    assert!(wrong(&measured).is_empty(), "{:?}", wrong(&measured));
    let (number, larger) = constant();
    let [number, larger] = [number, larger].map(|number| number.parse::<f32>().unwrap().to_bits());
    let planted: Vec<u32> = module.iter().map(|word| if *word == number { larger } else { *word }).collect();
    assert_ne!(planted, module);
    assert!(!wrong(&measure(&planted)).is_empty(), "planted");
}

/// Same names, parameters and types of functions, same fields of structures.
#[test]
fn every_language_exports_the_same() {
    let exported = signatures(&emitted().text("stratiform.wgsl"));
    assert!(exported.len() > 20, "guard against checking nothing");
    for ending in ["450.glsl", "330.glsl", "300es.glsl", "hlsl", "metal", "h", "rs"] {
        let found = signatures(&emitted().text(&format!("stratiform.{ending}")));
        assert_eq!(found, exported, "{ending}");
    }
}
