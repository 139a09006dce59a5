//! Why there is no window, or no longer one.

use stratiform_gpu::GpuError;
use stratiform_render::RenderError;
use stratiform_world::WorldError;

/// What a window cannot be opened or kept for.
#[derive(Debug, thiserror::Error)]
pub enum ViewerError {
    /// There is no display.
    #[error("there is no display to open a window on: {reason}")]
    NoDisplay {
        /// What the window system said.
        reason: String,
    },
    /// The window system failed.
    #[error("the window system failed: {reason}")]
    Window {
        /// What it said.
        reason: String,
    },
    /// The device, or the window's surface.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The picture.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The scene.
    #[error(transparent)]
    World(#[from] WorldError),
}

impl ViewerError {
    /// Whether device or surface are gone, so that new ones may serve.
    pub(crate) fn is_loss(&self) -> bool {
        let (Self::Gpu(error) | Self::Render(RenderError::Gpu(error))) = self else { return false };
        matches!(error, GpuError::Lost { .. } | GpuError::ScreenLost)
    }
}
