//! One photon's history in three dimensions, by library functions.
//!
//! Scattering angles come from the phase function's own inversion ([`inverted`]), which makes the reference that every
//! other tracer is held against, or from its [table](TraceMedium::table) ([`tabulated`]), many times as fast. Depth is the z coordinate, downwards, in mean free paths of the medium traced. A beam from the horizon is a
//! limit: its first collision is at the surface.

use crate::TraceMedium;
use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::TAU;
use stratiform_quantities::Side;

/// A slab of a medium, and its sampler of 1 - cosΘ.
#[derive(Clone, Copy)]
pub(crate) struct Walk<'a, S> {
    pub medium: &'a TraceMedium,
    pub sampler: S,
    /// Depth of the lower face.
    pub bottom: f64,
}

/// Where light meets a droplet.
pub(crate) struct Collision {
    pub depth: f64,
    /// Of flight, before.
    pub direction: DVec3,
    /// Scatterings before this one.
    pub order: u64,
}

/// How a history ended.
pub(crate) struct End {
    /// The face it left; none if absorbed.
    pub side: Option<Side>,
    /// Scatterings.
    pub order: u64,
    /// Of flight, at last.
    pub direction: DVec3,
}

/// 1 - cosΘ by the phase function's own inversion.
pub(crate) fn inverted(medium: &TraceMedium) -> impl Fn(&mut Pcg32) -> f64 + Copy {
    let phase = medium.phase().as_ref();
    |rng| phase.invert(uniform(rng))
}

/// 1 - cosΘ by the table, within its bound of the same probability.
pub(crate) fn tabulated(medium: &TraceMedium) -> impl Fn(&mut Pcg32) -> f64 + Copy {
    let table = medium.table();
    |rng| table.sample(rng.next_u32())
}

impl<S: Fn(&mut Pcg32) -> f64> Walk<'_, S> {
    /// Follows a photon that enters along `direction`; `collide` sees each collision before it is known whether the
    /// photon survives it.
    pub fn history(&self, mut direction: DVec3, rng: &mut Pcg32, mut collide: impl FnMut(&Collision)) -> End {
        let mut position = DVec3::ZERO;
        let mut order = 0;
        loop {
            position += direction * -libm::log(uniform(rng));
            if position.z < 0.0 {
                return End { side: Some(Side::Top), order, direction };
            }
            if position.z >= self.bottom {
                return End { side: Some(Side::Bottom), order, direction };
            }
            collide(&Collision { depth: position.z, direction, order });
            if uniform(rng) >= self.medium.albedo() {
                return End { side: None, order, direction };
            }
            direction = self.scatter(direction, rng);
            order += 1;
        }
    }

    /// A new direction at the sampled angle from `direction`.
    fn scatter(&self, direction: DVec3, rng: &mut Pcg32) -> DVec3 {
        let v = (self.sampler)(rng);
        let azimuth = TAU * uniform(rng);
        let (across, up) = direction.any_orthonormal_pair();
        let (sine, cosine) = libm::sincos(azimuth);
        let sideways = across * cosine + up * sine;
        (direction * (1.0 - v) + sideways * (v * (2.0 - v)).sqrt()).normalize()
    }
}

/// The direction of flight of a beam whose zenith angle has cosine `mu`; its azimuth is 0.
pub(crate) fn sunbeam(mu: f64) -> DVec3 {
    DVec3::new((1.0 - mu * mu).sqrt(), 0.0, mu)
}

/// A number in (0, 1) from 52 random bits.
pub(crate) fn uniform(rng: &mut Pcg32) -> f64 {
    ((rng.next_u64() >> 12) as f64 + 0.5) / 4_503_599_627_370_496.0
}
