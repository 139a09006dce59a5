//! Thin edges of cloud near the sun outshine thick cores, from below.

use crate::device::device;
use std::f64::consts::PI;
use stratiform_imaging::Image;
use stratiform_optics::phase::Halo;
use stratiform_render::{Contributions, Settings};
use stratiform_tests::effects::{
    draw, luminance, path, places, ray, scattering_deg, seen, towards, without, world,
};
use stratiform_world::{Contribution, World};

/// Round the sun, 10 degrees wide.
fn near() -> World {
    let world = seen(&world("silver-lining").unwrap(), [96, 96], 10.0);
    towards(&world, world.sun.direction)
}

/// Pixels from 1 to 4 degrees beside the sun with this much cloud along the line of sight, and how much.
fn pixels(world: &World, image: &Image, least: f64, most: f64) -> Vec<((usize, usize), f64)> {
    let near = |place: &(usize, usize)| (1.0..4.0).contains(&scattering_deg(world, *place));
    let with_path = |place| (place, path(world, ray(world, place)));
    let kept = |(_, path): &(_, f64)| (least..most).contains(path);
    places(image).filter(near).map(with_path).filter(kept).collect()
}

fn mean(image: &Image, pixels: &[((usize, usize), f64)]) -> f64 {
    pixels.iter().map(|((x, y), _)| luminance(image.at(*x, *y))).sum::<f64>() / pixels.len() as f64
}

#[test]
fn thin_edges_outshine_thick_cores_unless_the_halo_is_off() {
    let Some(gpu) = device() else { return };
    let world = near();
    let lining = |settings: &Settings| {
        let image = draw(&gpu, &world, settings).unwrap();
        let (thin, thick) = (pixels(&world, &image, 1.0, 3.0), pixels(&world, &image, 10.0, 1e9));
        assert!(thin.len() > 100 && thick.len() > 100, "{} {}", thin.len(), thick.len());
        mean(&image, &thin) / mean(&image, &thick)
    };
    let (with, off) = (lining(&Settings::default()), lining(&without(&[Contribution::Halo])));
    println!("silver lining, edge over core {with:.2}, without halo {off:.2}");
    assert!(with > 5.0 && off < 2.0, "{with} {off}");
}

/// Sunlight that met forward events only, per irradiance of the sun: Σ e^{-q} (q P_f)^n/n! P_F^{*n}(Θ)/4π.
fn halo(world: &World, halo: &Halo, theta: f64, q: f64) -> f64 {
    let forward = q * halo.forward_fraction();
    let weight = libm::exp(-q) * (libm::exp(forward) - 1.0 - forward);
    let several = halo.several(q, &[theta]).unwrap()[0];
    (q * libm::exp(-q) * world.material.phase.at(theta) + weight * several) / (4.0 * PI)
}

/// Beside the sun at its own height, where both paths are as slant.
#[test]
fn its_light_is_the_sum_of_forward_events() {
    let Some(gpu) = device() else { return };
    let world = near();
    let contributions = Contributions::none().with(Contribution::Halo);
    let image = draw(&gpu, &world, &Settings { contributions, ..Settings::default() }).unwrap();
    let table = Halo::new(&world.material.phase, world.material.theta_f_deg).unwrap();
    let level = |((_, y), _): &((usize, usize), f64)| (46..50).contains(y);
    let mut thin = pixels(&world, &image, 0.5, 6.0);
    thin.retain(level);
    assert!(thin.len() > 20, "{}", thin.len());
    for (place, q) in thin {
        let expected = halo(&world, &table, scattering_deg(&world, place).to_radians(), q);
        let found = luminance(image.at(place.0, place.1));
        assert!((found / expected - 1.0).abs() < 0.02, "{place:?} {q} {found} {expected}");
    }
}
