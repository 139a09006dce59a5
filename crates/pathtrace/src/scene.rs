//! A world made ready for paths.

use crate::PathtraceError;
use crate::halo::Halos;
use crate::layer::Layer;
use crate::phases::Phases;
use stratiform_quantities::{DomainError, Range};
use stratiform_world::World;

/// Mean free paths that most flights are shorter than.
const REACH: f64 = 2.5;

/// All that paths read.
pub(crate) struct Scene<'a> {
    pub(crate) world: &'a World,
    pub(crate) layer: Layer,
    pub(crate) phases: Phases,
    pub(crate) halos: Halos,
    /// κ, 1/m.
    pub(crate) extinction: f64,
    /// ω.
    pub(crate) albedo: f64,
    /// P_f of each channel.
    pub(crate) forward: [f64; 3],
    pub(crate) sunlit: bool,
}

impl<'a> Scene<'a> {
    pub(crate) fn new(world: &'a World) -> Result<Self, PathtraceError> {
        check(world)?;
        let material = &world.material;
        let phases = Phases::new(&material.colour, material.theta_f_deg)?;
        let sunlit = world.sun.irradiance.iter().any(|e| *e > 0.0);
        let halos = if sunlit { Halos::new(&material.colour, material.theta_f_deg)? } else { Halos::none() };
        Ok(Self {
            world,
            layer: Layer::new(&world.field, world.base_m, REACH / material.extinction_per_m),
            forward: phases.forward_fractions(),
            phases,
            halos,
            extinction: material.extinction_per_m,
            albedo: material.single_scattering_albedo,
            sunlit,
        })
    }
}

/// Refuses what is out of domain or no number.
fn check(world: &World) -> Result<(), DomainError> {
    let (material, sun, camera) = (&world.material, &world.sun, &world.camera);
    Range::above(0.0).check("extinction_per_m", material.extinction_per_m)?;
    Range::closed(0.0, 1.0).check("single_scattering_albedo", material.single_scattering_albedo)?;
    Range::open(0.0, 90.0).check("theta_f_deg", material.theta_f_deg)?;
    Range::at_least(0.0).check("base_m", world.base_m)?;
    sun.irradiance.iter().try_for_each(|e| Range::at_least(0.0).check("sun irradiance", *e).map(|_| ()))?;
    Range::closed(1.0 - 1e-9, 1.0 + 1e-9).check("length of the sun's direction", sun.direction.length())?;
    Range::above(0.0).check("sine of the sun's elevation", sun.direction.z)?;
    Range::open(0.0, 90.0).check("sun angular_radius_deg", sun.angular_radius_deg)?;
    Range::above(0.0).check("camera altitude_m", camera.position.z)?;
    Range::above(0.0).check("camera tan_half", camera.tan_half)?;
    for (name, axis) in [("forward", camera.forward), ("right", camera.right), ("up", camera.up)] {
        Range::closed(1.0 - 1e-6, 1.0 + 1e-6)
            .check(&format!("length of the camera's {name}"), axis.length())?;
    }
    for x in [camera.position.x, camera.position.y] {
        Range::open(f64::NEG_INFINITY, f64::INFINITY).check("camera position_m", x)?;
    }
    let albedo = world.ground.albedo.values().iter().flatten();
    albedo.copied().try_for_each(|a| Range::closed(0.0, 1.0).check("ground albedo", a).map(|_| ()))?;
    let zenith = world.sky.radiance(glam::DVec3::Z);
    zenith.iter().try_for_each(|l| Range::at_least(0.0).check("sky radiance", *l).map(|_| ()))
}
