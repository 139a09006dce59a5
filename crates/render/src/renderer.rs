//! What stays on the device between pictures, and the passes over it.

use crate::pyramid::{Levels, Pyramid};
use crate::radiosity::{Exchange, Step};
use crate::view::View;
use crate::{Model, RenderError, Settings, generated, phase_table, readback};
use stratiform_gpu::{Access, Buffer, Gpu, Kernel, Pass};
use stratiform_imaging::Image;
use stratiform_quantities::Range;
use stratiform_world::World;

const TEXTS: [&str; 6] = [
    include_str!("wgsl/view.wgsl"),
    include_str!("wgsl/field.wgsl"),
    include_str!("wgsl/march.wgsl"),
    include_str!("wgsl/surroundings.wgsl"),
    include_str!("wgsl/events.wgsl"),
    include_str!("wgsl/picture.wgsl"),
];

/// Bindings of the picture's kernel.
const BINDINGS: [Access; 9] = [
    Access::Read,
    Access::Read,
    Access::Uniform,
    Access::Read,
    Access::Read,
    Access::Read,
    Access::Read,
    Access::Read,
    Access::Write,
];

/// How long a pass took.
#[derive(Clone, Debug, PartialEq)]
pub struct PassTime {
    /// The pass.
    pub name: String,
    /// The device's time, s.
    pub seconds: f64,
}

/// A world on the device, ready to be drawn.
#[derive(Debug)]
pub struct Renderer {
    gpu: Gpu,
    world: World,
    settings: Settings,
    picture_kernel: Kernel,
    pyramid: Pyramid,
    exchange: Exchange,
    buffers: Buffers,
    times: Vec<PassTime>,
}

/// What the passes read and write.
#[derive(Debug)]
struct Buffers {
    phase: Buffer,
    halo: Buffer,
    view: Buffer,
    heights: Buffer,
    albedo: Buffer,
    picture: Buffer,
}

impl Renderer {
    /// Puts a world on the device.
    ///
    /// # Errors
    /// [`RenderError`] for a world that cannot be drawn, a missing generated file, or a device that fails.
    pub fn new(gpu: &Gpu, world: &World, settings: &Settings) -> Result<Self, RenderError> {
        check(world)?;
        let levels = Levels::new(world.field.map().side() as u32);
        Ok(Self {
            gpu: gpu.clone(),
            world: world.clone(),
            settings: *settings,
            picture_kernel: picture_kernel(gpu, world, settings.model)?,
            pyramid: Pyramid::new(gpu, &levels)?,
            exchange: Exchange::new(gpu, world, &settings.radiosity)?,
            buffers: Buffers::new(gpu, world, settings, &levels)?,
            times: Vec::new(),
        })
    }

    /// Another moment, camera or setting; what is of another size is made anew.
    ///
    /// # Errors
    /// Those of [`new`](Self::new); the former picture stays.
    pub fn update(&mut self, world: &World, settings: &Settings) -> Result<(), RenderError> {
        *self = Self::new(&self.gpu, world, settings)?;
        Ok(())
    }

    /// Draws.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] if the device fails, [`RenderError::NotFinite`] and [`RenderError::Endless`] for a pixel that is none, and
    /// [`RenderError::Black`] if every pixel is 0 where all contributions are asked for and a light shines on a ground that is not black.
    pub fn draw(&mut self) -> Result<Image, RenderError> {
        self.times = self.run()?;
        let camera = &self.world.camera;
        let bytes = self.gpu.download(&self.buffers.picture)?;
        let image = readback::image(camera.width, camera.height, &bytes)?;
        if self.must_shine() && readback::black(&image) {
            return Err(RenderError::Black);
        }
        Ok(image)
    }

    /// The device's time for each pass of the last picture; empty where the adapter has no time stamps.
    pub fn timings(&self) -> Vec<PassTime> {
        self.times.clone()
    }

