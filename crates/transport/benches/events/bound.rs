//! The cost per event of what no tracer of this kind can do without, each as a loop over arrays that the first cache
//! holds: two random words, a logarithm, a cosine, a table look-up and a square root.

use std::hint::black_box;
use std::time::Instant;
use stratiform_optics::sampling::LinearPieces;
use stratiform_transport::Instructions;
use stratiform_transport::single::{azimuth_cosine, flight_path};

const N: usize = 128;
const MULTIPLIER: u64 = 6_364_136_223_846_793_005;

/// Inputs and outputs of every loop.
#[repr(C, align(64))]
pub struct Arrays {
    state: [u64; N],
    increment: [u64; N],
    words: [[u32; N]; 2],
    numbers: [f32; N],
}

impl Arrays {
    fn new() -> Self {
        let hash = |k: usize| (k as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let words = std::array::from_fn(|row| std::array::from_fn(|k| (hash(2 * k + row) >> 32) as u32));
        let (state, increment) = (std::array::from_fn(hash), std::array::from_fn(|k| hash(k + N) | 1));
        Self { state, increment, words, numbers: [0.3; N] }
    }
}

#[inline(always)]
fn draw(arrays: &mut Arrays) {
    for row in 0..2 {
        let halves: &[[u32; 2]; N] = bytemuck::cast_ref(&arrays.state);
        for (word, &[low, high]) in arrays.words[row].iter_mut().zip(halves) {
            *word = (((high << 5) | (low >> 27)) ^ (high >> 13)).rotate_right(high >> 27);
        }
        for k in 0..N {
            arrays.state[k] = arrays.state[k].wrapping_mul(MULTIPLIER).wrapping_add(arrays.increment[k]);
        }
    }
}

#[inline(always)]
fn logarithm(arrays: &mut Arrays) {
    for k in 0..N {
        arrays.numbers[k] = flight_path(arrays.words[0][k]);
    }
}

#[inline(always)]
fn cosine(arrays: &mut Arrays) {
    for k in 0..N {
        arrays.numbers[k] = azimuth_cosine(arrays.words[0][k]);
    }
}

#[inline(always)]
fn look_up(arrays: &mut Arrays, table: &LinearPieces) {
    arrays.numbers = table.sample_all(&arrays.words[0]);
}

#[inline(always)]
fn root(arrays: &mut Arrays) {
    for k in 0..N {
        arrays.numbers[k] = arrays.numbers[k].sqrt();
    }
}

/// Runs one of the five loops.
#[inline(always)]
fn run(part: usize, arrays: &mut Arrays, table: &LinearPieces) {
    match part {
        0 => draw(arrays),
        1 => logarithm(arrays),
        2 => cosine(arrays),
        3 => look_up(arrays, table),
        _ => root(arrays),
    }
}

#[multiversion::multiversion(targets(
    "x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl+avx512vbmi2+avx2+fma",
    "x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl+avx2+fma",
    "x86_64+avx2",
    "aarch64+neon"
))]
fn widest(part: usize, arrays: &mut Arrays, table: &LinearPieces) {
    run(part, arrays, table);
}

#[multiversion::multiversion(targets("x86_64+avx2"))]
fn avx2(part: usize, arrays: &mut Arrays, table: &LinearPieces) {
    run(part, arrays, table);
}

/// Names of the parts.
pub const PARTS: [&str; 5] = ["2 words", "logarithm", "cosine", "look-up", "root"];

/// ns per event of each part: the fastest of many short runs.
pub fn measure(instructions: Instructions, table: &LinearPieces) -> [f64; 5] {
    let function = match instructions {
        Instructions::Widest => widest,
        Instructions::Avx2 => avx2,
        Instructions::Portable => run,
    };
    let mut arrays = Arrays::new();
    std::array::from_fn(|part| {
        let mut best = f64::INFINITY;
        for _ in 0..300 {
            let start = Instant::now();
            for _ in 0..500 {
                function(part, black_box(&mut arrays), table);
            }
            best = best.min(start.elapsed().as_secs_f64() * 1e9 / (500 * N) as f64);
        }
        best
    })
}
