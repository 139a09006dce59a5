//! The exchange on the device: kernels, buffers, and the passes in order.

use super::{Plan, RadiosityError, Slab, Weights};
use crate::Radiosity;
use bytemuck::{Pod, Zeroable};
use stratiform_artifact::read_text;
use stratiform_gpu::{Access, Buffer, Gpu, Kernel, Pass};
use stratiform_world::World;

const COMMON: &str = include_str!("../wgsl/radiosity_common.wgsl");
const DIRECT: &str = include_str!("../wgsl/radiosity_direct.wgsl");
const SOURCES: &str = include_str!("../wgsl/radiosity_sources.wgsl");
const GATHER: &str = include_str!("../wgsl/radiosity_gather.wgsl");

/// `Exchange` of radiosity_common.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Uniform {
    sun: [f32; 3],
    mu_l: f32,
    sky: [f32; 3],
    extinction_per_m: f32,
    whole: [u32; 2],
    fraction: [f32; 2],
    source_mu: f32,
    field_side: u32,
    side: u32,
    samples: u32,
}

impl Uniform {
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the device's precision; sides and offsets are checked"
    )]
    fn new(plan: &Plan) -> Self {
        Self {
            sun: plan.sun.map(|c| c as f32),
            mu_l: plan.mu_l as f32,
            sky: plan.sky.map(|c| c as f32),
            extinction_per_m: plan.extinction_per_m as f32,
            whole: plan.offset.map(|texels| texels as u32),
            fraction: plan.offset.map(|texels| (texels - libm::floor(texels)) as f32),
            source_mu: plan.source_mu as f32,
            field_side: plan.field_side as u32,
            side: plan.weights.side() as u32,
            samples: plan.texels.samples as u32,
        }
    }
}

/// What the exchange holds on the device. Maps are row by row from the south, texel centres as in [`stratiform_world::Map`], `vec4<f32>`
/// with 0 in the last place unless said otherwise.
#[derive(Debug)]
pub struct Buffers {
    /// Thickness of the cloud, m, one `f32` per texel of the height field.
    pub thickness: Buffer,
    /// Irradiance of the ground by the sun, unscattered or after two wide events at most; per texel of the height field.
    pub ground_direct: Buffer,
    /// Irradiance of the ground by the cloud's base, and by the sky through it; per texel of the exchange.
    pub ground_indirect: Buffer,
    /// Irradiance of the cloud's base by the ground; per texel of the exchange.
    pub cloud_from_ground: Buffer,
    uniform: Buffer,
    weights: Buffer,
    cloud_albedo: Buffer,
    ground_source: Buffer,
    ground_albedo: Buffer,
    from_cloud: Buffer,
    from_ground: Buffer,
    nothing: Buffer,
}

/// Light between ground and cloud, on the device.
#[derive(Debug)]
pub struct Exchange {
    slab: Slab,
    plan: Plan,
    buffers: Buffers,
    direct: Kernel,
    sources: Kernel,
    gather: Kernel,
}

/// A dispatch and the buffers that its [`Pass`] borrows.
#[derive(Debug)]
pub struct Step<'a> {
    name: &'static str,
    kernel: &'a Kernel,
    buffers: Vec<&'a Buffer>,
    groups: [u32; 3],
}

impl Step<'_> {
    /// The dispatch for a sequence.
    pub fn pass(&self) -> Pass<'_> {
        Pass { name: self.name, kernel: self.kernel, buffers: &self.buffers, groups: self.groups }
    }
}

impl Exchange {
    /// Compiles the passes around the world's emitted text and uploads what they read.
    ///
    /// # Errors
    /// [`RadiosityError`] for what [`Plan::new`] refuses, a folder without text or parameters, or a device that fails.
    pub fn new(gpu: &Gpu, world: &World, radiosity: &Radiosity) -> Result<Self, RadiosityError> {
        let folder = &world.material.generated;
        let slab = Slab::load(folder)?;
        let plan = Plan::new(world, &slab, radiosity, Weights::between(world, radiosity)?)?;
        let fluxes = read_text(&folder.join("stratiform.wgsl"))?;
        let compile = |text: &str, entry, bindings: &[Access]| {
            gpu.kernel(&format!("{fluxes}\n{COMMON}\n{text}"), entry, bindings)
        };
        use Access::{Read, Uniform as Constant, Write};
        let direct = compile(DIRECT, "radiosity_direct", &[Constant, Read, Write])?;
        let sources = compile(
            SOURCES,
            "radiosity_sources",
            &[Constant, Read, Read, Write, Write, Write, Write, Write],
        )?;
        let gather = compile(GATHER, "radiosity_gather", &[Constant, Read, Read, Read, Read, Write, Write])?;
        let buffers = Buffers::new(gpu, world, &plan)?;
        Ok(Self { slab, plan, buffers, direct, sources, gather })
    }

