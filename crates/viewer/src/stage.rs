//! Window, device and renderer.

use crate::ViewerError;
use crate::scenery::Scenery;
use std::sync::Arc;
use stratiform_gpu::{Gpu, Screen};
use stratiform_render::Renderer;
use winit::window::Window;

/// `fn shown(radiance, exposure_ev)` in WGSL: stored sRGB.
pub const TONE: &str = include_str!("tone.wgsl");

/// What shows the scenery.
#[derive(Debug)]
pub struct Stage {
    gpu: Gpu,
    screen: Screen,
    renderer: Renderer,
}

impl Stage {
    /// On a window; the first picture is read back and checked.
    ///
    /// # Errors
    /// [`ViewerError`] for a device that cannot show it, and a picture that is none.
    pub fn open(window: Arc<Window>, scenery: &Scenery) -> Result<Self, ViewerError> {
        let (gpu, screen) = Gpu::for_window(window, size(scenery), TONE)?;
        let mut renderer = Renderer::new(&gpu, scenery.world(), &scenery.state().settings)?;
        renderer.draw()?;
        Ok(Self { gpu, screen, renderer })
    }

    /// Which device shows it.
    pub fn adapter(&self) -> &str {
        self.gpu.adapter()
    }

    /// Draws and shows; false if the window shows nothing just now.
    ///
    /// # Errors
    /// [`ViewerError`] for what the renderer refuses, and for a device that fails.
    pub fn show(&mut self, scenery: &Scenery) -> Result<bool, ViewerError> {
        self.renderer.update(scenery.world(), &scenery.state().settings)?;
        self.screen.resize(size(scenery))?;
        let pixels = self.renderer.paint()?;
        Ok(self.screen.present(pixels, size(scenery), scenery.state().exposure_ev as f32)?)
    }
}

fn size(scenery: &Scenery) -> [u32; 2] {
    [scenery.state().camera.width, scenery.state().camera.height]
}
