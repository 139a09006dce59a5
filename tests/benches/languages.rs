//! What one evaluation costs, f32, one thread, in C and in Rust: `stratiform_beam`, all nine fluxes of one (μ_l, τ);
//! `stratiform_radiance_top` and `_bottom`, fluxes and phase functions included; `stratiform_halo`;
//! `stratiform_shade_top`, `_bottom`, and `_top_with` where all sights share a thickness. And the bytes of every
//! target. `cargo bench -p stratiform-tests --bench languages`

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

/// μ_l, μ_v uniform, v uniform, as for directions of the whole sphere, τ log-uniform from 0.01 to 100.
fn sights() -> Vec<u8> {
    let mut random = photon_stream(key(2, Purpose::Calibration), 0);
    let mut share = || f64::from(random.next_u32()) / f64::from(u32::MAX);
    let mut sight = || [share(), share(), 2.0 * share(), libm::exp10(4.0 * share() - 2.0)];
    (0..PAIRS).flat_map(|_| sight()).flat_map(|x| (x as f32).to_le_bytes()).collect()
}

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

/// A driver and what it is run on.
struct Cost<'a> {
    emitted: &'a Emitted,
    c: &'a str,
    rust: &'a str,
    /// Emitted files that it wants, without ending.
    files: &'a [&'a str],
    input: Vec<u8>,
}

impl Cost<'_> {
    fn measure(
        &self,
        ending: &str,
        compiler: &'static str,
        options: &[&str],
    ) -> Result<(f64, f64), ToolError> {
        let scratch = Scratch::new()?;
        let source = if ending == "h" { ("cost.c", self.c) } else { ("cost.rs", self.rust) };
        scratch.write(source.0, source.1)?;
        for file in self.files {
            let name = format!("{file}.{ending}");
            scratch.write(&name, self.emitted.text(&name))?;
        }
        scratch.run(compiler, &[&[source.0, "-o", "cost"], options].concat())?;
        Ok(times(&scratch.run_program("cost", &self.input)?))
    }

    /// `function`: in C and in Rust, as every processor runs it and as this one does.
    fn print(&self, function: &str) {
        println!("\nns per {function:<26} median  least");
        let (define, cfg) = (format!("-DCOST_FUNCTION={function}"), format!("{function:?}"));
        let cfg = format!("cost_function={cfg}");
        let c = |more: &[&str]| self.measure("h", "gcc", &[&["-std=c99", "-O3", &define], more].concat());
        let rust = ["--edition", "2024", "-C", "opt-level=3", "--cfg", &cfg];
        let rust = |more: &[&str]| self.measure("rs", "rustc", &[&rust, more].concat());
        for (name, measured) in [
            ("C, gcc -O3", c(&["-lm"])),
            ("C, gcc -O3 -march=native", c(&["-march=native", "-lm"])),
            ("Rust, opt-level 3", rust(&[])),
            ("Rust, opt-level 3, native", rust(&["-C", "target-cpu=native"])),
        ] {
            if let Some((median, least)) = available(measured, &[]) {
                println!("{name:<32} {median:>6.1} {least:>6.1}");
            }
        }
    }
}

fn costs(emitted: &Emitted) {
    let fluxes = Cost {
        emitted,
        c: include_str!("../src/languages/drivers/fluxes/cost.c"),
        rust: include_str!("../src/languages/drivers/fluxes/cost.rs"),
        files: &["stratiform"],
        input: input(),
    };
    fluxes.print("stratiform_beam");
    let radiance = Cost {
        emitted,
        c: include_str!("../src/languages/drivers/radiance/cost.c"),
        rust: include_str!("../src/languages/drivers/radiance/cost.rs"),
        files: &[
            "stratiform",
            "stratiform_weights",
            "stratiform_phase",
            "stratiform_radiance",
            "stratiform_shade",
            "stratiform_halo",
        ],
        input: sights(),
    };
    for function in [
        "stratiform_radiance_top",
        "stratiform_radiance_bottom",
        "stratiform_halo",
        "stratiform_shade_top",
        "stratiform_shade_bottom",
        "stratiform_shade_top_with",
    ] {
        radiance.print(function);
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
