//! What one evaluation costs: `stratiform_beam`, all nine fluxes of one (μ_l, τ), f32, one thread, in C and in Rust; and
//! the bytes of every target. `cargo bench -p stratiform-tests --bench languages`

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a benchmark prints, and may stop where it fails"
)]

use rand::Rng as _;
use stratiform_stats::{Purpose, key, photon_stream};
use stratiform_tests::languages::Emitted;
use stratiform_tests::languages::tools::{Scratch, ToolError, available};
use stratiform_tests::{accepted_cloud, paper_config};

/// Inputs per repeat: they stay in the first cache.
const PAIRS: usize = 2048;

/// μ_l uniform, τ log-uniform from 0.01 to 100.
fn input() -> Vec<u8> {
    let mut random = photon_stream(key(1, Purpose::Calibration), 0);
    let mut share = || f64::from(random.next_u32()) / f64::from(u32::MAX);
    let mut pair = || [share() as f32, libm::exp10(4.0 * share() - 2.0) as f32];
    (0..PAIRS).flat_map(|_| pair()).flat_map(f32::to_le_bytes).collect()
}

/// Median of the nanoseconds that the compiled program printed, one per repeat, and the fastest.
fn times(printed: &[u8]) -> (f64, f64) {
    let printed = String::from_utf8_lossy(printed);
    let mut times: Vec<f64> = printed.lines().map(|line| line.parse().unwrap()).collect();
    times.sort_by(f64::total_cmp);
    (times[times.len() / 2], times[0])
}

fn measure(
    compiler: &'static str,
    options: &[&str],
    source: (&str, &str),
    text: (&str, &str),
) -> Result<(f64, f64), ToolError> {
    let scratch = Scratch::new()?;
    scratch.write(source.0, source.1)?;
    scratch.write(text.0, text.1)?;
    scratch.run(compiler, &[&[source.0, "-o", "cost"], options].concat())?;
    Ok(times(&scratch.run_program("cost", &input())?))
}

fn costs(emitted: &Emitted) {
    let (c, rust) = (emitted.text("stratiform.h"), emitted.text("stratiform.rs"));
    let c = |options: &[&str]| {
        measure(
            "gcc",
            &[&["-std=c99"], options].concat(),
            ("cost.c", include_str!("../src/languages/drivers/fluxes/cost.c")),
            ("stratiform.h", &c),
        )
    };
    let rust = |options: &[&str]| {
        measure(
            "rustc",
            &[&["--edition", "2024", "-C", "opt-level=3"], options].concat(),
            ("cost.rs", include_str!("../src/languages/drivers/fluxes/cost.rs")),
            ("stratiform.rs", &rust),
        )
    };
    println!("ns per stratiform_beam           median  least");
    for (name, measured) in [
        ("C, gcc -O3", c(&["-O3", "-lm"])),
        ("C, gcc -O3 -march=native", c(&["-O3", "-march=native", "-lm"])),
        ("Rust, opt-level 3", rust(&[])),
        ("Rust, opt-level 3, native", rust(&["-C", "target-cpu=native"])),
    ] {
        if let Some((median, least)) = available(measured, &[]) {
            println!("{name:<32} {median:>6.1} {least:>6.1}");
        }
    }
}

/// Every emitted text's bytes, and without comments and empty lines.
fn sizes(emitted: &Emitted) {
    let rows = accepted_cloud(&paper_config()).0.optical.rows.len();
    let directions = emitted.text("phase_warped.csv").lines().count() - 1;
    // Five parameters a row and mu_l, but none in diffuse light; the slope and the modified medium's extinction.
    println!("\ntable of parameters as f32 {:>10} bytes", 4 * (6 * rows - 1 + 2));
    println!("table of P and P_S^2 as f32 {:>9} bytes", 4 * 2 * directions);
    println!("\nfile                             bytes  without comments");
    for name in emitted.names().into_iter().filter(|name| name.starts_with("stratiform")) {
        let bytes = emitted.bytes(&name);
        let text = String::from_utf8_lossy(&bytes);
        let code = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with("//");
        let code: usize = text.lines().filter(code).map(|line| line.len() + 1).sum();
        match name.ends_with(".spv") {
            true => println!("{name:<30} {:>7}", bytes.len()),
            false => println!("{name:<30} {:>7} {code:>7}", bytes.len()),
        }
    }
}

fn main() {
    let emitted = Emitted::committed();
    costs(&emitted);
    sizes(&emitted);
}
