//! Contributions one by one: each is there, and together they are the picture.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod worlds;

use stratiform_imaging::Image;
use stratiform_render::{Contributions, Model, Renderer, Settings};
use stratiform_world::{Camera, Contribution, World};

const SIZE: [usize; 2] = [64, 36];

fn draw(renderer: &mut Renderer, world: &World, model: Model, contributions: Contributions) -> Image {
    renderer.update(world, &Settings { model, contributions, ..Settings::default() }).unwrap();
    renderer.draw().unwrap()
}

/// Below and towards the sun, so that the halo is in the picture; and above.
fn cameras() -> [Camera; 2] {
    [worlds::camera(2.0, 35.0, SIZE), worlds::above(SIZE)]
}

/// What cannot be in a picture: the halo from above, and two events by themselves in the fitted model.
fn absent(contribution: Contribution, model: Model, camera: &Camera) -> bool {
    (contribution == Contribution::Halo && camera.position.z > worlds::BASE)
        || (contribution == Contribution::Double && model == Model::Fitted)
}

#[test]
fn each_changes_the_picture_and_their_sum_is_the_whole() {
    let Some(gpu) = device::device() else { return };
    for camera in cameras() {
        let world = worlds::world(worlds::hills(64, 300.0), camera, 0.4);
        for model in [Model::Fitted, Model::Angular] {
            let settings = Settings { model, ..Settings::default() };
            let mut renderer = Renderer::new(&gpu, &world, &settings).unwrap();
            let whole = draw(&mut renderer, &world, model, Contributions::all());
            let mut sum = vec![[0.0_f32; 3]; whole.pixels().len()];
            for contribution in Contribution::ALL {
                let without = draw(&mut renderer, &world, model, Contributions::all().without(contribution));
                let absent = absent(contribution, model, &camera);
                assert_eq!(without == whole, absent, "{model:?} {contribution:?} at {}", camera.position.z);
                let only = draw(&mut renderer, &world, model, Contributions::none().with(contribution));
                for (sum, only) in sum.iter_mut().zip(only.pixels()) {
                    *sum = std::array::from_fn(|c| sum[c] + only[c]);
                }
            }
            for (sum, whole) in sum.iter().flatten().zip(whole.pixels().iter().flatten()) {
                assert!((sum - whole).abs() <= 2e-6 * whole.abs().max(1e-3), "{sum} {whole}");
            }
        }
    }
}
