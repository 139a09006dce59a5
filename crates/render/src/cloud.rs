//! A material on the device: its tables, and the picture's kernel around its generated text.

use crate::{Model, RenderError, generated, phase_table};
use std::path::PathBuf;
use stratiform_gpu::{Access, Buffer, Gpu, Kernel};
use stratiform_optics::phase::PhaseTable;
use stratiform_world::Material;

const TEXTS: [&str; 6] = [
    include_str!("wgsl/view.wgsl"),
    include_str!("wgsl/field.wgsl"),
    include_str!("wgsl/march.wgsl"),
    include_str!("wgsl/surroundings.wgsl"),
    include_str!("wgsl/events.wgsl"),
    include_str!("wgsl/picture.wgsl"),
];

/// Bindings of the picture's kernel: phase table, halo, view, heights, ground and sky, three of the light between ground and cloud, picture.
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

/// What depends on material and model alone.
#[derive(Debug)]
pub struct Cloud {
    source: Source,
    /// Rows of phase functions.
    pub phase: Buffer,
    /// Shapes of the halo.
    pub halo: Buffer,
    /// The picture's.
    pub kernel: Kernel,
}

/// What tells one from another.
#[derive(Debug)]
struct Source {
    folder: PathBuf,
    model: Model,
    colour: [PhaseTable; 3],
    colour_squared: [PhaseTable; 3],
}

impl Cloud {
    /// Reads, uploads, compiles.
    ///
    /// # Errors
    /// [`RenderError`] for missing files, or a device that refuses.
    pub fn new(gpu: &Gpu, material: &Material, model: Model) -> Result<Self, RenderError> {
        Ok(Self {
            source: Source {
                folder: material.generated.clone(),
                model,
                colour: material.colour.clone(),
                colour_squared: material.colour_squared.clone(),
            },
            phase: gpu.upload(bytemuck::cast_slice(&phase_table::phase_table(material)?))?,
            halo: gpu.upload(bytemuck::cast_slice(&generated::halo(&material.generated)?))?,
            kernel: gpu.kernel(&text(material, model)?, "picture_pixels", &BINDINGS)?,
        })
    }

    /// Whether it is that of this material and model.
    pub fn is_of(&self, material: &Material, model: Model) -> bool {
        let source = &self.source;
        source.folder == material.generated
            && source.model == model
            && source.colour == material.colour
            && source.colour_squared == material.colour_squared
    }
}

fn text(material: &Material, model: Model) -> Result<String, RenderError> {
    let orders = match model {
        Model::Angular => include_str!("wgsl/angular.wgsl"),
        Model::Fitted => include_str!("wgsl/fitted.wgsl"),
    };
    let generated = generated::text(&material.generated, model)?;
    Ok([generated.as_str(), orders].into_iter().chain(TEXTS).collect::<Vec<_>>().join("\n"))
}
