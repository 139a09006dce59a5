//! Pairs (mu_l, tau) from stdin; nanoseconds per evaluation to stdout, one line per repeat.

mod stratiform;

use std::hint::black_box;
use std::io::Read;
use std::time::Instant;

const WARM: usize = 50;
const REPEATS: usize = 401;

fn main() -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input)?;
    let float = |four: &[u8]| f32::from_le_bytes([four[0], four[1], four[2], four[3]]);
    let pairs: Vec<[f32; 2]> = input.chunks_exact(8).map(|pair| [float(&pair[..4]), float(&pair[4..])]).collect();
    for repeat in 0..WARM + REPEATS {
        let start = Instant::now();
        let mut sum = 0.0;
        for [mu_l, tau] in black_box(&pairs) {
            let f = stratiform::stratiform_beam(*mu_l, *tau);
            sum += f.t_ms + f.r_ms + f.t_zero + f.t_one + f.t_two + f.t_three_plus + f.r_one + f.r_two + f.r_three_plus;
        }
        black_box(sum);
        if repeat >= WARM {
            println!("{:.3}", start.elapsed().as_nanos() as f64 / pairs.len() as f64);
        }
    }
    Ok(())
}
