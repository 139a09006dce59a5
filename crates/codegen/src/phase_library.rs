//! The library that looks the phase functions up, and how each language reaches the table.

use crate::error_card::spread;
use crate::language::{Glue, Library};
use crate::phase::{COUNT, warped};
use crate::shader::{cases, medium_line};
use crate::text::{banner, fill, literal};
use crate::{Inputs, PhaseRow, Target};
use stratiform_quantities::angle_map::place;

/// Angles of the embedded self-test, degrees: peak, sides, fogbow, glory.
const TESTED_DEG: [f64; 8] = [0.0, 0.3, 2.0, 20.0, 90.0, 142.0, 178.0, 180.0];

/// The library, which carries the table where the language has no trouble with long constant arrays.
pub(crate) fn library(inputs: &Inputs) -> Library<'static> {
    let (p, squared): (Vec<_>, Vec<_>) = warped(inputs).iter().map(|row| (row.p, row.p_squared)).unzip();
    let medium = &inputs.parameters.medium;
    let tested = |value: &dyn Fn(f64) -> f64| {
        cases(&TESTED_DEG.iter().map(|theta_deg| literal(value(*theta_deg))).collect::<Vec<_>>())
    };
    let places = [
        ("COUNT", COUNT.to_string()),
        ("WIDE_SCALE", literal(1.0 / (1.0 - medium.forward_fraction))),
        ("WIDE_EDGE", literal(versine(medium.theta_f_deg))),
        ("TEST_COUNT", TESTED_DEG.len().to_string()),
        ("TEST_V", tested(&versine)),
        ("TEST_P", tested(&|theta_deg| looked_up(&p, theta_deg))),
        ("TEST_SQUARED", tested(&|theta_deg| looked_up(&squared, theta_deg))),
    ];
    let code = fill(include_str!("wgsl/phase.wgsl"), &places);
    let table: Vec<_> = p.iter().chain(&squared).map(|value| literal(*value)).collect();
    let wavelength_um = medium.wavelength_um;
    let text = Box::new(move |target| access(target, &table, wavelength_um));
    let glue = Some(Glue { function: "stratiform_phase_texel", text });
    let (head, owner) = (head(inputs, &p, &squared), Some("StratiformPhase"));
    Library { head, name: "stratiform_phase", code, owner, glue, needs: Vec::new() }
}

fn head(inputs: &Inputs, p: &[f64], squared: &[f64]) -> String {
    banner(inputs, "Phase functions of the cloud, looked up in a table.")
        + "//\n\
           // Use        @USE@.\n\
           // Check      stratiform_phase_self_test() returns the number of wrong values: 0 if the table is in place.\n\
           // Table      two rows of STRATIFORM_PHASE_COUNT values: P of the full medium, then P_S convolved with itself;\n\
           //            columns p and p_squared of phase_warped.csv. C and Rust carry it.\n\
           // Units      v = 1 - cosTheta, cosTheta = +1 is forward. Take v, not cosTheta, near the forward direction:\n\
           //            v = |a - b|^2 / 2 of two unit directions of flight keeps the digits that cosTheta loses.\n\
           // Norm       1/2 integral of P over cosTheta is 1; P/(4 pi) is the density per steradian.\n\
           // Domain     v in [0, 2]. Single precision adds 2e-5 of the value at most, 2e-6 rad to an angle.\n"
        + &medium_line(inputs)
        + "// Grid's error relative to the tables at their own angles:\n"
        + &resampling("full", &inputs.phase.full, p)
        + &resampling("squared", &inputs.phase.squared, squared)
}

/// 1 - cosΘ of Θ in degrees.
pub(crate) fn versine(theta_deg: f64) -> f64 {
    let sine = libm::sin(0.5 * theta_deg.to_radians());
    2.0 * sine * sine
}

