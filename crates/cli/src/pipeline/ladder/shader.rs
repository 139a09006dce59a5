//! The last rung's device: the emitted shader, executed. Without the cargo feature `gpu`, or without an adapter, there is a
//! reason instead of a result.

use super::loss::Nine;
use crate::CliError;
use std::path::Path;

/// What executes shaders, or why nothing does.
pub struct Device {
    #[cfg(feature = "gpu")]
    gpu: Result<stratiform_gpu::Gpu, String>,
}

#[cfg(feature = "gpu")]
impl Device {
    /// Opens the adapter that the system prefers.
    pub fn open() -> Self {
        Self { gpu: stratiform_gpu::Gpu::new().map_err(|error| error.to_string()) }
    }

    /// The adapter, or the reason why there is none.
    pub fn name(&self) -> Result<&str, &str> {
        self.gpu.as_ref().map(stratiform_gpu::Gpu::adapter).map_err(String::as_str)
    }

    /// Every flux of the emitted module in `dir` at (μ_l, τ), with μ_l = -1 for diffuse light; nothing without a
    /// device, or if WGSL is none of the targets.
    ///
    /// # Errors
    /// [`CliError::Failed`] if the device refuses the shader, [`CliError::Input`] if the text cannot be read.
    pub fn evaluate(&self, dir: &Path, inputs: &[[f32; 2]]) -> Result<Vec<Nine>, CliError> {
        let Ok(gpu) = &self.gpu else { return Ok(Vec::new()) };
        let folder = dir.join("generated");
        if !folder.join("stratiform.wgsl").exists() {
            return Ok(Vec::new());
        }
        let read = |name: &str| stratiform_artifact::read_text(&folder.join(name));
        let module = format!("{}\n{}", read("stratiform.wgsl")?, read("stratiform_self_test.wgsl")?);
        let bytes: Vec<u8> = inputs.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        let groups = [u32::try_from(inputs.len().div_ceil(64)).unwrap_or(u32::MAX), 1, 1];
        let output = gpu
            .run(&module, "stratiform_self_test_kernel", &[&bytes], 36 * inputs.len(), groups)
            .map_err(|error| CliError::Failed(error.to_string()))?;
        let single = |bytes: &[u8]| f64::from(bytes.try_into().map_or(f32::NAN, f32::from_le_bytes));
        Ok(output
            .chunks_exact(36)
            .map(|nine| std::array::from_fn(|i| single(&nine[4 * i..4 * i + 4])))
            .collect())
    }
}

#[cfg(not(feature = "gpu"))]
impl Device {
    /// Nothing to open.
    pub fn open() -> Self {
        Self {}
    }

    /// The reason why there is no device.
    pub fn name(&self) -> Result<&str, &str> {
        Err("built without the cargo feature `gpu`")
    }

    /// Nothing.
    pub fn evaluate(&self, _dir: &Path, _inputs: &[[f32; 2]]) -> Result<Vec<Nine>, CliError> {
        Ok(Vec::new())
    }
}
