//! What the angular model's radiances integrate to, against the solver.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use stratiform_artifact::AngularBooksRow;
use stratiform_cli::pipeline::angular_books;
use stratiform_quantities::{Order, Side};
use stratiform_tests::{accepted_cloud, paper_config};

fn books() -> Vec<AngularBooksRow> {
    let config = paper_config();
    let (parameters, cloud) = accepted_cloud(&config);
    angular_books::rows(&config, &cloud, &parameters, &[1.0, 5.0, 20.0, 100.0]).unwrap()
}

#[test]
fn print_all() {
    for row in books() {
        println!(
            "{} {:.4} {} {} {:?} {:.6} {:.6} {:.6} ratio {:.4}",
            row.theta_l_deg,
            row.tau,
            row.side,
            row.order,
            row.form,
            row.integral,
            row.one_dimensional_model,
            row.solver,
            row.integral / row.solver
        );
    }
}
