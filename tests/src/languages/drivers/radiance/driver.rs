//! Sights (mu_l, mu_v, v, tau, shape) from stdin; to stdout the self-test's count, then the orders at both faces, both sums,
//! the transparency, L / F0 of factor 1, and the halo.

mod stratiform;
#[path = "library.rs"]
mod stratiform_halo;
mod stratiform_phase;
mod stratiform_radiance;
mod stratiform_weights;

use std::io::{Read, Write};
use stratiform_halo as halo;
use stratiform_radiance as radiance;
use stratiform_weights as weights;

fn main() -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input)?;
    let mut output = vec![(radiance::stratiform_radiance_self_test() + halo::stratiform_halo_self_test()) as f32];
    for sight in input.chunks_exact(20) {
        let float = |i: usize| f32::from_le_bytes([sight[4 * i], sight[4 * i + 1], sight[4 * i + 2], sight[4 * i + 3]]);
        let (mu_l, mu_v, v, tau, shape) = (float(0), float(1), float(2), float(3), float(4) as u32);
        let top = radiance::stratiform_orders_top(mu_l, mu_v, v, tau, shape);
        let bottom = radiance::stratiform_orders_bottom(mu_l, mu_v, v, tau, shape);
        output.extend([top.one, top.two, top.three_plus, bottom.one, bottom.two, bottom.three_plus]);
        output.extend([
            radiance::stratiform_radiance_top(mu_l, mu_v, v, tau, shape),
            radiance::stratiform_radiance_bottom(mu_l, mu_v, v, tau, shape),
            weights::stratiform_transparency(mu_v, tau),
            weights::stratiform_radiance_from_factor(1.0, mu_l),
            halo::stratiform_halo(mu_l, mu_v, v, tau),
        ]);
    }
    let bytes: Vec<u8> = output.into_iter().flat_map(f32::to_le_bytes).collect();
    std::io::stdout().write_all(&bytes)
}
