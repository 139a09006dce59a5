//! `stratiform view` as typed.

use super::render::size;
use crate::numbers::count;
use clap::Args;

/// `stratiform view`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  stratiform view stratocumulus\n  stratiform view fit-configs/scenes/stratocumulus.toml --size 960x540\n\
                  Keys, by their place on an American keyboard: W A S D move, Q E down and up, Shift faster; drag with the left button to \
                  look; arrows or I J K L move the sun; Space runs time, [ and ] halve and double its speed; + and - expose by a quarter \
                  of a stop; M switches between the angular and the fitted model; 1 to 7 switch background, halo, single, double, \
                  multiple, sky, ground; Escape closes. What would move the camera into the cloud or the ground is not done.\n\
                  Needs a display (X11 or Wayland), a Vulkan driver, software ones included, and the cargo feature `view`."
)]
pub struct WindowArgs {
    /// A scene with camera and clouds: a file, or a name such as stratocumulus.
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Columns and rows of the window instead of the scene's.
    #[arg(long, value_parser = size, value_name = "WxH")]
    pub size: Option<[usize; 2]>,
    /// Close after so many pictures.
    #[arg(long, value_parser = count, value_name = "N")]
    pub frames: Option<u64>,
}
