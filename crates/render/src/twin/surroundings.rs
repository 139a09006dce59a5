//! Sky, sun's disc and ground, as wgsl/surroundings.wgsl.

use super::vector;
use crate::GroundLight;
use crate::view::View;
use glam::Vec3;
use std::f32::consts::FRAC_1_PI;
use stratiform_world::{SkyTable, World};

/// What is behind the cloud and lights it.
#[derive(Debug)]
pub struct Surroundings {
    view: View,
    albedo: Vec<[f32; 3]>,
    sky: SkyTable,
    light: GroundLight,
}

impl Surroundings {
    pub fn new(world: &World, view: View, light: GroundLight) -> Self {
        let albedo = world.ground.albedo.values().iter().map(|a| a.map(|c| c as f32)).collect();
        Self { view, albedo, sky: world.sky.table(), light }
    }

    /// Radiance from `direction` where no cloud is.
    pub fn background(&self, d: Vec3) -> Vec3 {
        let v = &self.view;
        if d.z > 0.0 {
            let apart = d - vector(v.sun);
            let disc = 0.5 * apart.dot(apart) <= v.disc_versine;
            let sky = self.sky.radiance(d.as_dvec3()).map(|l| l as f32);
            return vector(sky) + if disc { vector(v.disc_radiance) } else { Vec3::ZERO };
        }
        let way = v.position[2] / -d.z;
        let place = [way * d.x, way * d.y];
        let at = [0, 1].map(|i| (v.albedo_at[i] + place[i]) / v.albedo_extent);
        let albedo = lookup(&self.albedo, v.albedo_side, at);
        let direct = lookup(&self.light.direct, v.side, self.periods(place));
        let indirect = lookup(&self.light.indirect, v.exchange_side, self.periods(place));
        FRAC_1_PI * albedo * (direct + indirect)
    }

    /// Irradiance of the cloud's base by the ground at a place relative to the camera.
    pub fn on_cloud(&self, place: [f32; 2]) -> Vec3 {
        lookup(&self.light.on_cloud, self.view.exchange_side, self.periods(place))
    }

    fn periods(&self, place: [f32; 2]) -> [f32; 2] {
        [0, 1].map(|i| (self.view.position[i] + place[i]) / self.view.extent)
    }
}

/// A map of `side` texels at a place given in periods.
fn lookup(map: &[[f32; 3]], side: u32, periods: [f32; 2]) -> Vec3 {
    let texel = periods.map(|p| (p - libm::floorf(p)) * side as f32 - 0.5);
    let whole = texel.map(libm::floorf);
    let [u, v] = [texel[0] - whole[0], texel[1] - whole[1]];
    let side = i64::from(side);
    let at = |i: i64, j: i64| {
        let (x, y) = ((whole[0] as i64 + i).rem_euclid(side), (whole[1] as i64 + j).rem_euclid(side));
        vector(map[(y * side + x) as usize])
    };
    let south = at(0, 0) + (at(1, 0) - at(0, 0)) * u;
    let north = at(0, 1) + (at(1, 1) - at(0, 1)) * u;
    south + (north - south) * v
}
