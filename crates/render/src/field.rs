//! The height field on the device, and the passes that build the pyramid over it.

use crate::RenderError;
use crate::pyramid::Levels;
use stratiform_gpu::{Access, Buffer, Gpu, Kernel, Pass};
use stratiform_world::HeightField;

const TEXT: &str = include_str!("wgsl/pyramid.wgsl");

/// Thicknesses, and behind them the pyramid.
#[derive(Debug)]
pub struct Field {
    side: usize,
    levels: Levels,
    heights: Buffer,
    steps: Vec<Step>,
    cells: Kernel,
    blocks: Kernel,
}

/// What one level is made from, for the device, and its groups a side.
#[derive(Debug)]
struct Step {
    level: Buffer,
    groups: u32,
}

impl Field {
    /// Puts a height field on the device.
    ///
    /// # Errors
    /// [`RenderError::Gpu`].
    pub fn new(gpu: &Gpu, field: &HeightField) -> Result<Self, RenderError> {
        let bindings = [Access::Uniform, Access::Write];
        let side = field.map().side();
        let levels = Levels::new(side as u32);
        let mut numbers = thicknesses(field);
        numbers.resize(levels.numbers(), 0.0);
        let step = |([source, source_side], [start, side]): ([u32; 2], [u32; 2])| {
            let level = gpu.upload(bytemuck::cast_slice(&[source, source_side, start, side]))?;
            Ok(Step { level, groups: side.div_ceil(8) })
        };
        Ok(Self {
            side,
            heights: gpu.upload(bytemuck::cast_slice(&numbers))?,
            steps: levels.steps().map(step).collect::<Result<_, RenderError>>()?,
            levels,
            cells: gpu.kernel(TEXT, "pyramid_cells", &bindings)?,
            blocks: gpu.kernel(TEXT, "pyramid_blocks", &bindings)?,
        })
    }

    /// Takes another field.
    ///
    /// # Errors
    /// [`RenderError::Gpu`].
    pub fn update(&mut self, gpu: &Gpu, field: &HeightField) -> Result<(), RenderError> {
        if field.map().side() == self.side {
            gpu.replace(&self.heights, bytemuck::cast_slice(&thicknesses(field)))?;
        } else {
            *self = Self::new(gpu, field)?;
        }
        Ok(())
    }

    /// Where the pyramid lies.
    pub fn levels(&self) -> &Levels {
        &self.levels
    }

    /// Thicknesses and pyramid.
    pub fn heights(&self) -> &Buffer {
        &self.heights
    }

    /// Bindings of each pass.
    pub fn bindings(&self) -> Vec<[&Buffer; 2]> {
        self.steps.iter().map(|step| [&step.level, &self.heights]).collect()
    }

    /// The passes, a level each.
    pub fn passes<'a>(&'a self, bindings: &'a [[&'a Buffer; 2]]) -> impl Iterator<Item = Pass<'a>> {
        let kernels = std::iter::once(&self.cells).chain(std::iter::repeat(&self.blocks));
        self.steps.iter().zip(kernels).zip(bindings).map(|((step, kernel), buffers)| {
            let groups = [step.groups, step.groups, 1];
            Pass { name: "pyramid", kernel, buffers, groups }
        })
    }
}

fn thicknesses(field: &HeightField) -> Vec<f32> {
    field.map().values().iter().map(|thickness| *thickness as f32).collect()
}
