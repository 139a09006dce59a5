//! Every emitted shader passes naga's validator.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use naga::valid::{Capabilities, ValidationFlags, Validator};

fn validate(name: &str, text: &str) {
    let module =
        naga::front::wgsl::parse_str(text).unwrap_or_else(|e| panic!("{name}:\n{}", e.emit_to_string(text)));
    let result = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
    result.unwrap_or_else(|e| panic!("{name}:\n{}", e.emit_to_string(text)));
    let named = module.functions.iter().filter_map(|(_, function)| function.name.as_deref());
    for name in named {
        assert!(name.starts_with("stratiform_"), "{name}");
        assert!(!name.ends_with(|c: char| c.is_ascii_digit()), "{name}");
    }
}

#[test]
fn every_module_is_valid_by_itself() {
    let files = stratiform_codegen::generate(&common::inputs(), &stratiform_codegen::Target::ALL).unwrap();
    for name in ["stratiform.wgsl", "stratiform_phase.wgsl"] {
        validate(name, files.text(name).unwrap());
    }
    let text = |name: &str| files.text(name).unwrap();
    let needs = ["stratiform.wgsl", "stratiform_weights.wgsl", "stratiform_phase.wgsl"].map(text).join("\n");
    for name in ["stratiform_radiance.wgsl", "stratiform_shade.wgsl", "stratiform_halo.wgsl"] {
        validate(name, &format!("{needs}\n{}", text(name)));
    }
    validate("self-test", &stratiform_codegen::self_test_module(&files).unwrap());
}

#[test]
fn no_large_constant_arrays_are_emitted() {
    let files = stratiform_codegen::generate(&common::inputs(), &stratiform_codegen::Target::ALL).unwrap();
    for name in files.names().filter(|name| name.ends_with(".wgsl")) {
        let text = files.text(name).unwrap();
        let code: Vec<_> = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        assert!(!code.iter().any(|line| line.contains("array<f32,") || line.contains("array(")), "{name}");
    }
}
