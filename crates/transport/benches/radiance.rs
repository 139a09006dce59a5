//! Time and streams of radiance: `cargo bench -p stratiform-transport --bench radiance`. Prints figures, asserts nothing.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark stops where it fails and prints")]

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;
use stratiform_optics::phase::{Modified, Norm, PhaseTable};
use stratiform_quantities::{Side, SingleScatteringAlbedo};
use stratiform_transport::TraceMedium;
use stratiform_transport::solve::{RadianceSolver, SolveMedium, View};

fn main() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let cloud = Arc::new(PhaseTable::read(Path::new(file), Norm::Strict).unwrap());
    let lossless = SingleScatteringAlbedo::CONSERVATIVE;
    let full = SolveMedium::full(cloud.clone(), lossless);
    let cut = Modified::new(cloud, 5.0).unwrap();
    let forward = cut.forward_fraction();
    let modified = TraceMedium::modified(Arc::new(cut), lossless, forward).unwrap();
    let views = [(Side::Top, 180.0, "glory"), (Side::Top, 90.0, "aside"), (Side::Bottom, 0.0, "sun")];
    for (name, medium) in [("full", full), ("modified", SolveMedium::from(&modified))] {
        for tolerance in [1e-2, 1e-3, 1e-4] {
            let solver = RadianceSolver::new(medium.clone(), tolerance).unwrap();
            for (side, phi_deg, place) in views {
                for tau in [1.0, 5.0, 16.0] {
                    let start = Instant::now();
                    let solved = solver.radiance(&[tau], &[0.5], &[View { side, mu: 0.5, phi_deg }]);
                    let seconds = start.elapsed().as_secs_f64();
                    match solved {
                        Ok(solved) => println!(
                            "{name}, {tolerance:e}, {place}, tau {tau}: {:.1} ms, {} streams, error {:.1e}",
                            1e3 * seconds,
                            solved.streams(),
                            solved.worst_error()
                        ),
                        Err(error) => println!("{name}, {tolerance:e}, {place}, tau {tau}: {error}"),
                    }
                }
            }
        }
    }
}
