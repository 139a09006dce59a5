//! Clouds (mu_l, radius_um, tau) from stdin, mu_l = -1 for diffuse light; to stdout the self-test's count, then nine fluxes each.

#[path = "stratiform.rs"]
mod stratiform;
#[path = "library.rs"]
mod stratiform_family;

use std::io::{Read, Write};

fn main() -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input)?;
    let mut output = vec![stratiform_family::stratiform_family_self_test() as f32];
    for cloud in input.chunks_exact(12) {
        let float = |at: usize| f32::from_le_bytes([cloud[at], cloud[at + 1], cloud[at + 2], cloud[at + 3]]);
        let (mu_l, radius_um, tau) = (float(0), float(4), float(8));
        let f = if mu_l < 0.0 {
            stratiform_family::stratiform_family_diffuse(radius_um, tau)
        } else {
            stratiform_family::stratiform_family_beam(mu_l, radius_um, tau)
        };
        output.extend([f.t_ms, f.r_ms, f.t_zero, f.t_one, f.t_two, f.t_three_plus, f.r_one, f.r_two, f.r_three_plus]);
    }
    let bytes: Vec<u8> = output.into_iter().flat_map(f32::to_le_bytes).collect();
    std::io::stdout().write_all(&bytes)
}
