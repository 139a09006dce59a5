//! (v, radius_um) from stdin; to stdout the self-test's count, then P, P_S and P_S convolved with itself.

#[path = "library.rs"]
mod stratiform_family_phase;
mod stratiform_phase;

use std::io::{Read, Write};
use stratiform_family_phase as family;

fn main() -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input)?;
    let mut output = vec![family::stratiform_family_phase_self_test() as f32];
    for pair in input.chunks_exact(8) {
        let float = |i: usize| f32::from_le_bytes([pair[i], pair[i + 1], pair[i + 2], pair[i + 3]]);
        let (v, radius_um) = (float(0), float(4));
        output.extend([
            family::stratiform_family_phase(v, radius_um),
            family::stratiform_family_phase_modified(v, radius_um),
            family::stratiform_family_phase_squared(v, radius_um),
        ]);
    }
    let bytes: Vec<u8> = output.into_iter().flat_map(f32::to_le_bytes).collect();
    std::io::stdout().write_all(&bytes)
}
