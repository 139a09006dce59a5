//! What the passes read of world and settings, as `wgsl/view.wgsl` lays it out.

use crate::phase_table::kept;
use crate::pyramid::Levels;
use crate::{Depth, Normals, Settings};
use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use stratiform_model::angular::Emission;
use stratiform_world::{SkyTable, World};

/// Levels that a field may have.
pub const LEVELS: usize = 16;

/// The uniform buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct View {
    pub position: [f32; 3],
    pub pixel: f32,
    pub ahead: [f32; 3],
    pub base: f32,
    pub right: [f32; 3],
    pub most: f32,
    pub up: [f32; 3],
    pub kappa: f32,
    pub sun: [f32; 3],
    pub disc_versine: f32,
    pub sun_irradiance: [f32; 3],
    pub extent: f32,
    pub disc_radiance: [f32; 3],
    pub albedo_extent: f32,
    pub sky_mean: [f32; 3],
    pub side: u32,
    pub kept: [f32; 3],
    pub albedo_side: u32,
    pub towards_sun: [f32; 2],
    pub sky_size: [u32; 2],
    pub albedo_at: [f32; 2],
    pub size: [u32; 2],
    pub contributions: u32,
    pub emission_top: u32,
    pub emission_bottom: u32,
    pub depth: u32,
    pub normals: u32,
    pub top_level: u32,
    pub exchange_side: u32,
    pub reserved: u32,
    pub levels: [[u32; 4]; LEVELS],
}

impl View {
    /// Of a world that has been checked, and the table of its sky.
    pub fn new(world: &World, settings: &Settings, levels: &Levels, sky: &SkyTable) -> Self {
        let (camera, sun) = (&world.camera, &world.sun);
        let (field, ground) = (world.field.map(), &world.ground.albedo);
        let [x, y] = [camera.position.x, camera.position.y];
        let period = field.extent_m();
        let half = libm::sin(0.5 * sun.angular_radius_deg.to_radians());
        let sine = libm::sin(sun.angular_radius_deg.to_radians());
        let disc = sun.irradiance.map(|e| (e / (std::f64::consts::PI * sine * sine)) as f32);
        Self {
            position: [reduced(x, period), reduced(y, period), camera.position.z as f32],
            pixel: (2.0 * camera.tan_half / camera.height as f64) as f32,
            ahead: single(camera.forward),
            base: world.base_m as f32,
            right: single(camera.right),
            most: world.field.most() as f32,
            up: single(camera.up),
            kappa: world.material.extinction_per_m as f32,
            sun: single(sun.direction),
            disc_versine: (2.0 * half * half) as f32,
            sun_irradiance: sun.irradiance.map(|e| e as f32),
            extent: period as f32,
            disc_radiance: disc,
            albedo_extent: ground.extent_m() as f32,
            sky_mean: world.sky.mean_radiance().map(|l| l as f32),
            side: field.side() as u32,
            kept: kept(&world.material).map(|share| share as f32),
            albedo_side: ground.side() as u32,
            towards_sun: sky.towards_sun.map(|c| c as f32),
            sky_size: [sky.width as u32, sky.height as u32],
            albedo_at: [reduced(x, ground.extent_m()), reduced(y, ground.extent_m())],
            size: [camera.width as u32, camera.height as u32],
            contributions: settings.contributions.bits(),
            emission_top: emission(settings.emission.top),
            emission_bottom: emission(settings.emission.bottom),
            depth: u32::from(settings.depth == Depth::Chord),
            normals: u32::from(settings.normals == Normals::Vertical),
            top_level: levels.top(),
            exchange_side: settings.radiosity.side,
            reserved: 0,
            levels: levels.table(),
        }
    }
}

fn single(v: DVec3) -> [f32; 3] {
    v.as_vec3().to_array()
}

/// A coordinate less whole periods.
fn reduced(x: f64, period: f64) -> f32 {
    (x - libm::floor(x / period) * period) as f32
}

/// The number of a shape in the generated text.
fn emission(shape: Emission) -> u32 {
    match shape {
        Emission::Isotropic => 0,
        Emission::Lambertian => 1,
        Emission::Escape => 2,
    }
}
