//! Pairs (mu_l, tau) from stdin, mu_l = -1 for diffuse light; to stdout the self-test's count, then nine fluxes each.

#[path = "library.rs"]
mod stratiform;

use std::io::{Read, Write};

fn main() -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input)?;
    let mut output = vec![stratiform::stratiform_self_test() as f32];
    for pair in input.chunks_exact(8) {
        let float = |at: usize| f32::from_le_bytes([pair[at], pair[at + 1], pair[at + 2], pair[at + 3]]);
        let (mu_l, tau) = (float(0), float(4));
        let f =
            if mu_l < 0.0 { stratiform::stratiform_diffuse(tau) } else { stratiform::stratiform_beam(mu_l, tau) };
        output.extend([f.t_ms, f.r_ms, f.t_zero, f.t_one, f.t_two, f.t_three_plus, f.r_one, f.r_two, f.r_three_plus]);
    }
    let bytes: Vec<u8> = output.into_iter().flat_map(f32::to_le_bytes).collect();
    std::io::stdout().write_all(&bytes)
}
