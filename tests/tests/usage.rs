//! The examples of use in the docs, compiled against the committed files by the compilers of their languages.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use naga::valid::{Capabilities, ValidationFlags, Validator};
use stratiform_tests::languages::tools::{Scratch, ToolError, available};
use stratiform_tests::languages::{Emitted, native};

const USAGE: &str = include_str!("../../crates/codegen/src/usage.md");

/// Every library.
const FILES: [&str; 6] = [
    "stratiform",
    "stratiform_weights",
    "stratiform_phase",
    "stratiform_radiance",
    "stratiform_shade",
    "stratiform_halo",
];

/// The block of a language.
fn block(language: &str) -> String {
    let (_, rest) = USAGE.split_once(&format!("```{language}\n")).unwrap();
    rest.split_once("```").unwrap().0.to_owned()
}

/// The block with each line that names an emitted file replaced by the file.
fn pasted(language: &str, mark: &str) -> String {
    let line = |line: &str| match line.strip_prefix(mark) {
        Some(name) => Emitted::committed().text(name.trim_matches('"')),
        None => line.to_owned(),
    };
    block(language).lines().map(line).collect::<Vec<_>>().join("\n")
}

/// A folder with the emitted files `names`.
fn folder(names: &[String]) -> Result<Scratch, ToolError> {
    let scratch = Scratch::new()?;
    for name in names {
        scratch.write(name, Emitted::committed().text(name))?;
    }
    Ok(scratch)
}

fn assert_talks(output: &[u8]) {
    let said = String::from_utf8_lossy(output);
    assert!(said.contains("transmitted 0.") && said.contains("P at 142 degrees: 0.29"), "{said}");
    assert!(said.contains("L / F0 above 0."), "{said}");
}

#[test]
fn c() {
    let run = || {
        let scratch = folder(&FILES.map(|name| format!("{name}.h")))?;
        scratch.write("example.c", block("c"))?;
        scratch
            .run("gcc", &["-std=c99", "-Wall", "-Wextra", "-Werror", "example.c", "-o", "example", "-lm"])?;
        scratch.run_program("example", b"")
    };
    available(run(), &[]).iter().for_each(|output| assert_talks(output));
}

#[test]
fn rust() {
    let run = || {
        let scratch = folder(&FILES.map(|name| format!("{name}.rs")))?;
        scratch.write("example.rs", block("rust,ignore"))?;
        scratch.run("rustc", &["--edition", "2024", "-D", "warnings", "example.rs"])?;
        scratch.run_program("example", b"")
    };
    available(run(), &[]).iter().for_each(|output| assert_talks(output));
}

#[test]
fn wgsl() {
    let text = pasted("wgsl", "// paste: ");
    let module =
        naga::front::wgsl::parse_str(&text).unwrap_or_else(|e| panic!("{}", e.emit_to_string(&text)));
    Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module).unwrap();
}

#[test]
fn glsl() {
    let run = || {
        let scratch = Scratch::new()?;
        scratch.write("example.frag", pasted("glsl", "// paste: "))?;
        scratch.run("glslangValidator", &["example.frag"])
    };
    available(run(), &[]);
}

#[test]
fn hlsl() {
    let run = || {
        let scratch = Scratch::new()?;
        scratch.write("example.hlsl", pasted("hlsl", "#include "))?;
        let arguments = ["-D", "-V", "-S", "frag", "-e", "main", "example.hlsl", "-o", "example.spv"];
        scratch.run("glslangValidator", &arguments)
    };
    available(run(), &[]);
}

#[test]
fn metal() {
    let run = || {
        let scratch = folder(&FILES.map(|name| format!("{name}.metal")))?;
        scratch.write("metal_stdlib", native::METAL_LIBRARY)?;
        scratch.write("example.metal", block("metal"))?;
        let arguments =
            ["-std=c++17", "-fsyntax-only", "-I.", "-Wall", "-Wextra", "-Werror", "-Wno-attributes"];
        scratch.run("g++", &[&arguments[..], &["-x", "c++", "example.metal"]].concat())
    };
    available(run(), &[]);
}
