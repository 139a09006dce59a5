//! Light at the first point in the cloud, as wgsl/picture.wgsl.

use super::march::Ray;
use super::{Twin, vector};
use crate::RenderError;
use glam::Vec3;
use std::f32::consts::FRAC_1_PI;
use stratiform_model::angular::{Sight, halo::transparency};
use stratiform_quantities::Side;
use stratiform_world::Contribution;

/// The first point in the cloud.
#[derive(Debug)]
pub struct Hit {
    /// Way from the camera, m.
    way: f32,
    /// Optical thickness of the slab.
    tau: f32,
    /// Of the face, out of the cloud.
    normal: Vec3,
}

impl Twin {
    pub(super) fn hit(&self, ray: &Ray, way: f32, entry: f32, chord: f32) -> Hit {
        let texel = [0, 1].map(|i| ray.texel[i] + entry * ray.slope[i]);
        let through_base = ray.rise > 0.0 && ray.height + entry * ray.rise <= 0.0;
        let thickness =
            if self.view.depth == 1 { chord * ray.rise.abs() } else { self.field.thickness(texel) };
        let normal = if through_base { Vec3::NEG_Z } else { self.field.normal(texel) };
        Hit { way: way + entry, tau: self.view.kappa * thickness, normal }
    }

    /// All light of the cloud, and the share of what is behind that is seen.
    pub(super) fn light(&self, d: Vec3, hit: &Hit) -> Result<(Vec3, f32), RenderError> {
        let clear = transparency(hit.tau, d.z.abs());
        Ok((self.sun_light(d, hit)? + self.surrounding_light(d, hit, clear)?, clear))
    }

    fn sun_light(&self, d: Vec3, hit: &Hit) -> Result<Vec3, RenderError> {
        let upright = if d.z > 0.0 { Vec3::NEG_Z } else { Vec3::Z };
        let far = self.sight(d, upright);
        let near = if self.view.normals == 1 { far } else { self.sight(d, hit.normal) };
        let orders = self.slab.orders(&near, &far, hit.tau)?;
        let halo = self.slab.halo(&near, hit.tau);
        let light = self.drawn(Contribution::Halo) * Vec3::splat(halo)
            + self.drawn(Contribution::Single) * vector(orders.one)
            + self.drawn(Contribution::Double) * vector(orders.two)
            + self.drawn(Contribution::Multiple) * Vec3::splat(orders.more);
        Ok(vector(self.view.sun_irradiance) * light)
    }

    fn surrounding_light(&self, d: Vec3, hit: &Hit, clear: f32) -> Result<Vec3, RenderError> {
        let slab = self.slab.fluxes(d.z.abs().min(1.0), hit.tau)?;
        let ground = FRAC_1_PI * self.around.on_cloud([hit.way * d.x, hit.way * d.y]);
        let through = slab.t_ms - clear;
        let (sky, from_ground) = if d.z < 0.0 { (slab.r_ms, through) } else { (through, slab.r_ms) };
        Ok(self.drawn(Contribution::Sky) * sky * vector(self.view.sky_mean)
            + self.drawn(Contribution::Ground) * from_ground * ground)
    }

    fn sight(&self, d: Vec3, normal: Vec3) -> Sight<f32> {
        let sun = vector(self.view.sun);
        let mu_l = sun.dot(normal);
        let half_way = sun - d;
        Sight {
            mu_l: mu_l.abs().clamp(1e-12, 1.0),
            mu_v: (-d).dot(normal).clamp(1e-12, 1.0),
            v: (0.5 * half_way.dot(half_way)).min(2.0),
            side: if mu_l > 0.0 { Side::Top } else { Side::Bottom },
        }
    }
}
