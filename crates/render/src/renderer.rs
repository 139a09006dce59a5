//! What stays on the device between pictures, and the passes over it.

use crate::check::check;
use crate::cloud::Cloud;
use crate::field::Field;
use crate::outside::Outside;
use crate::radiosity::{Exchange, Step};
use crate::view::View;
use crate::{Contributions, GroundLight, RenderError, Settings, readback};
use stratiform_gpu::{Buffer, Gpu, GpuError, Pass};
use stratiform_imaging::Image;
use stratiform_world::{Camera, World};

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
    size: [usize; 2],
    must_shine: bool,
    cloud: Cloud,
    field: Field,
    exchange: Exchange,
    view: Buffer,
    outside: Outside,
    picture: Buffer,
    times: Vec<PassTime>,
}

impl Renderer {
    /// Puts a world on the device.
    ///
    /// # Errors
    /// [`RenderError`] for a world that cannot be drawn, a missing generated file, or a device that fails.
    pub fn new(gpu: &Gpu, world: &World, settings: &Settings) -> Result<Self, RenderError> {
        check(world)?;
        let field = Field::new(gpu, &world.field)?;
        let sky = world.sky.table();
        let view = View::new(world, settings, field.levels(), &sky);
        Ok(Self {
            gpu: gpu.clone(),
            size: size(&world.camera),
            must_shine: must_shine(world, settings),
            cloud: Cloud::new(gpu, &world.material, settings.model)?,
            field,
            exchange: Exchange::new(gpu, world, &settings.radiosity)?,
            view: gpu.upload(bytemuck::bytes_of(&view))?,
            outside: Outside::new(gpu, &world.ground, &sky)?,
            picture: picture(gpu, size(&world.camera))?,
            times: Vec::new(),
        })
    }

    /// Another moment, camera or setting. What is of another size, cloud or model is made anew, the rest replaced.
    ///
    /// # Errors
    /// Those of [`new`](Self::new). A world that is refused changes nothing; after an error of the device make a new renderer.
    pub fn update(&mut self, world: &World, settings: &Settings) -> Result<(), RenderError> {
        check(world)?;
        if !self.cloud.is_of(&world.material, settings.model) {
            self.cloud = Cloud::new(&self.gpu, &world.material, settings.model)?;
        }
        self.exchange.update(&self.gpu, world, &settings.radiosity)?;
        self.field.update(&self.gpu, &world.field)?;
        let sky = world.sky.table();
        self.outside.update(&self.gpu, &world.ground, &sky)?;
        if self.size != size(&world.camera) {
            self.picture = picture(&self.gpu, size(&world.camera))?;
            self.size = size(&world.camera);
        }
        self.must_shine = must_shine(world, settings);
        let view = View::new(world, settings, self.field.levels(), &sky);
        Ok(self.gpu.replace(&self.view, bytemuck::bytes_of(&view))?)
    }

    /// Draws.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] if the device fails, [`RenderError::NotFinite`] and [`RenderError::Endless`] for a pixel that is none, and
    /// [`RenderError::Black`] if every pixel is 0 although all contributions are drawn and a light shines on a ground that is not black.
    pub fn draw(&mut self) -> Result<Image, RenderError> {
        self.times = self.run(|passes| {
            let times = self.gpu.time_passes(passes)?.unwrap_or_default();
            Ok(summed(passes.iter().map(|pass| pass.name).zip(times)))
        })?;
        let [width, height] = self.size;
        let image = readback::image(width, height, &self.gpu.download(&self.picture)?)?;
        if self.must_shine && readback::black(&image) {
            return Err(RenderError::Black);
        }
        Ok(image)
    }

    /// Draws for the screen: the pixels stay on the device, row by row from the top, four f32 each, the fourth 0 where a ray did not end.
    /// Neither waits for them nor looks at them.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] if the device fails.
    pub fn paint(&self) -> Result<&Buffer, RenderError> {
        self.run(|passes| self.gpu.submit_passes(passes))?;
        Ok(&self.picture)
    }

    /// The device's time for each pass of the last picture; empty before the first one, and where the adapter has no time stamps.
    pub fn timings(&self) -> Vec<PassTime> {
        self.times.clone()
    }

    /// The light between ground and cloud of the last picture.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] if the device fails.
    pub fn ground_light(&self) -> Result<GroundLight, RenderError> {
        GroundLight::read(&self.gpu, self.exchange.buffers())
    }

    /// What `submit` makes of the passes of a picture.
    fn run<T>(&self, submit: impl FnOnce(&[Pass]) -> Result<T, GpuError>) -> Result<T, RenderError> {
        let field = self.field.bindings();
        let steps = self.exchange.steps();
        let light = self.exchange.buffers();
        let picture = [
            &self.cloud.phase,
            &self.cloud.halo,
            &self.view,
            self.field.heights(),
            self.outside.buffer(),
            &light.ground_direct,
            &light.ground_indirect,
            &light.cloud_from_ground,
            &self.picture,
        ];
        let [columns, rows] = self.size.map(|pixels| pixels.div_ceil(8) as u32);
        let last = Pass {
            name: "picture",
            kernel: &self.cloud.kernel,
            buffers: &picture,
            groups: [columns, rows, 1],
        };
        let passes: Vec<Pass> =
            self.field.passes(&field).chain(steps.iter().map(Step::pass)).chain([last]).collect();
        Ok(submit(&passes)?)
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

fn size(camera: &Camera) -> [usize; 2] {
    [camera.width, camera.height]
}

/// Whether some pixel must have light.
fn must_shine(world: &World, settings: &Settings) -> bool {
    let lit = world.sun.irradiance.iter().chain(&world.sky.irradiance()).any(|e| *e > 0.0);
    let ground = world.ground.albedo.values().iter().flatten().any(|albedo| *albedo > 0.0);
    lit && ground && settings.contributions == Contributions::all()
}

fn picture(gpu: &Gpu, [width, height]: [usize; 2]) -> Result<Buffer, RenderError> {
    Ok(gpu.zeroed(16 * width * height)?)
}
