//! Numbers v from stdin; to stdout the self-test's count, then P, P_S, P_S convolved with itself, and the angle from the
//! table's coordinate of v.

#[path = "library.rs"]
mod stratiform_phase;

use std::io::{Read, Write};
use stratiform_phase as phase;

fn main() -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input)?;
    let mut output = vec![phase::stratiform_phase_self_test() as f32];
    for four in input.chunks_exact(4) {
        let v = f32::from_le_bytes([four[0], four[1], four[2], four[3]]);
        output.extend([
            phase::stratiform_phase(v),
            phase::stratiform_phase_modified(v),
            phase::stratiform_phase_squared(v),
            phase::stratiform_phase_angle(phase::stratiform_phase_coordinate(phase::stratiform_arc(v))),
        ]);
    }
    let bytes: Vec<u8> = output.into_iter().flat_map(f32::to_le_bytes).collect();
    std::io::stdout().write_all(&bytes)
}
