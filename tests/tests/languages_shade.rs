//! The emitted fitted radiance in every language, executed, against the model in double precision.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::sync::OnceLock;
use stratiform_codegen::ShadeVector;
use stratiform_tests::languages::held::{hold, share};
use stratiform_tests::languages::library::{Run, SHADE};
use stratiform_tests::languages::signatures::signatures;
use stratiform_tests::languages::tools::available;
use stratiform_tests::languages::{Emitted, shaders};

/// Largest error of single scattering and of the rest, relative to the value.
const RELATIVE: f64 = 2e-5;
/// Below this no relative error is asked for, see the fluxes' comparator.
const FAINT: f64 = 1e-20;

struct Shade {
    emitted: Emitted,
    vectors: Vec<ShadeVector>,
}

fn shade() -> &'static Shade {
    static SHADE: OnceLock<Shade> = OnceLock::new();
    SHADE.get_or_init(|| {
        let emitted = Emitted::committed();
        let vectors = emitted.shade_vectors();
        Shade { emitted, vectors }
    })
}

/// What the driver should write for a vector, each value with the error that it may have.
fn expected(vector: &ShadeVector) -> [[f64; 2]; 6] {
    let face = |once: f64, more: f64| {
        let (first, rest) = (RELATIVE * once + FAINT, RELATIVE * more + FAINT);
        [[once, first], [more, rest], [once + more, first + rest]]
    };
    let [top, bottom] =
        [face(vector.top_once, vector.top_more), face(vector.bottom_once, vector.bottom_more)];
    [top[0], top[1], top[2], bottom[0], bottom[1], bottom[2]]
}

/// Largest error in units of what is allowed.
fn worst(values: &[f32]) -> f64 {
    share(values, shade().vectors.iter().flat_map(expected))
}

/// The first coefficient of either face, a thousandth more.
fn planted(text: &str) -> String {
    let wgsl = shade().emitted.text("stratiform_shade.wgsl");
    wgsl.split("return StratiformShadeFactors(").skip(1).fold(text.to_owned(), |text, rest| {
        let number = rest.split_whitespace().next().unwrap();
        let changed = text.replacen(number, &format!("{:?}", number.parse::<f32>().unwrap() * 1.001), 1);
        assert_ne!(changed, text, "the text holds {number}");
        changed
    })
}

fn reproduces_the_model(ending: &str) {
    let Shade { emitted, vectors } = shade();
    let sight = |s: &ShadeVector| [s.mu_l, s.mu_v, s.v, s.tau];
    let input: Vec<u8> = vectors.iter().flat_map(sight).flat_map(|x| (x as f32).to_le_bytes()).collect();
    let (table, beside) = (emitted.phase_table(), emitted.beside(&SHADE, ending));
    let tables = [&*table];
    let tables = if matches!(ending, "h" | "rs") { &[] } else { &tables[..] };
    let run = Run { library: &SHADE, tables, input: &input, beside: &beside };
    let text = emitted.text(&format!("stratiform_shade.{ending}"));
    hold(ending, &run, [&text, &planted(&text)], worst);
}

stratiform_tests::in_every_language!(reproduces_the_model);

#[test]
fn older_glsl_compiles() {
    for (ending, version) in [("330.glsl", "330"), ("300es.glsl", "300 es")] {
        let emitted = &shade().emitted;
        let beside = emitted.beside(&SHADE, ending);
        let run = Run { library: &SHADE, tables: &[], input: &[], beside: &beside };
        let text = run.pasted(&emitted.text(&format!("stratiform_shade.{ending}")));
        available(shaders::glsl_fragment(version, &SHADE, &text), &[]);
    }
}

/// As methods of a structure in Metal's language, as functions elsewhere.
#[test]
fn every_language_exports_the_same() {
    let structure =
        |line: &&str| line.starts_with("struct StratiformShade {") || *line == "    StratiformPhase phase;";
    for name in ["stratiform_shade", "stratiform_weights"] {
        let text = |ending: &str| shade().emitted.text(&format!("{name}.{ending}"));
        let exported = signatures(&text("wgsl"));
        assert!(exported.len() > 6, "guard against checking nothing");
        for ending in ["450.glsl", "330.glsl", "300es.glsl", "hlsl", "h", "rs"] {
            assert_eq!(signatures(&text(ending)), exported, "{name}.{ending}");
        }
        let metal = text("metal");
        let metal: Vec<_> = metal.lines().filter(|line| !structure(line)).collect();
        assert_eq!(signatures(&metal.join("\n")), exported, "{name}.metal");
    }
}
