//! Sights (mu_l, mu_v, v, tau) from stdin; to stdout the self-test's count, then single scattering, the rest and both at the lit
//! face, and the same at the other.

mod stratiform;
mod stratiform_phase;
#[path = "library.rs"]
mod stratiform_shade;
mod stratiform_weights;

use std::io::{Read, Write};
use stratiform_shade::*;

fn main() -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input)?;
    let mut output = vec![stratiform_shade_self_test() as f32];
    for sight in input.chunks_exact(16) {
        let float = |i: usize| f32::from_le_bytes([sight[4 * i], sight[4 * i + 1], sight[4 * i + 2], sight[4 * i + 3]]);
        let (mu_l, mu_v, v, tau) = (float(0), float(1), float(2), float(3));
        let (depth, scaled) = (stratiform::STRATIFORM_KAPPA_S * tau, STRATIFORM_SIMILARITY * tau);
        let wide = stratiform_phase::stratiform_phase_modified(v);
        output.extend([
            stratiform_shade_once_top(mu_l, mu_v, wide, depth),
            stratiform_shade_more_top(stratiform_shade_of_top(scaled), mu_l, mu_v, v, scaled),
            stratiform_shade_top(mu_l, mu_v, v, tau),
            stratiform_shade_once_bottom(mu_l, mu_v, wide, depth),
            stratiform_shade_more_bottom(stratiform_shade_of_bottom(scaled), mu_l, mu_v, v, scaled),
            stratiform_shade_bottom(mu_l, mu_v, v, tau),
        ]);
    }
    let bytes: Vec<u8> = output.into_iter().flat_map(f32::to_le_bytes).collect();
    std::io::stdout().write_all(&bytes)
}
