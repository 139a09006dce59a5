//! The passes on the device against their twin in f64, and against twins with planted errors.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod radiosity_common;

use radiosity_common::{EXTENT_M, clouds, difference, ice_in_land, towards, world};
use stratiform_gpu::{Buffer, Gpu, Pass};
use stratiform_model::Form;
use stratiform_render::radiosity::{
    Exchange, Light, Plan, Received, Slab, Step, Weights, ground_direct, planes,
};
use stratiform_render::{Radiosity, RingRule, Settings};
use stratiform_world::{Map, Sky, World};

/// Largest error of a map over its largest value.
const PARITY: f64 = 2e-6;

fn map(gpu: &Gpu, buffer: &Buffer) -> Light {
    let values: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&gpu.download(buffer).unwrap());
    values.iter().map(|[r, g, b, _]| [*r, *g, *b].map(f64::from)).collect()
}

/// Direct light, then what the planes receive.
fn on_the_device(gpu: &Gpu, exchange: &Exchange) -> (Light, Received) {
    let steps = exchange.steps();
    let passes: Vec<Pass> = steps.iter().map(Step::pass).collect();
    gpu.submit_passes(&passes).unwrap();
    let b = exchange.buffers();
    let received = Received { ground: map(gpu, &b.ground_indirect), cloud: map(gpu, &b.cloud_from_ground) };
    (map(gpu, &b.ground_direct), received)
}

fn on_the_cpu(world: &World, plan: &Plan) -> (Light, Received) {
    let slab = Slab::load(&world.material.generated).unwrap();
    let direct = ground_direct(&world.field, &slab, plan).unwrap();
    let planes = planes(&world.field, &slab, plan, direct.clone()).unwrap();
    (direct, planes.exchange(plan.passes))
}

/// Error of direct light, of the ground's and of the cloud's received light, each over its largest value.
fn errors(device: &(Light, Received), cpu: &(Light, Received)) -> [f64; 3] {
    let pairs = [(&device.0, &cpu.0), (&device.1.ground, &cpu.1.ground), (&device.1.cloud, &cpu.1.cloud)];
    pairs.map(|(found, expected)| {
        let (off, most) = difference(found, expected);
        off / most
    })
}

fn settings(rings: RingRule) -> Radiosity {
    Radiosity { rings, ..Settings::default().radiosity }
}

#[test]
fn the_device_does_what_its_twin_does() {
    let Some(gpu) = device::device() else { return };
    let mut world = world(clouds(1, 64), ice_in_land(2, 48));
    let mut exchange = Exchange::new(&gpu, &world, &settings(RingRule::LeastSquares)).unwrap();
    let rules =
        [RingRule::LeastSquares, RingRule::AsPrinted, RingRule::WiderSquares, RingRule::SquareWeights];
    for (rule, (theta, side)) in rules.into_iter().zip([(50.0, 16), (0.0, 7), (80.0, 32), (89.0, 24)]) {
        world.sun.direction = towards(theta, 120.0);
        for form in [Form::Corrected, Form::AsPrinted] {
            let radiosity = Radiosity { side, form, ..settings(rule) };
            exchange.update(&gpu, &world, &radiosity).unwrap();
            let found = errors(&on_the_device(&gpu, &exchange), &on_the_cpu(&world, exchange.plan()));
            println!("{rule:?} {form:?} {theta} deg {side}: {} passes, {found:?}", exchange.plan().passes);
            assert!(found.iter().all(|error| *error < PARITY), "{rule:?} {form:?} {theta}: {found:?}");
        }
    }
}

#[test]
fn planted_errors_are_seen() {
    let Some(gpu) = device::device() else { return };
    let world = world(clouds(1, 64), ice_in_land(2, 48));
    let right = settings(RingRule::LeastSquares);
    let device = on_the_device(&gpu, &Exchange::new(&gpu, &world, &right).unwrap());
    let slab = Slab::load(&world.material.generated).unwrap();
    let plan = |radiosity: &Radiosity| {
        Plan::new(&world, &slab, radiosity, Weights::between(&world, radiosity).unwrap())
    };
    let wrong = |radiosity: &Radiosity, plant: &dyn Fn(&mut Plan)| {
        let mut plan = plan(radiosity).unwrap();
        plant(&mut plan);
        errors(&device, &on_the_cpu(&world, &plan))
    };
    let nothing = wrong(&right, &|_| ());
    assert!(nothing.iter().all(|error| *error < PARITY), "{nothing:?}");
    let printed = Radiosity { form: Form::AsPrinted, ..right };
    let offset = plan(&printed).unwrap().offset;
    let parallax = wrong(&right, &|plan| plan.offset = offset);
    let cosine = wrong(&right, &|plan| plan.source_mu = 1.0);
    let weights = wrong(&settings(RingRule::AsPrinted), &|_| ());
    let last = wrong(&right, &|plan| plan.passes -= 1);
    println!(
        "printed parallax {parallax:?}, no cosine {cosine:?}, printed weights {weights:?}, a pass less {last:?}"
    );
    assert!(parallax[0] > 0.1 && cosine[1] > 0.1 && weights[1] > 0.01 && last[2] > 1e-5);
}

/// Sky, ground and cloud lossless, no sun: irradiance π on both planes; and a second run gives the bytes of the first.
#[test]
fn the_furnace_burns_on_the_device_and_starts_afresh() {
    let Some(gpu) = device::device() else { return };
    let mut world = world(clouds(4, 32), Map::new(1, EXTENT_M, vec![[1.0; 3]]).unwrap());
    world.sun.irradiance = [0.0; 3];
    world.sky = Sky::Uniform([1.0; 3]);
    let exchange = Exchange::new(&gpu, &world, &settings(RingRule::LeastSquares)).unwrap();
    let (_, received) = on_the_device(&gpu, &exchange);
    let light = received.ground.iter().chain(&received.cloud).flatten();
    let off = light.map(|e| (e / std::f64::consts::PI - 1.0).abs()).fold(0.0, f64::max);
    println!("{} passes, {off:?}", exchange.plan().passes);
    assert!(off < 1e-3, "{off}");
    assert_eq!(on_the_device(&gpu, &exchange).1, received);
}
