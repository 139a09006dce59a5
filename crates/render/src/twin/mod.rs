//! The picture on the CPU: every shader function once more in f32, around the functions of the crate `model` in place of the emitted text.
//!
//! For tests: what the device draws is held against it. It shares with the device the numbers of the view and the two generated tables; it
//! walks through the height field cell by cell, without the pyramid. Errors: those of the files, and of parameters out of domain.

mod field;
mod march;
mod shading;
mod slab;
mod surroundings;

use crate::check::check;
use crate::pyramid::Levels;
use crate::view::View;
use crate::{GroundLight, RenderError, Settings};
use field::Field;
use glam::Vec3;
use march::{Ray, march};
use slab::Slab;
use stratiform_imaging::Image;
use stratiform_world::{Contribution, World};
use surroundings::Surroundings;

/// Rays nearer to the horizontal are followed at it, as in picture.wgsl.
const LEAST_RISE: f32 = 1e-3;

/// A world that the CPU draws.
#[derive(Debug)]
pub struct Twin {
    view: View,
    settings: Settings,
    field: Field,
    slab: Slab,
    around: Surroundings,
}

impl Twin {
    /// Of a world under the ground's light that the device computed.
    ///
    /// # Errors
    /// [`RenderError`] for a world that cannot be drawn, and for files that are missing.
    pub fn new(world: &World, settings: &Settings, light: GroundLight) -> Result<Self, RenderError> {
        check(world)?;
        let levels = Levels::new(world.field.map().side() as u32);
        let view = View::new(world, settings, &levels, &world.sky.table());
        Ok(Self {
            view,
            settings: *settings,
            field: Field::new(&world.field),
            slab: Slab::load(world, settings)?,
            around: Surroundings::new(world, view, light),
        })
    }

    /// The whole picture.
    ///
    /// # Errors
    /// [`RenderError`] for parameters out of domain.
    pub fn draw(&self) -> Result<Image, RenderError> {
        let [width, height] = self.view.size.map(|pixels| pixels as usize);
        let pixel = |index: usize| self.pixel(index % width, index / width);
        let pixels = (0..width * height).map(pixel).collect::<Result<_, _>>()?;
        Ok(Image::new(width, height, pixels)?)
    }

    /// The pixel in column `x` of row `y`.
    ///
    /// # Errors
    /// [`RenderError`] for parameters out of domain.
    pub fn pixel(&self, x: usize, y: usize) -> Result<[f32; 3], RenderError> {
        let d = self.direction(x as f32, y as f32);
        let behind = self.drawn(Contribution::Background) * self.around.background(d);
        let (ray, way) = self.ray(d);
        if ray.reach <= 0.0 || self.view.most <= 0.0 {
            return Ok(behind.to_array());
        }
        let found = march(&self.field, &ray, self.view.depth == 1);
        let Some(entry) = found.entry else { return Ok(behind.to_array()) };
        let hit = self.hit(&ray, way, entry, found.chord);
        let (light, clear) = self.light(d, &hit)?;
        Ok((light + clear * behind).to_array())
    }

    fn drawn(&self, contribution: Contribution) -> f32 {
        if self.settings.contributions.has(contribution) { 1.0 } else { 0.0 }
    }

    fn direction(&self, x: f32, y: f32) -> Vec3 {
        let v = &self.view;
        let across = (x + 0.5 - 0.5 * v.size[0] as f32) * v.pixel;
        let upwards = -(y + 0.5 - 0.5 * v.size[1] as f32) * v.pixel;
        let d = (vector(v.ahead) + across * vector(v.right) + upwards * vector(v.up)).normalize();
        let rise = if d.z >= 0.0 { d.z.max(LEAST_RISE) } else { d.z.min(-LEAST_RISE) };
        Vec3::new(d.x, d.y, rise)
    }

    /// The part of a ray in the slab between base and greatest thickness, and the way to it.
    fn ray(&self, d: Vec3) -> (Ray, f32) {
        let v = &self.view;
        let height = v.position[2] - v.base;
        let (to_base, to_top) = (-height / d.z, (v.most - height) / d.z);
        let way = to_base.min(to_top).max(0.0);
        let scale = v.side as f32 / v.extent;
        let texel = |from: f32, along: f32| {
            let place = from + way * along;
            (place - libm::floorf(place / v.extent) * v.extent) * scale - 0.5
        };
        let ray = Ray {
            texel: [texel(v.position[0], d.x), texel(v.position[1], d.y)],
            slope: [d.x * scale, d.y * scale],
            height: height.clamp(0.0, v.most),
            rise: d.z,
            reach: to_base.max(to_top) - way,
        };
        (ray, way)
    }
}

fn vector(v: [f32; 3]) -> Vec3 {
    Vec3::from_array(v)
}
