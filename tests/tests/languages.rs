//! The emitted fluxes in every language, compiled by its users' tools and executed, against the f64 model at the
//! self-test vectors; and the embedded self-test. Each once more with one constant a thousandth off: both see it.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use std::sync::OnceLock;
use stratiform_tests::languages::comparator::{errors, summary, wrong};
use stratiform_tests::languages::library::{FLUXES, Run};
use stratiform_tests::languages::signatures::signatures;
use stratiform_tests::languages::tools::{available, words_of};
use stratiform_tests::languages::ways::{device, ways};
use stratiform_tests::languages::{Emitted, shaders};

fn emitted() -> &'static Emitted {
    static EMITTED: OnceLock<Emitted> = OnceLock::new();
    EMITTED.get_or_init(Emitted::committed)
}

fn run(input: &[u8]) -> Run<'_> {
    Run { library: &FLUXES, tables: &[], input, beside: &[] }
}

/// The modified medium's extinction as written in every language, and a thousandth more.
fn constant() -> (String, String) {
    let wgsl = emitted().text("stratiform.wgsl");
    let (_, rest) = wgsl.split_once("STRATIFORM_KAPPA_S: f32 = ").unwrap();
    let number = rest.split(';').next().unwrap().to_owned();
    let larger = format!("{}", number.parse::<f32>().unwrap() * 1.001);
    (number, larger)
}

fn planted(text: &str) -> String {
    let (number, larger) = constant();
    let changed = text.replacen(&number, &larger, 1);
    assert_ne!(changed, text, "the text holds {number}");
    changed
}

fn reproduces_the_model(ending: &str) {
    let (emitted, input) = (emitted(), emitted().input());
    let text = emitted.text(&format!("stratiform.{ending}"));
    for way in ways(ending) {
        let Some(output) = way.execute(&run(&input), &text) else { continue };
        let measured = errors(&emitted.test, &output.values);
        println!("{:<24} {}", way.name, summary(&measured));
        assert!(wrong(&measured).is_empty(), "{}: {:?}", way.name, wrong(&measured));
        assert_eq!(output.wrong, 0, "{}: the embedded self-test", way.name);
        let output = way.execute(&run(&input), &planted(&text)).unwrap();
        let measured = errors(&emitted.test, &output.values);
        assert!(!wrong(&measured).is_empty() && output.wrong > 0, "{}: planted, {output:?}", way.name);
    }
}

stratiform_tests::in_every_language!(reproduces_the_model);

/// The emitted kernel, and the same with one constant's bits changed.
#[test]
fn the_spirv_kernel_reproduces_the_model() {
    let bytes = emitted().bytes("stratiform_self_test.spv");
    available(shaders::validate_spirv(&bytes), &[]);
    let Some(gpu) = device() else { return };
    let (module, input) = (words_of(&bytes), emitted().input());
    let measure = |module: &[u32]| {
        let fluxes = shaders::run_kernel(gpu, &run(&input), module, "stratiform_self_test_kernel").unwrap();
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

#[test]
fn older_glsl_compiles() {
    for (ending, version) in [("330.glsl", "330"), ("300es.glsl", "300 es")] {
        let text = emitted().text(&format!("stratiform.{ending}"));
        available(shaders::glsl_fragment(version, &FLUXES, &text), &[]);
        let broken = shaders::glsl_fragment(version, &FLUXES, &text.replace("exp(", "expo("));
        assert!(!matches!(broken, Ok(())), "{ending}: a planted slip");
    }
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