/// The warped grid at Θ, linear in the coordinate.
pub(crate) fn looked_up(grid: &[f64], theta_deg: f64) -> f64 {
    let (cell, share) = place(theta_deg, grid.len());
    grid[cell] + (grid[cell + 1] - grid[cell]) * share
}

/// Relative error of the grid at the rows of the table.
fn resampling(name: &str, rows: &[PhaseRow], grid: &[f64]) -> String {
    let errors = rows.iter().filter(|row| row.p > 0.0);
    let errors = errors.map(|row| (looked_up(grid, row.theta_deg) / row.p - 1.0).abs()).collect();
    spread(name, errors).map_or(String::new(), |card| {
        format!(
            "//   {name:<10} median {:.1e}, 95 % {:.1e}, worst {:.1e}\n",
            card.median, card.percentile_95, card.worst
        )
    })
}

/// The table and the function that reads it: the only text that is written per language.
fn access(target: Target, table: &[String], wavelength_um: f64) -> String {
    let numbers = |suffix: &str| {
        let lines = table
            .chunks(8)
            .map(|line| line.iter().map(|number| format!("{number}{suffix},")).collect::<Vec<_>>().join(" "));
        lines.map(|line| format!("    {line}\n")).collect::<String>()
    };
    let bound = "// The host binds the table here; change the binding to suit.\n";
    let read = "// Value `index` of row `row` of the table.\n";
    let indexed = format!("stratiform_phase_table[row * {COUNT}u + index]");
    let function = |head: &str, value: &str| format!("{read}{head} {{\n    return {value};\n}}\n\n");
    match target {
        Target::Wgsl => {
            format!("{bound}@group(0) @binding(0) var<storage, read> stratiform_phase_table: array<f32>;\n\n")
                + &function("fn stratiform_phase_texel(row: u32, index: u32) -> f32", &indexed)
        }
        Target::Glsl450 => {
            format!(
                "{bound}layout(std430, binding = 0) readonly buffer StratiformPhaseTable {{\n    float stratiform_phase_table[];\n}};\n\n"
            ) + &function("float stratiform_phase_texel(uint row, uint index)", &indexed)
        }
        Target::Glsl330 | Target::Glsl300Es => {
            let value = "texelFetch(stratiform_phase_table, ivec2(int(index), int(row)), 0).r";
            format!(
                "// The host binds the table here: a float texture {COUNT} wide. Its channel r holds P and P_S * P_S of {wavelength_um} um in the\n// first two rows, as that wavelength's channel of `stratiform export --texels {COUNT}` does.\nuniform highp sampler2D stratiform_phase_table;\n\n"
            ) + &function("float stratiform_phase_texel(uint row, uint index)", value)
        }
        Target::Hlsl => {
            format!("{bound}StructuredBuffer<float> stratiform_phase_table : register(t0);\n\n")
                + &function("float stratiform_phase_texel(uint row, uint index)", &indexed)
        }
        Target::Msl => {
            "// The table: StratiformPhase phase = {buffer}; phase.stratiform_phase(v).\n\
             const device float* stratiform_phase_table;\n\n"
                .to_owned()
                + &function("float stratiform_phase_texel(uint row, uint index) const", &indexed)
        }
        Target::C => {
            format!("static const float stratiform_phase_table[{}] = {{\n{}}};\n\n", 2 * COUNT, numbers("f"))
                + &function(
                    "static inline float stratiform_phase_texel(uint32_t row, uint32_t index)",
                    &indexed,
                )
        }
        Target::Rust => {
            let value = format!("STRATIFORM_PHASE_TABLE[(row * {COUNT} + index) as usize]");
            format!(
                "/// P of the full medium, then P_S convolved with itself.\npub static STRATIFORM_PHASE_TABLE: [f32; {}] = [\n{}];\n\n",
                2 * COUNT,
                numbers("")
            ) + &format!(
                "/{read}pub fn stratiform_phase_texel(row: u32, index: u32) -> f32 {{\n    {value}\n}}\n\n"
            )
        }
        Target::Spirv => String::new(),
    }
}
