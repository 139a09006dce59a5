//! Time of each pass on the device, least of several pictures: hills of cloud, 512 x 512 texels, from below and from above.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program that prints figures")]

#[path = "../tests/worlds/mod.rs"]
mod worlds;

use stratiform_gpu::Gpu;
use stratiform_render::{Depth, Model, PassTime, Renderer, Settings};
use stratiform_world::World;

const PICTURES: usize = 5;

/// Least time of each pass, ms.
fn least(renderer: &mut Renderer) -> Vec<PassTime> {
    let draw = |renderer: &mut Renderer| {
        renderer.draw().unwrap();
        renderer.timings()
    };
    let mut least = draw(renderer);
    for _ in 1..PICTURES {
        for (least, time) in least.iter_mut().zip(draw(renderer)) {
            least.seconds = least.seconds.min(time.seconds);
        }
    }
    least
}

fn main() {
    let gpu = Gpu::new().unwrap();
    println!("{}\nsize,view,model,depth,pass,ms", gpu.adapter());
    for size in [[480, 270], [1920, 1080]] {
        for (view, camera) in [("below", worlds::below(size)), ("above", worlds::above(size))] {
            let world: World = worlds::world(worlds::hills(512, 400.0), camera, 0.0);
            for (model, depth) in
                [(Model::Fitted, Depth::Local), (Model::Angular, Depth::Local), (Model::Fitted, Depth::Chord)]
            {
                let settings = Settings { model, depth, ..Settings::default() };
                let mut renderer = Renderer::new(&gpu, &world, &settings).unwrap();
                for PassTime { name, seconds } in least(&mut renderer) {
                    println!(
                        "{}x{},{view},{model:?},{depth:?},{name},{:.3}",
                        size[0],
                        size[1],
                        1e3 * seconds
                    );
                }
            }
        }
    }
}
