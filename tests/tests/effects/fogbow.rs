//! The white bow, about 142 degrees from the sun, over the light of many events that pales it.

use crate::device::device;
use std::f64::consts::PI;
use stratiform_gpu::Gpu;
use stratiform_imaging::Image;
use stratiform_imaging::profile::{Profile, contrast};
use stratiform_render::Settings;
use stratiform_tests::effects::{
    draw, flat, pixel_deg, places, ray, rings, scattering_deg, seen, solved, sunlight, without, world,
};
use stratiform_world::{Contribution, World};

/// Where the bow and the darker cloud inside it are looked for, Θ in degrees.
const LOOK: [f64; 2] = [134.0, 152.0];
/// Thickness of the layer, m: thick enough that most of its light met many events.
const THICK: f64 = 80.0;
const SIZE: [usize; 2] = [4, 300];

/// A strip through the top of the bow, on a layer of one thickness: 0.3 degrees a pixel.
fn strip() -> World {
    seen(&flat(&world("fogbow").unwrap(), THICK).unwrap(), SIZE, 75.0)
}

/// The half of the strip that holds the top of the bow.
fn picture(gpu: &Gpu, world: &World, settings: &Settings) -> Image {
    draw(gpu, world, settings).unwrap().crop((0, 0), (SIZE[0], SIZE[1] / 2)).unwrap()
}

fn profiles(world: &World, image: &Image) -> [Profile; 3] {
    [0, 1, 2].map(|channel| rings(world, image, channel, LOOK[0], LOOK[1]).unwrap())
}

/// Light of one wide event by its closed form: P_S/4π μ_l/(μ_l + μ_v) (1 - e^{-τ_S (1/μ_l + 1/μ_v)}).
fn once(world: &World, channel: usize, place: (usize, usize)) -> f64 {
    let phase = &world.material.colour[channel];
    let kept = 1.0 - phase.forward_fraction(world.material.theta_f_deg).unwrap();
    let (mu_l, mu_v) = (world.sun.direction.z, -ray(world, place).z);
    let path = kept * world.material.extinction_per_m * THICK * (1.0 / mu_l + 1.0 / mu_v);
    let wide = phase.at(scattering_deg(world, place).to_radians()) / kept;
    wide / (4.0 * PI) * mu_l / (mu_l + mu_v) * -libm::expm1(-path)
}

#[test]
fn the_bow_is_where_its_phase_functions_over_many_events_have_it_and_near_white() {
    let Some(gpu) = device() else { return };
    let world = strip();
    let drawn = picture(&gpu, &world, &Settings::default());
    let mut expected = picture(&gpu, &world, &without(&[Contribution::Single]));
    let lit = |place: (usize, usize)| {
        let rest = expected.at(place.0, place.1);
        [0, 1, 2].map(|channel| rest[channel] + once(&world, channel, place) as f32)
    };
    let pixels = places(&expected).map(lit).collect();
    expected = Image::new(expected.width(), expected.height(), pixels).unwrap();
    let mut bow = [0.0; 3];
    for (channel, (found, expected)) in
        profiles(&world, &drawn).iter().zip(profiles(&world, &expected)).enumerate()
    {
        let (theta, light) = found.maxima()[0];
        let (predicted, _) = expected.maxima()[0];
        bow[channel] = light;
        println!("fogbow at {theta:.3} degrees, predicted {predicted:.3}");
        assert!((theta - predicted).abs() < pixel_deg(&world.camera), "{theta} {predicted}");
        assert!((theta - 142.0).abs() < 1.0, "{theta}");
    }
    println!("fogbow, contrast between channels {:.4}", contrast(bow).unwrap());
    assert!(contrast(bow).unwrap() < 0.04, "{bow:?}");
}

/// The bow against the darker cloud 9 degrees inside it.
#[test]
fn its_contrast_is_that_of_the_solved_layer() {
    let Some(gpu) = device() else { return };
    let world = strip();
    let image = picture(&gpu, &world, &sunlight());
    let rows = [142.1, 151.0].map(|theta| {
        let off = |y: &usize| (scattering_deg(&world, (2, *y)) - theta).abs();
        (0..image.height()).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap()
    });
    let tau = THICK * world.material.extinction_per_m;
    let rays = rows.map(|y| ray(&world, (2, y)));
    let expected = contrast(solved::radiance(&world, &world.material.phase, tau, &rays).unwrap()).unwrap();
    let found = contrast(rows.map(|y| f64::from(image.at(2, y)[1]))).unwrap();
    println!("fogbow, contrast {found:.4}, solved {expected:.4}");
    assert!((0.06..0.08).contains(&expected), "{expected}");
    assert!((found - expected).abs() < 0.005, "{found} {expected}");
}

/// By how much the bow exceeds the mean of what lies 6 degrees on either side: smooth slopes do not count.
fn rise(profile: &Profile) -> f64 {
    let at = |theta: f64| {
        let nearest =
            profile.points().iter().min_by(|a, b| (a.0 - theta).abs().total_cmp(&(b.0 - theta).abs()));
        nearest.unwrap().1
    };
    at(142.1) / (0.5 * (at(136.1) + at(148.1))) - 1.0
}

#[test]
fn without_light_of_one_event_there_is_none() {
    let Some(gpu) = device() else { return };
    let world = strip();
    let rises = |settings| profiles(&world, &picture(&gpu, &world, &settings)).map(|profile| rise(&profile));
    let (with, without) = (rises(Settings::default()), rises(without(&[Contribution::Single])));
    println!("fogbow above its flanks {with:.3?}, without single events {without:.3?}");
    assert!(with.iter().all(|rise| *rise > 0.1), "{with:?}");
    assert!(without.iter().all(|rise| rise.abs() < 0.03), "{without:?}");
}
