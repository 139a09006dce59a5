//! The pyramid of greatest thicknesses above the height field, by which a ray crosses clear air at once.

use crate::RenderError;
use crate::view::LEVELS;
use stratiform_gpu::{Access, Buffer, Gpu, Kernel, Pass};

const TEXT: &str = include_str!("wgsl/pyramid.wgsl");

/// Where each level lies in the buffer behind the thicknesses, and its texels a side.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels(Vec<[u32; 2]>);

impl Levels {
    /// Down to one texel.
    pub fn new(side: u32) -> Self {
        let mut levels = vec![[side * side, side]];
        while let Some(&[start, side]) = levels.last()
            && side > 1
        {
            levels.push([start + side * side, side.div_ceil(2)]);
        }
        Self(levels)
    }

    /// The coarsest.
    pub fn top(&self) -> u32 {
        self.0.len() as u32 - 1
    }

    /// Numbers in the buffer, thicknesses included.
    pub fn numbers(&self) -> usize {
        self.0.last().map_or(0, |[start, side]| (start + side * side) as usize)
    }

    /// For the passes.
    pub fn table(&self) -> [[u32; 4]; LEVELS] {
        std::array::from_fn(|i| self.0.get(i).map_or([0; 4], |[start, side]| [*start, *side, 0, 0]))
    }
}

/// The passes that fill it.
#[derive(Debug)]
pub struct Pyramid {
    cells: Kernel,
    blocks: Kernel,
    levels: Vec<(Buffer, u32)>,
}

impl Pyramid {
    /// For a field of this size.
    ///
    /// # Errors
    /// [`RenderError::Gpu`].
    pub fn new(gpu: &Gpu, levels: &Levels) -> Result<Self, RenderError> {
        let bindings = [Access::Uniform, Access::Write];
        let cells = gpu.kernel(TEXT, "pyramid_cells", &bindings)?;
        let blocks = gpu.kernel(TEXT, "pyramid_blocks", &bindings)?;
        let sources = std::iter::once([0, levels.0[0][1]]).chain(levels.0.iter().copied());
        let level = |([source, source_side], [start, side]): ([u32; 2], &[u32; 2])| {
            Ok((gpu.upload(bytemuck::cast_slice(&[source, source_side, *start, *side]))?, *side))
        };
        let levels = sources.zip(&levels.0).map(level).collect::<Result<_, RenderError>>()?;
        Ok(Self { cells, blocks, levels })
    }

    /// Bindings of each pass.
    pub fn buffers<'a>(&'a self, heights: &'a Buffer) -> Vec<[&'a Buffer; 2]> {
        self.levels.iter().map(|(level, _)| [level, heights]).collect()
    }

    /// One pass a level.
    pub fn passes<'a>(&'a self, buffers: &'a [[&'a Buffer; 2]]) -> Vec<Pass<'a>> {
        let pass = |(index, ((_, side), buffers)): (usize, (&'a (Buffer, u32), &'a [&'a Buffer; 2]))| Pass {
            name: "pyramid",
            kernel: if index == 0 { &self.cells } else { &self.blocks },
            buffers,
            groups: [side.div_ceil(8), side.div_ceil(8), 1],
        };
        self.levels.iter().zip(buffers).enumerate().map(pass).collect()
    }
}
