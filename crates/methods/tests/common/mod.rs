//! The paper's cloud, from the accepted tables.

use stratiform_methods::Cloud;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::SingleScatteringAlbedo;

const PHASE: &str = include_str!("../../../../fit-configs/appendix-b/accepted/phase_full.csv");

/// θ_f of the paper, degrees.
pub const THETA_F_DEG: f64 = 5.0;

pub fn phase() -> PhaseTable {
    let rows = PHASE.lines().skip(1).map(|line| {
        let (theta, p) = line.split_once(',').unwrap();
        (theta.parse::<f64>().unwrap(), p.parse::<f64>().unwrap())
    });
    let (theta, p): (Vec<_>, Vec<_>) = rows.unzip();
    PhaseTable::new(theta, p, Norm::Strict).unwrap()
}

pub fn cloud(omega: f64) -> Cloud {
    let omega = SingleScatteringAlbedo::new(omega).unwrap();
    Cloud::new(phase(), omega, THETA_F_DEG, Some(7.0)).unwrap()
}
