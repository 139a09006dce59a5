//! The emitted fluxes and phase functions over effective radius in every language, executed, against the f64 model; and
//! their self-tests. Each
//! once more with one parameter of a table a thousandth off: both see it.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use std::sync::OnceLock;
use stratiform_artifact::{FamilyDocument, FamilyMember, read_csv};
use stratiform_cli::config::Config;
use stratiform_cli::pipeline::accepted;
use stratiform_codegen::{FamilyVector, SelfTest, SelfTestVector, Target};
use stratiform_model::family::{PhaseFamily, PhaseMember};
use stratiform_quantities::Incidence;
use stratiform_quantities::angle_map::coordinate;
use stratiform_tests::languages::comparator::{errors, summary, wrong};
use stratiform_tests::languages::library::{FAMILY, FAMILY_PHASE, Run};
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

stratiform_tests::in_every_language!(reproduces_the_model);

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

/// Largest relative error of a phase function in single precision, which the header of the look-up states.
const PHASE_RELATIVE: f64 = 2e-5;

/// Angles in degrees: peak, both sides of theta_f, side, fogbow, glory.
const THETA_DEG: [f64; 7] = [0.0, 0.3, 4.0, 6.0, 60.0, 142.0, 179.5];

/// (v, r_e) exactly in f32 at and between the radii, and P, P_S and P_S convolved with itself there.
fn phase_vectors() -> Vec<([f64; 2], [f64; 3])> {
    let members = &family().document.members;
    let table = |values: &dyn Fn(&FamilyMember) -> Vec<f64>| {
        let member = |one: &FamilyMember| PhaseMember {
            effective_radius_um: one.effective_radius_um,
            values: values(one),
        };
        PhaseFamily::<f64>::new(&members.iter().map(member).collect::<Vec<_>>()).unwrap()
    };
    let full = table(&|one| one.phase.clone());
    let squared = table(&|one| one.phase_squared.clone());
    let forward = table(&|one| vec![one.parameters.medium.forward_fraction; 2]);
    let edge_deg = members[0].parameters.medium.theta_f_deg;
    let nodes = members.iter().map(|one| one.effective_radius_um);
    let between = members.windows(2).map(|w| 0.6 * w[0].effective_radius_um + 0.4 * w[1].effective_radius_um);
    let radii = nodes.chain(between).map(|radius| f64::from(radius as f32));
    let vector = |radius: f64, theta_deg: f64| {
        let sine = libm::sin(0.5 * theta_deg.to_radians());
        let v = f64::from((2.0 * sine * sine) as f32);
        let theta_deg = (2.0 * libm::asin((0.5 * v).sqrt())).to_degrees();
        let u = coordinate(theta_deg);
        let p = full.at(u, radius).unwrap();
        let wide = if theta_deg < edge_deg { 0.0 } else { p / (1.0 - forward.at(u, radius).unwrap()) };
        ([v, radius], [p, wide, squared.at(u, radius).unwrap()])
    };
    radii.flat_map(|radius| THETA_DEG.map(|theta_deg| vector(radius, theta_deg))).collect()
}

/// The table of the look-up: the cloud's two rows, P of every radius, P_S convolved with itself of every radius.
fn phase_table() -> Vec<u8> {
    let Family { emitted, document, .. } = family();
    let (full, squared) =
        (document.members.iter().map(|m| &m.phase), document.members.iter().map(|m| &m.phase_squared));
    let rows = full.chain(squared).flatten().flat_map(|value| (*value as f32).to_le_bytes());
    emitted.phase_table().into_iter().chain(rows).collect()
}

/// Largest error in units of what is allowed; infinite where a value is missing or no number.
fn worst_phase(values: &[f32]) -> f64 {
    let errors = phase_vectors().into_iter().enumerate().flat_map(|(k, (_, exact))| {
        exact.into_iter().enumerate().map(move |(i, exact)| {
            let value = values.get(3 * k + i).map_or(f64::NAN, |value| f64::from(*value));
            let error = (value - exact).abs() / (PHASE_RELATIVE * exact + 1e-20);
            if error.is_nan() { f64::INFINITY } else { error }
        })
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn phase_functions_reproduce_the_model_in_every_language() {
    let input = phase_vectors().into_iter().flat_map(|(input, _)| input);
    let input: Vec<u8> = input.flat_map(|x| (x as f32).to_le_bytes()).collect();
    let table = phase_table();
    for ending in ["h", "rs", "metal", "450.glsl", "hlsl", "wgsl"] {
        let emitted = &family().emitted;
        let beside = emitted.beside(&FAMILY_PHASE, ending);
        let tables = [&*table];
        let tables = if matches!(ending, "h" | "rs") { &[] } else { &tables[..] };
        let run = Run { library: &FAMILY_PHASE, tables, input: &input, beside: &beside };
        let text = emitted.text(&format!("stratiform_family_phase.{ending}"));
        let radius = format!("{:?}", family().document.members[4].effective_radius_um as f32);
        let planted = text.replacen(&radius, &format!("{:?}", radius.parse::<f32>().unwrap() * 1.01), 1);
        assert_ne!(planted, text);
        for way in ways(ending) {
            let Some(output) = way.execute(&run, &text) else { continue };
            let error = worst_phase(&output.values);
            println!("{:<24} {error:.2} of what is allowed", way.name);
            assert!(error < 1.0, "{}: {error}", way.name);
            assert_eq!(output.wrong, 0, "{}: the embedded self-test", way.name);
            let output = way.execute(&run, &planted).unwrap();
            assert!(worst_phase(&output.values) > 1.0 && output.wrong > 0, "{}: planted", way.name);
        }
    }
}
