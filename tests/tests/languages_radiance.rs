//! The emitted radiance and halo in every language, executed, against the angular model in double precision.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::f64::consts::PI;
use std::sync::OnceLock;
use stratiform_codegen::RadianceVector;
use stratiform_model::angular::Emission;
use stratiform_tests::languages::held::{hold, share};
use stratiform_tests::languages::library::{RADIANCE, Run};
use stratiform_tests::languages::signatures::signatures;
use stratiform_tests::languages::tools::available;
use stratiform_tests::languages::ways::ways;
use stratiform_tests::languages::{Emitted, shaders};

/// Largest error of I1 and I2 relative to the value, and of I3+ relative to the shape's factor of flux 1.
const RELATIVE: f64 = 2e-5;
const OF_FLUX: f64 = 2e-6;
/// Below this no relative error is asked for, see the fluxes' comparator.
const FAINT: f64 = 1e-20;

struct Radiance {
    emitted: Emitted,
    vectors: Vec<RadianceVector>,
}

fn radiance() -> &'static Radiance {
    static RADIANCE: OnceLock<Radiance> = OnceLock::new();
    RADIANCE.get_or_init(|| {
        let emitted = Emitted::committed();
        let vectors = emitted.radiance_vectors();
        Radiance { emitted, vectors }
    })
}

/// What the driver should write for a vector, each value with the error that it may have.
fn expected(vector: &RadianceVector) -> [[f64; 2]; 11] {
    let factor = Emission::ALL[vector.shape as usize].factor(vector.mu_v);
    let flux = OF_FLUX * factor;
    let [top, bottom] = vector.orders();
    let bounds = |[one, two, more]: [f64; 3]| {
        [RELATIVE * one + FAINT, RELATIVE * two + FAINT, RELATIVE * more.abs() + flux]
    };
    let [top_bounds, bottom_bounds] = [bounds(top), bounds(bottom)];
    let sum = |three: [f64; 3]| three.iter().sum::<f64>();
    let transparency = libm::exp(-vector.tau / vector.mu_v);
    [
        [top[0], top_bounds[0]],
        [top[1], top_bounds[1]],
        [top[2], top_bounds[2]],
        [bottom[0], bottom_bounds[0]],
        [bottom[1], bottom_bounds[1]],
        [bottom[2], bottom_bounds[2]],
        [sum(top), sum(top_bounds)],
        [sum(bottom), sum(bottom_bounds)],
        [transparency, RELATIVE * transparency + FAINT],
        [vector.mu_l / PI, RELATIVE * vector.mu_l],
        [vector.halo, RELATIVE * vector.halo + FAINT],
    ]
}

/// Largest error in units of what is allowed.
fn worst(values: &[f32]) -> f64 {
    share(values, radiance().vectors.iter().flat_map(expected))
}

fn reproduces_the_model(ending: &str) {
    let Radiance { emitted, vectors } = radiance();
    let sight = |s: &RadianceVector| [s.mu_l, s.mu_v, s.v, s.tau, f64::from(s.shape)];
    let input: Vec<u8> = vectors.iter().flat_map(sight).flat_map(|x| (x as f32).to_le_bytes()).collect();
    let (tables, mut beside) =
        ([emitted.phase_table(), emitted.halo_table()], emitted.beside(&RADIANCE, ending));
    let tables = tables.each_ref().map(|table| &**table);
    let tables = if matches!(ending, "h" | "rs") { &[] } else { &tables[..] };
    let run = Run { library: &RADIANCE, tables, input: &input, beside: &beside };
    let text = emitted.text(&format!("stratiform_halo.{ending}"));
    // The step across the halo's table, a thousandth off.
    let wgsl = emitted.text("stratiform_halo.wgsl");
    let number = wgsl.split_once("ACROSS: f32 = ").unwrap().1.split(';').next().unwrap();
    let planted = text.replacen(number, &format!("{}", number.parse::<f32>().unwrap() * 1.001), 1);
    hold(ending, &run, [&text, &planted], worst);
    // A weight of the second order, a thousandth off, in the first way.
    for (name, text) in beside.iter_mut().filter(|(name, _)| name.starts_with("stratiform_radiance")) {
        let changed = text.replacen("0.125", "0.125125", 1);
        assert_ne!(changed, *text, "{name}");
        *text = changed;
    }
    let run = Run { library: &RADIANCE, tables, input: &input, beside: &beside };
    for output in ways(ending).take(1).filter_map(|way| way.execute(&run, &text)) {
        assert!(worst(&output.values) > 1.0 && output.wrong > 0, "{ending}: planted in the radiance");
    }
}

stratiform_tests::in_every_language!(reproduces_the_model);

#[test]
fn older_glsl_compiles() {
    for (ending, version) in [("330.glsl", "330"), ("300es.glsl", "300 es")] {
        let emitted = &radiance().emitted;
        let beside = emitted.beside(&RADIANCE, ending);
        let run = Run { library: &RADIANCE, tables: &[], input: &[], beside: &beside };
        let text = run.pasted(&emitted.text(&format!("stratiform_halo.{ending}")));
        available(shaders::glsl_fragment(version, &RADIANCE, &text), &[]);
        let broken =
            shaders::glsl_fragment(version, &RADIANCE, &text.replace("exp(-shortest)", "expo(-shortest)"));
        assert!(!matches!(broken, Ok(())), "{ending}: a planted slip");
    }
}

/// As methods of a structure in Metal's language, as functions elsewhere.
#[test]
fn every_language_exports_the_same() {
    let structure = |line: &&str| {
        let owner =
            line.starts_with("struct StratiformRadiance {") || line.starts_with("struct StratiformHalo {");
        owner || *line == "    StratiformPhase phase;"
    };
    for name in ["stratiform_radiance", "stratiform_halo"] {
        let text = |ending: &str| radiance().emitted.text(&format!("{name}.{ending}"));
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
