//! The device's random streams against those of the CPU, word by word.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;

use device::device;
use rand::Rng;
use stratiform_stats::{Purpose, key, photon_stream};

const STREAM: &str = include_str!("../src/wgsl/stream.wgsl");
const WORDS: &str = "
@group(0) @binding(0) var<storage, read> key: vec2<u32>;
@group(0) @binding(1) var<storage, read> indices: array<vec2<u32>>;
@group(0) @binding(2) var<storage, read_write> words: array<u32>;

@compute @workgroup_size(64)
fn first_words(@builtin(global_invocation_id) id: vec3<u32>) {
    var stream = photon_stream(key, indices[id.x]);
    for (var k = 0u; k < 32u; k++) {
        words[32u * id.x + k] = draw(&stream);
    }
}
";

fn bytes(words: impl IntoIterator<Item = u64>) -> Vec<u8> {
    words.into_iter().flat_map(u64::to_le_bytes).collect()
}

/// 64·32 photons: the first, those at 2³² and 2⁴⁸, and some anywhere.
fn indices() -> Vec<u64> {
    let near = |centre: u64| (0..512).map(move |k| centre.wrapping_add(k).wrapping_sub(256));
    let anywhere = (0..512_u64).map(|k| k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    near(256).chain(near(1 << 32)).chain(near(1 << 48)).chain(anywhere).collect()
}

fn on_the_device(gpu: &stratiform_gpu::Gpu, wgsl: &str, key: u64) -> Vec<u32> {
    let indices = indices();
    let bindings = [bytes([key]), bytes(indices.iter().copied())];
    let bindings: Vec<&[u8]> = bindings.iter().map(Vec::as_slice).collect();
    let groups = [(indices.len() / 64) as u32, 1, 1];
    let words = gpu.run(wgsl, "first_words", &bindings, indices.len() * 32 * 4, groups).unwrap();
    words.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect()
}

fn on_the_cpu(key: u64) -> Vec<u32> {
    let words = |index| {
        let mut stream = photon_stream(key, index);
        (0..32).map(move |_| stream.next_u32())
    };
    indices().into_iter().flat_map(words).collect()
}

#[test]
fn every_word_is_that_of_the_cpu() {
    let Some(gpu) = device() else { return };
    let wgsl = format!("{STREAM}{WORDS}");
    for key in [0, u64::MAX, key(1, Purpose::HalfSpaceTracer(0)), key(77, Purpose::HalfSpaceTracer(3))] {
        assert_eq!(on_the_device(&gpu, &wgsl, key), on_the_cpu(key));
    }
}

#[test]
fn one_wrong_bit_of_a_constant_is_seen() {
    let Some(gpu) = device() else { return };
    for (right, wrong) in [("0x5851f42du", "0x5851f42cu"), ("0x133111ebu", "0x133111eau"), ("31u)", "30u)")] {
        let wgsl = format!("{}{WORDS}", STREAM.replacen(right, wrong, 1));
        assert_ne!(on_the_device(&gpu, &wgsl, 5), on_the_cpu(5), "{wrong}");
    }
}
