//! The emitted phase look-up in every language, executed, against the same look-up in double precision.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use std::f64::consts::{PI, TAU};
use std::sync::OnceLock;
use stratiform_tests::languages::library::{PHASE, Run};
use stratiform_tests::languages::signatures::signatures;
use stratiform_tests::languages::tools::available;
use stratiform_tests::languages::ways::ways;
use stratiform_tests::languages::{Emitted, shaders};
use stratiform_tests::{accepted_cloud, paper_config};

/// Largest relative error. A place between two of 1024 directions is rounded to 1e-4 of their distance.
const RELATIVE: f64 = 2e-5;
/// Largest error of an angle in radians.
const ANGLE: f64 = 2e-6;

/// The emitted table, and what P_S needs.
struct Phase {
    emitted: Emitted,
    p: Vec<f64>,
    squared: Vec<f64>,
    forward_fraction: f64,
    edge: f64,
}

fn phase() -> &'static Phase {
    static PHASE: OnceLock<Phase> = OnceLock::new();
    PHASE.get_or_init(|| {
        let emitted = Emitted::committed();
        let text = emitted.text("phase_warped.csv");
        let column = |i: usize| {
            text.lines().skip(1).map(move |line| line.split(',').nth(i).unwrap().parse().unwrap()).collect()
        };
        let (p, squared) = (column(2), column(3));
        let medium = accepted_cloud(&paper_config()).0.medium;
        let sine = libm::sin(0.5 * medium.theta_f_deg.to_radians());
        let (forward_fraction, edge) = (medium.forward_fraction, 2.0 * sine * sine);
        Phase { emitted, p, squared, forward_fraction, edge }
    })
}

impl Phase {
    /// Both rows, as the host binds them.
    fn table(&self) -> Vec<u8> {
        self.p.iter().chain(&self.squared).flat_map(|value| (*value as f32).to_le_bytes()).collect()
    }

    /// P, P_S, P_S convolved with itself, and Θ at v = 1 - cosΘ.
    fn exact(&self, v: f64) -> [f64; 4] {
        let theta = 2.0 * libm::asin((0.5 * v).sqrt().min(1.0));
        let place = if theta < 0.5 * PI { (theta / TAU).sqrt() } else { 1.0 - ((PI - theta) / TAU).sqrt() };
        let place = place * (self.p.len() - 1) as f64;
        let cell = (place as usize).min(self.p.len() - 2);
        let at = |row: &[f64]| row[cell] + (row[cell + 1] - row[cell]) * (place - cell as f64);
        let p = at(&self.p);
        let wide = if v < self.edge { 0.0 } else { p / (1.0 - self.forward_fraction) };
        [p, wide, at(&self.squared), theta]
    }

    /// Largest relative error of the three functions and the largest of the angle; infinite if one is no number.
    fn errors(&self, v: &[f32], values: &[f32]) -> [f64; 2] {
        let mut worst = [0.0_f64; 2];
        assert_eq!(values.len(), 4 * v.len());
        for (v, values) in v.iter().zip(values.chunks(4)) {
            for (i, exact) in self.exact(f64::from(*v)).into_iter().enumerate() {
                let error = (f64::from(values[i]) - exact).abs();
                let scale = if i == 3 || exact == 0.0 { 1.0 } else { exact };
                let error = if error.is_nan() { f64::INFINITY } else { error / scale };
                worst[i / 3] = worst[i / 3].max(error);
            }
        }
        worst
    }
}

/// v from both ends to the middle, graded as the angles where peak and glory are.
fn inputs() -> Vec<f32> {
    let angle = |i: i32| {
        let share = f64::from(i) / 200.0;
        if i <= 200 { 90.0 * share * share * share } else { 90.0 * share }
    };
    let v = |degrees: f64| {
        let sine = libm::sin(0.5 * degrees.to_radians());
        (2.0 * sine * sine) as f32
    };
    (0..=400).map(|i| v(angle(i))).collect()
}

fn reproduces_the_table(ending: &str) {
    let (phase, v) = (phase(), inputs());
    let input: Vec<u8> = v.iter().flat_map(|v| v.to_le_bytes()).collect();
    let table = phase.table();
    let host = !matches!(ending, "h" | "rs");
    let run = Run { library: &PHASE, table: host.then_some(&table), input: &input, beside: &[] };
    let text = phase.emitted.text(&format!("stratiform_phase.{ending}"));
    // The coefficient of x in the arc, a thousandth off.
    let planted = text.replacen("0.2145988016", "0.2148134004", 1);
    assert_ne!(planted, text);
    for way in ways(ending) {
        let Some(output) = way.execute(&run, &text) else { continue };
        let [relative, angle] = phase.errors(&v, &output.values);
        println!("{:<24} relative {relative:.1e}, angle {angle:.1e}", way.name);
        assert!(relative < RELATIVE && angle < ANGLE, "{}: {relative:e} {angle:e}", way.name);
        assert_eq!(output.wrong, 0, "{}: the embedded self-test", way.name);
        let output = way.execute(&run, &planted).unwrap();
        let [relative, angle] = phase.errors(&v, &output.values);
        assert!(relative > RELATIVE && angle > ANGLE && output.wrong > 0, "{}: planted", way.name);
    }
}

#[test]
fn c_and_cpp_reproduce_the_table() {
    reproduces_the_table("h");
}

#[test]
fn rust_reproduces_the_table() {
    reproduces_the_table("rs");
}

#[test]
fn metal_reproduces_the_table() {
    reproduces_the_table("metal");
}

#[test]
fn glsl_reproduces_the_table() {
    reproduces_the_table("450.glsl");
}

#[test]
fn hlsl_reproduces_the_table() {
    reproduces_the_table("hlsl");
}

#[test]
fn wgsl_reproduces_the_table() {
    reproduces_the_table("wgsl");
}

#[test]
fn older_glsl_compiles() {
    for (ending, version) in [("330.glsl", "330"), ("300es.glsl", "300 es")] {
        let text = phase().emitted.text(&format!("stratiform_phase.{ending}"));
        available(shaders::glsl_fragment(version, &PHASE, &text), &[]);
        let broken = shaders::glsl_fragment(version, &PHASE, &text.replace("sqrt(", "root("));
        assert!(!matches!(broken, Ok(())), "{ending}: a planted slip");
    }
}

/// As methods of a structure in Metal's language, as functions elsewhere.
#[test]
fn every_language_exports_the_same() {
    let exported = signatures(&phase().emitted.text("stratiform_phase.wgsl"));
    assert!(exported.len() > 8, "guard against checking nothing");
    for ending in ["450.glsl", "330.glsl", "300es.glsl", "hlsl", "metal", "h", "rs"] {
        let text = phase().emitted.text(&format!("stratiform_phase.{ending}"));
        let text = text.replacen("struct StratiformPhase {", "", 1);
        assert_eq!(signatures(&text), exported, "{ending}");
    }
}
