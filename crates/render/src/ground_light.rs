//! The light between ground and cloud, read back.

use crate::RenderError;
use crate::radiosity::Buffers;
use stratiform_gpu::{Buffer, Gpu};

/// Irradiances in linear sRGB, maps row by row from the south over one period of the height field.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundLight {
    /// Of the ground by the sun directly; texels of the height field.
    pub direct: Vec<[f32; 3]>,
    /// Of the ground by cloud and sky; texels of the exchange.
    pub indirect: Vec<[f32; 3]>,
    /// Of the cloud's base by the ground; texels of the exchange.
    pub on_cloud: Vec<[f32; 3]>,
}

impl GroundLight {
    pub(crate) fn read(gpu: &Gpu, buffers: &Buffers) -> Result<Self, RenderError> {
        let map = |buffer: &Buffer| {
            let texels: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&gpu.download(buffer)?);
            Ok::<_, RenderError>(texels.into_iter().map(|[r, g, b, _]| [r, g, b]).collect())
        };
        Ok(Self {
            direct: map(&buffers.ground_direct)?,
            indirect: map(&buffers.ground_indirect)?,
            on_cloud: map(&buffers.cloud_from_ground)?,
        })
    }
}
