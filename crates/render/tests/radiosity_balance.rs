//! Energy: what the exchange must do whatever its weights are, and how many passes its error needs.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

mod radiosity_common;
mod radiosity_truth;

use radiosity_common::{EXTENT_M, clouds, ice_in_land, towards, waves, world};
use radiosity_truth::RULES;
use std::f64::consts::PI;
use stratiform_model::Form;
use stratiform_render::radiosity::{
    Plan, Planes, RadiosityError, Slab, Weights, ground_direct, kept, passes_for, planes,
};
use stratiform_render::{Radiosity, RingRule, Settings};
use stratiform_world::{Map, Sky, World};

fn uniform_planes(rule: RingRule) -> Planes {
    Planes {
        weights: Weights::new(rule, 16, 1000.0, 2000.0).unwrap(),
        ground_albedo: vec![[0.2, 0.5, 0.9]; 256],
        cloud_albedo: vec![[0.7; 3]; 256],
        ground_source: vec![[0.4, 0.3, 0.0]; 256],
        cloud_source: vec![[0.1, 0.2, 0.3]; 256],
    }
}

#[test]
fn on_uniform_planes_the_exchange_is_the_geometric_series() {
    for rule in RULES {
        for passes in [0, 1, 2, 5, 30] {
            let received = uniform_planes(rule).exchange(passes);
            for (i, (albedo, (direct, cloud))) in
                [0.2, 0.5, 0.9].iter().zip([0.4, 0.3, 0.0].iter().zip([0.1, 0.2, 0.3])).enumerate()
            {
                let q = albedo * 0.7;
                let up = albedo * (direct + cloud) * (1.0 - libm::pow(q, f64::from(passes))) / (1.0 - q);
                let exact = [up, cloud + 0.7 * up];
                for (found, exact) in [received.cloud[77][i], received.ground[77][i]].iter().zip(exact) {
                    assert!((found - exact).abs() < 1e-13, "{rule:?} {passes}: {found} {exact}");
                }
            }
        }
    }
}

fn settings(rings: RingRule) -> Radiosity {
    Radiosity { rings, ..Settings::default().radiosity }
}

fn plan(world: &World, radiosity: &Radiosity) -> Result<Plan, RadiosityError> {
    let slab = Slab::load(&world.material.generated).unwrap();
    Plan::new(world, &slab, radiosity, Weights::between(world, radiosity)?)
}

fn planes_of(world: &World, plan: &Plan) -> Planes {
    let slab = Slab::load(&world.material.generated).unwrap();
    let direct = ground_direct(&world.field, &slab, plan).unwrap();
    planes(&world.field, &slab, plan, direct).unwrap()
}

/// Sky, ground and cloud lossless, no sun: radiance 1 everywhere, whatever the cloud's shape.
#[test]
fn the_furnace_has_radiance_one_everywhere() {
    let mut world = world(clouds(4, 32), Map::new(1, EXTENT_M, vec![[1.0; 3]]).unwrap());
    world.sun.irradiance = [0.0; 3];
    world.sky = Sky::Uniform([1.0; 3]);
    for rule in RULES {
        let plan = plan(&world, &settings(rule)).unwrap();
        let received = planes_of(&world, &plan).exchange(plan.passes);
        let light = received.ground.iter().chain(&received.cloud).flatten();
        let off = light.map(|e| (e / PI - 1.0).abs()).fold(0.0, f64::max);
        println!("{rule:?}: {} passes, {off:.1e}", plan.passes);
        assert!(off < 1e-3, "{rule:?}: {off}");
    }
}