    fn run(&self) -> Result<Vec<PassTime>, RenderError> {
        let b = &self.buffers;
        let field = self.pyramid.buffers(&b.heights);
        let light = self.exchange.buffers();
        let steps = self.exchange.steps();
        let mut passes = self.pyramid.passes(&field);
        passes.extend(steps.iter().map(Step::pass));
        let camera = &self.world.camera;
        let picture = [
            &b.phase,
            &b.halo,
            &b.view,
            &b.heights,
            &b.albedo,
            &light.ground_direct,
            &light.ground_indirect,
            &light.cloud_from_ground,
            &b.picture,
        ];
        let groups = [camera.width.div_ceil(8) as u32, camera.height.div_ceil(8) as u32, 1];
        passes.push(Pass { name: "picture", kernel: &self.picture_kernel, buffers: &picture, groups });
        let times = self.gpu.time_passes(&passes)?.unwrap_or_default();
        Ok(summed(passes.iter().map(|pass| pass.name).zip(times)))
    }

    /// Whether some pixel must have light.
    fn must_shine(&self) -> bool {
        let w = &self.world;
        let lit = w.sun.irradiance.iter().chain(&w.sky.irradiance()).any(|e| *e > 0.0);
        let ground = w.ground.albedo.values().iter().flatten().any(|albedo| *albedo > 0.0);
        lit && ground && self.settings.contributions == crate::Contributions::all()
    }
}

/// Passes of one name are one.
fn summed<'a>(times: impl Iterator<Item = (&'a str, f64)>) -> Vec<PassTime> {
    let mut sums: Vec<PassTime> = Vec::new();
    for (name, seconds) in times {
        match sums.iter_mut().find(|sum| sum.name == name) {
            Some(sum) => sum.seconds += seconds,
            None => sums.push(PassTime { name: name.to_owned(), seconds }),
        }
    }
    sums
}

impl Buffers {
    fn new(gpu: &Gpu, world: &World, settings: &Settings, levels: &Levels) -> Result<Self, RenderError> {
        let camera = &world.camera;
        let view = View::new(world, settings, levels);
        let mut heights: Vec<f32> = world.field.map().values().iter().map(|h| *h as f32).collect();
        heights.resize(levels.numbers(), 0.0);
        let albedo: Vec<[f32; 4]> = world.ground.albedo.values().iter().map(|a| four(*a)).collect();
        Ok(Self {
            phase: gpu.upload(bytemuck::cast_slice(&phase_table::phase_table(&world.material)?))?,
            halo: gpu.upload(bytemuck::cast_slice(&generated::halo(&world.material.generated)?))?,
            view: gpu.upload(bytemuck::bytes_of(&view))?,
            heights: gpu.upload(bytemuck::cast_slice(&heights))?,
            albedo: gpu.upload(bytemuck::cast_slice(&albedo))?,
            picture: gpu.zeroed(16 * camera.width * camera.height)?,
        })
    }
}

fn four([r, g, b]: [f64; 3]) -> [f32; 4] {
    [r as f32, g as f32, b as f32, 0.0]
}

fn picture_kernel(gpu: &Gpu, world: &World, model: Model) -> Result<Kernel, RenderError> {
    let orders = match model {
        Model::Angular => include_str!("wgsl/angular.wgsl"),
        Model::Fitted => include_str!("wgsl/fitted.wgsl"),
    };
    let generated = generated::text(&world.material.generated, model)?;
    let text = [generated.as_str()].into_iter().chain(TEXTS).chain([orders]).collect::<Vec<_>>().join("\n");
    Ok(gpu.kernel(&text, "picture_pixels", &BINDINGS)?)
}

/// What no picture can be made of.
fn check(world: &World) -> Result<(), RenderError> {
    let camera = &world.camera;
    let size = Range::closed(1.0, 65_536.0);
    size.check("width", camera.width as f64)?;
    size.check("height", camera.height as f64)?;
    Range::closed(1.0, 8192.0).check("texels a side of the height field", world.field.map().side() as f64)?;
    Range { min_included: false, ..Range::closed(0.0, 1.0) }
        .check("cosine of the sun's zenith angle", world.sun.direction.z)?;
    let thickest = world.material.extinction_per_m * world.field.most();
    Range::closed(0.0, 1e6).check("greatest optical thickness", thickest)?;
    Range::above(0.0).check("altitude of the camera, m", camera.position.z)?;
    let height_m = camera.position.z - world.base_m;
    let thickness_m = world.field.thickness(camera.position.x, camera.position.y);
    if height_m >= 0.0 && height_m <= thickness_m && thickness_m > 0.0 {
        return Err(RenderError::InsideCloud { height_m, thickness_m });
    }
    Ok(())
}
