//! Hills of cloud from below and above as PPM files, with the time of each pass.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program for the eye")]

#[path = "../tests/worlds/mod.rs"]
mod worlds;

use std::time::Instant;
use stratiform_gpu::Gpu;
use stratiform_imaging::Image;
use stratiform_render::{Renderer, Settings};

fn ppm(image: &Image) -> Vec<u8> {
    let byte = |v: f32| (255.0 * libm::powf((4.0 * v).clamp(0.0, 1.0), 1.0 / 2.2)) as u8;
    let head = format!("P6 {} {} 255\n", image.width(), image.height());
    head.into_bytes().into_iter().chain(image.pixels().iter().flatten().map(|v| byte(*v))).collect()
}

fn main() {
    let gpu = Gpu::new().unwrap();
    let size = [480, 270];
    for (name, camera) in [("below", worlds::below(size)), ("above", worlds::above(size))] {
        let world = worlds::world(worlds::hills(512, 400.0), camera, 0.0);
        let start = Instant::now();
        let mut renderer = Renderer::new(&gpu, &world, &Settings::default()).unwrap();
        println!("{name}: ready after {:.3} s", start.elapsed().as_secs_f64());
        for _ in 0..2 {
            let start = Instant::now();
            let image = renderer.draw().unwrap();
            println!("  {:.3} s {:?}", start.elapsed().as_secs_f64(), renderer.timings());
            std::fs::write(format!("/tmp/{name}.ppm"), ppm(&image)).unwrap();
        }
    }
}
