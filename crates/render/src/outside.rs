//! The ground's albedo and the sky's table on the device, one behind the other.

use crate::RenderError;
use stratiform_gpu::{Buffer, Gpu};
use stratiform_world::{Ground, SkyTable};

/// The buffer.
#[derive(Debug)]
pub struct Outside {
    texels: usize,
    buffer: Buffer,
}

impl Outside {
    /// Puts both on the device.
    ///
    /// # Errors
    /// [`RenderError::Gpu`].
    pub fn new(gpu: &Gpu, ground: &Ground, sky: &SkyTable) -> Result<Self, RenderError> {
        let texels = texels(ground, sky);
        Ok(Self { texels: texels.len(), buffer: gpu.upload(bytemuck::cast_slice(&texels))? })
    }

    /// Takes others.
    ///
    /// # Errors
    /// [`RenderError::Gpu`].
    pub fn update(&mut self, gpu: &Gpu, ground: &Ground, sky: &SkyTable) -> Result<(), RenderError> {
        let texels = texels(ground, sky);
        if texels.len() == self.texels {
            gpu.replace(&self.buffer, bytemuck::cast_slice(&texels))?;
        } else {
            *self = Self::new(gpu, ground, sky)?;
        }
        Ok(())
    }

    /// Albedo, then sky.
    pub fn buffer(&self) -> &Buffer {
        &self.buffer
    }
}

fn texels(ground: &Ground, sky: &SkyTable) -> Vec<[f32; 4]> {
    let albedo = ground.albedo.values().iter().map(|albedo| albedo.map(|c| c as f32));
    albedo.chain(sky.values.iter().copied()).map(|[r, g, b]| [r, g, b, 0.0]).collect()
}
