//! The emitted fluxes over effective radius in every language, executed, against the f64 model; and their self-test. Each
//! once more with one parameter of a table a thousandth off: both see it.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use std::sync::OnceLock;
use stratiform_artifact::{FamilyDocument, read_csv};
use stratiform_cli::config::Config;
use stratiform_cli::pipeline::accepted;
use stratiform_codegen::{FamilyVector, SelfTest, SelfTestVector, Target};
use stratiform_quantities::Incidence;
use stratiform_tests::languages::comparator::{errors, summary, wrong};
use stratiform_tests::languages::library::{FAMILY, Run};
use stratiform_tests::languages::signatures::signatures;
use stratiform_tests::languages::tools::available;
use stratiform_tests::languages::ways::ways;
use stratiform_tests::languages::{Emitted, shaders};
use stratiform_tests::root;
use tempfile::TempDir;

struct Family {
    _folder: TempDir,
    emitted: Emitted,
    document: FamilyDocument,
    input: Vec<u8>,
    test: SelfTest,
}

/// Every language of the accepted family, whatever its config commits.
fn family() -> &'static Family {
    static FAMILY: OnceLock<Family> = OnceLock::new();
    FAMILY.get_or_init(|| {
        let mut config = Config::load(&root().join("fit-configs/family.toml")).unwrap();
        config.codegen.targets = Target::ALL.to_vec();
        let kept = root().join("fit-configs").join(&config.codegen.accepted);
        let document = accepted::read_family(&config, &kept).unwrap().unwrap();
        let files = accepted::emitted(&config, &accepted::read(&kept).unwrap(), &kept).unwrap();
        let folder = tempfile::tempdir().unwrap();
        stratiform_codegen::write(&files, folder.path()).unwrap();
        let emitted = Emitted::at(folder.path().to_owned());
        let vectors: Vec<FamilyVector> = read_csv(&folder.path().join("family_test.csv")).unwrap();
        let numbers = vectors.iter().flat_map(|v| [v.mu_l, v.radius_um, v.tau]);
        let input = numbers.flat_map(|x| (x as f32).to_le_bytes()).collect();
        let vectors = vectors.iter().map(expected).collect();
        let test = SelfTest { vectors, ..emitted.test.clone() };
        Family { _folder: folder, emitted, document, input, test }
    })
}

fn expected(vector: &FamilyVector) -> SelfTestVector {
    let beam = vector.mu_l >= 0.0;
    let mu_l = if beam { Incidence::beam(vector.mu_l).unwrap() } else { Incidence::Diffuse };
    SelfTestVector { mu_l, tau: vector.tau, fluxes: vector.fluxes() }
}

/// t at the zenith of the first radius, a thousandth more.
fn planted(text: &str) -> String {
    let t = family().document.members[0].parameters.optical.rows[0].t.emitted as f32;
    let changed = text.replacen(&format!("{t:?}"), &format!("{:?}", t * 1.001), 1);
    assert_ne!(changed, text, "the text holds {t}");
    changed
}

fn reproduces_the_model(ending: &str) {
    let Family { emitted, input, test, .. } = family();
    let beside = emitted.beside(&FAMILY, ending);
    let run = Run { library: &FAMILY, tables: &[], input, beside: &beside };
    let text = emitted.text(&format!("stratiform_family.{ending}"));
    for way in ways(ending) {
        let Some(output) = way.execute(&run, &text) else { continue };
        let measured = errors(test, &output.values);
        println!("{:<24} {}", way.name, summary(&measured));
        assert!(wrong(&measured).is_empty(), "{}: {:?}", way.name, wrong(&measured));
        assert_eq!(output.wrong, 0, "{}: the embedded self-test", way.name);
        let output = way.execute(&run, &planted(&text)).unwrap();
        let measured = errors(test, &output.values);
        assert!(!wrong(&measured).is_empty() && output.wrong > 0, "{}: planted", way.name);
    }
}

#[test]
fn c_and_cpp_reproduce_the_model() {
    reproduces_the_model("h");
}

#[test]
fn rust_reproduces_the_model() {
    reproduces_the_model("rs");
}

#[test]
fn metal_reproduces_the_model() {
    reproduces_the_model("metal");
}

#[test]
fn glsl_reproduces_the_model() {
    reproduces_the_model("450.glsl");
}

#[test]
fn hlsl_reproduces_the_model() {
    reproduces_the_model("hlsl");
}

#[test]
fn wgsl_reproduces_the_model() {
    reproduces_the_model("wgsl");
}

#[test]
fn older_glsl_compiles() {
    for (ending, version) in [("330.glsl", "330"), ("300es.glsl", "300 es")] {
        let emitted = &family().emitted;
        let beside = emitted.beside(&FAMILY, ending);
        let run = Run { library: &FAMILY, tables: &[], input: &[], beside: &beside };
        let text = run.pasted(&emitted.text(&format!("stratiform_family.{ending}")));
        available(shaders::glsl_fragment(version, &FAMILY, &text), &[]);
    }
}

#[test]
fn every_language_exports_the_same() {
    let text = |ending: &str| family().emitted.text(&format!("stratiform_family.{ending}"));
    let exported = signatures(&text("wgsl"));
    assert!(exported.len() > 12, "guard against checking nothing");
    for ending in ["450.glsl", "330.glsl", "300es.glsl", "hlsl", "metal", "h", "rs"] {
        assert_eq!(signatures(&text(ending)), exported, "{ending}");
    }
}