/// Without absorption nothing is lost: what the layer lets through reaches the ground; not so with the printed source, which lacks cosθ_l.
#[test]
fn light_through_the_layer_is_what_reaches_the_ground() {
    let mut world = world(clouds(5, 64), Map::new(1, EXTENT_M, vec![[0.0; 3]]).unwrap());
    // Shadows displaced by four texels: the ground's samples are the field's own.
    world.sun.direction = towards(libm::atan(0.5).to_degrees(), 90.0);
    let slab = Slab::load(&world.material.generated).unwrap();
    let mut through = 0.0;
    for thickness in world.field.map().values() {
        let (tau, mu_l) = (world.material.extinction_per_m * thickness, world.sun.direction.z);
        let beam = slab.beam(mu_l, tau).unwrap().t_ms * mu_l * world.sun.irradiance[0];
        through += (beam + slab.diffuse(tau).unwrap().t_ms * world.sky.irradiance()[0]) / 4096.0;
    }
    let lost = |form| {
        let radiosity = Radiosity { form, ..settings(RingRule::LeastSquares) };
        let planes = planes_of(&world, &plan(&world, &radiosity).unwrap());
        let received = planes.exchange(3);
        assert!(received.cloud.iter().all(|light| *light == [0.0; 3]), "black ground");
        let mean = |light: &[[f64; 3]]| light.iter().map(|l| l[0]).sum::<f64>() / light.len() as f64;
        1.0 - (mean(&planes.ground_source) + mean(&received.ground)) / through
    };
    assert!(lost(Form::Corrected).abs() < 1e-12, "{}", lost(Form::Corrected));
    assert!(lost(Form::AsPrinted) < -0.01, "{}", lost(Form::AsPrinted));
}

/// Missing light after the planned passes is below the error, and the bound is the ratio itself on uniform planes.
#[test]
fn passes_keep_the_promised_error() {
    for (seed, error) in [(1, 1e-2), (2, 1e-3), (3, 1e-5)] {
        let world = world(clouds(seed, 64), ice_in_land(seed + 7, 64));
        let plan = plan(&world, &Radiosity { error, ..settings(RingRule::LeastSquares) }).unwrap();
        let planes = planes_of(&world, &plan);
        let total = |passes, channel: usize| {
            planes.exchange(passes).cloud.iter().map(|light| light[channel]).sum::<f64>()
        };
        for channel in 0..3 {
            let missing = 1.0 - total(plan.passes, channel) / total(60, channel);
            println!("{error}: {} passes, {missing:.1e} missing", plan.passes);
            assert!(missing < error, "{missing} {error}");
        }
    }
    let planes = uniform_planes(RingRule::Exact);
    let q = kept(&planes.weights, &planes.ground_albedo, &planes.cloud_albedo);
    assert!((q - 0.63).abs() < 1e-12);
    assert_eq!(passes_for(0.1, 1.01e-3).unwrap(), 3);
    assert_eq!(passes_for(0.1, 0.99e-3).unwrap(), 4);
    assert_eq!(passes_for(0.0, 1e-3).unwrap(), 1);
}

/// That a texel's albedo is at most that of its mean thickness.
#[test]
fn the_cloud_s_albedo_is_concave_in_its_thickness() {
    let slab = Slab::load(&radiosity_common::folder()).unwrap();
    let albedo = |i: i32| slab.diffuse(0.05 * f64::from(i)).unwrap().r_ms;
    for i in 1..2000 {
        assert!(
            albedo(i) >= 0.5 * (albedo(i - 1) + albedo(i + 1)),
            "at optical thickness {}",
            0.05 * f64::from(i)
        );
    }
}

#[test]
fn worlds_without_an_exchange_are_refused() {
    let good = || world(clouds(1, 16), ice_in_land(1, 16));
    let refused = |change: &dyn Fn(&mut World, &mut Radiosity)| {
        let (mut world, mut radiosity) = (good(), settings(RingRule::Exact));
        change(&mut world, &mut radiosity);
        plan(&world, &radiosity).map(|plan| plan.passes).unwrap_err().to_string()
    };
    assert!(plan(&good(), &settings(RingRule::Exact)).is_ok());
    assert!(refused(&|world, _| world.sun.direction = towards(91.0, 0.0)).contains("zenith angle"));
    assert!(refused(&|world, _| world.base_m = 0.0).contains("base_m = 0"));
    assert!(refused(&|_, radiosity| radiosity.error = 0.0).contains("radiosity.error = 0"));
    assert!(refused(&|_, radiosity| radiosity.side = 129).contains("radiosity.side = 129"));
    assert!(refused(&|_, radiosity| radiosity.passes = Some(5000)).contains("radiosity.passes = 5000"));
    let patches = |extent| Map::new(8, extent, waves(1, 8, 2).iter().map(|_| [0.2; 3]).collect()).unwrap();
    assert!(refused(&|world, _| world.ground.albedo = patches(9000.0)).contains("9000 m"));
    let mut tiled = good();
    tiled.ground.albedo = patches(EXTENT_M / 4.0);
    assert!(plan(&tiled, &settings(RingRule::Exact)).is_ok());
}
