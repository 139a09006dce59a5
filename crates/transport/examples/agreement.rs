//! Both photon tracers against the deterministic solver over the designed grid of `tests/common/agreement.rs`.
//!
//! Arguments: photons of the half-space tracer in a thin slab (default 1e7; a slab of thickness τ gets 1/(1 + τ/10) of them,
//! the plain tracer a twentieth), seed. One line a case: p of χ² over all endings, and the case's largest z. Exit code 1 if
//! tracers and solver disagree; false alarms: at most 4 of 1000 seeds.

#![expect(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a program that prints, or stops where it fails"
)]

#[path = "../tests/common/mod.rs"]
mod common;

use common::agreement::{Agreement, Budget, Row};
use std::process::ExitCode;
use stratiform_quantities::Order;
use stratiform_transport::Quantity;

/// Of each of the four judgements.
const ALPHA: f64 = 1e-3;

fn short(quantity: Quantity) -> String {
    match quantity {
        Quantity::Reflectance(order) => format!("R {order}"),
        Quantity::Transmittance(order) => format!("T {order}"),
    }
}

fn print(row: &Row) {
    let worst = row.scores.iter().max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()));
    let of_case = format!("{}{:>10}{:>8.3}", row.case.name(), row.photons, row.chi_square.p_value);
    let Some(score) = worst else { return println!("{of_case}") };
    println!(
        "{of_case}  {:<8}{:>11.7}{:>11.7}{:>9.1e}{:>9.1e}{:>7.2}",
        short(score.quantity),
        score.traced,
        score.solved.value,
        score.std_error,
        score.solved.std_error,
        score.z
    );
}

fn summary(grid: &Agreement) {
    println!("{} numbers of {} cases", grid.numbers(), grid.rows.len());
    println!("largest |z| {:.2}, threshold {:.2}", grid.worst().1.z.abs(), grid.threshold(ALPHA));
    let scores = || grid.rows.iter().flat_map(|row| &row.scores);
    let ratio = scores().fold(0.0_f64, |most, score| most.max(score.solved.std_error / score.std_error));
    println!("largest solver error {ratio:.1e} standard errors");
    for (name, order) in [
        ("order 1", Order::Exactly(1)),
        ("order 2", Order::Exactly(2)),
        ("tail", Order::Tail),
        ("total", Order::Total),
    ] {
        let chosen = scores().filter(|score| {
            matches!(score.quantity, Quantity::Reflectance(o) | Quantity::Transmittance(o) if o == order)
        });
        let (count, sum) = chosen.fold((0, 0.0), |(count, sum), score| (count + 1, sum + score.z * score.z));
        println!("mean z² of {name:<8}{:>6.2} ({count} numbers)", sum / f64::from(count));
    }
    let (normal, uniform) = (grid.drawn_are_normal(), grid.chi_squares_are_uniform());
    println!("one z of each case, normal: D {:.3}, p {:.3}", normal.statistic, normal.p_value);
    println!("p of chi-square, uniform:   D {:.3}, p {:.3}", uniform.statistic, uniform.p_value);
}

fn main() -> ExitCode {
    let photons = std::env::args().nth(1).map_or(1e7, |text| text.parse().unwrap());
    let seed = std::env::args().nth(2).map_or(1, |text| text.parse().unwrap());
    let grid = Agreement::new(Budget { photons, plain_share: 0.05, seed, tolerance: 1e-7 });
    println!(
        "{:<15}{:<11}{:>6} {:>8} {:>5}{:>10}{:>8}  {:<8}{:>11}{:>11}{:>9}{:>9}{:>7}",
        "phase function",
        "tracer",
        "tau",
        "mu0",
        "omega",
        "photons",
        "p",
        "largest",
        "traced",
        "solved",
        "sigma",
        "error",
        "z"
    );
    grid.rows.iter().for_each(print);
    summary(&grid);
    if grid.accepts(ALPHA) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