    /// Takes another moment, sun or ground of the same folder.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn update(&mut self, gpu: &Gpu, world: &World, radiosity: &Radiosity) -> Result<(), RadiosityError> {
        let weights = match &self.plan.weights {
            same if same.fit(world, radiosity) => same.clone(),
            _ => Weights::between(world, radiosity)?,
        };
        let plan = Plan::new(world, &self.slab, radiosity, weights)?;
        if plan.field_side == self.plan.field_side && plan.weights.side() == self.plan.weights.side() {
            self.buffers.replace(gpu, world, &plan)?;
        } else {
            self.buffers = Buffers::new(gpu, world, &plan)?;
        }
        self.plan = plan;
        Ok(())
    }

    /// What the passes write.
    pub fn buffers(&self) -> &Buffers {
        &self.buffers
    }

    /// What they compute.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The dispatches in order; each run starts afresh.
    pub fn steps(&self) -> Vec<Step<'_>> {
        let b = &self.buffers;
        let whole = |side: usize, size: u32| {
            #[allow(clippy::cast_possible_truncation, reason = "sides are checked")]
            let groups = (side as u32).div_ceil(size);
            [groups, groups, 1]
        };
        let field = whole(self.plan.field_side, 8);
        let texels = whole(self.plan.weights.side(), 1);
        let step = |name, kernel, buffers, groups| Step { name, kernel, buffers, groups };
        let down = |source| {
            let buffers = vec![
                &b.uniform,
                &b.weights,
                &b.from_cloud,
                &b.ground_albedo,
                source,
                &b.ground_indirect,
                &b.from_ground,
            ];
            step("cloud to ground", &self.gather, buffers, texels)
        };
        let up = || {
            let buffers = vec![
                &b.uniform,
                &b.weights,
                &b.from_ground,
                &b.cloud_albedo,
                &b.nothing,
                &b.cloud_from_ground,
                &b.from_cloud,
            ];
            step("ground to cloud", &self.gather, buffers, texels)
        };
        let direct = vec![&b.uniform, &b.thickness, &b.ground_direct];
        let sources = vec![
            &b.uniform,
            &b.thickness,
            &b.ground_direct,
            &b.from_cloud,
            &b.cloud_albedo,
            &b.ground_source,
            &b.ground_indirect,
            &b.cloud_from_ground,
        ];
        let mut steps = vec![
            step("direct light of the ground", &self.direct, direct, field),
            step("sources", &self.sources, sources, texels),
            down(&b.ground_source),
        ];
        for _ in 0..self.plan.passes {
            steps.extend([up(), down(&b.nothing)]);
        }
        steps
    }
}

impl Buffers {
    fn new(gpu: &Gpu, world: &World, plan: &Plan) -> Result<Self, RadiosityError> {
        let low = || gpu.zeroed(16 * plan.weights.side() * plan.weights.side());
        let field = plan.field_side * plan.field_side;
        let buffers = Self {
            thickness: gpu.zeroed(4 * field)?,
            ground_direct: gpu.zeroed(16 * field)?,
            ground_indirect: low()?,
            cloud_from_ground: low()?,
            uniform: gpu.zeroed(size_of::<Uniform>())?,
            weights: gpu.zeroed(4 * plan.weights.values().len())?,
            cloud_albedo: low()?,
            ground_source: low()?,
            ground_albedo: low()?,
            from_cloud: low()?,
            from_ground: low()?,
            nothing: low()?,
        };
        buffers.replace(gpu, world, plan)?;
        Ok(buffers)
    }

    #[allow(clippy::cast_possible_truncation, reason = "the device's precision")]
    fn replace(&self, gpu: &Gpu, world: &World, plan: &Plan) -> Result<(), RadiosityError> {
        let numbers = |values: &[f64]| values.iter().map(|value| *value as f32).collect::<Vec<f32>>();
        let albedo: Vec<[f32; 4]> =
            plan.ground_albedo.iter().map(|[r, g, b]| [*r as f32, *g as f32, *b as f32, 0.0]).collect();
        gpu.replace(&self.uniform, bytemuck::bytes_of(&Uniform::new(plan)))?;
        gpu.replace(&self.thickness, bytemuck::cast_slice(&numbers(world.field.map().values())))?;
        gpu.replace(&self.weights, bytemuck::cast_slice(&numbers(plan.weights.values())))?;
        gpu.replace(&self.ground_albedo, bytemuck::cast_slice(&albedo))?;
        Ok(())
    }
}
