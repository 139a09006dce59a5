//! `stratiform view`: a window on a scene. Without the cargo feature `view` it says how to get one.

use crate::CliError;
use crate::args::WindowArgs;
use crate::output::{Data, Talk};

/// Runs the command; returns when the window is closed.
///
/// # Errors
/// [`CliError::Input`] for a scene that is no picture, and for a display or a device that is missing or fails.
#[cfg(feature = "view")]
pub fn run(args: &WindowArgs, talk: Talk) -> Result<Data, CliError> {
    use crate::commands::picture::folder;
    use crate::commands::render::said;
    use crate::pipeline::input_error;
    use stratiform_viewer::{HELP, Subject, view};

    let (name, mut scene) = stratiform_scene::find(&args.scene).map_err(input_error)?;
    if let (Some([width, height]), Some(camera)) = (args.size, &mut scene.camera) {
        (camera.width, camera.height) = (width as u32, height as u32);
    }
    let settings = said(&scene);
    let subject = Subject { name, folder: folder(&args.scene), scene, settings, frames: args.frames };
    talk.say(HELP);
    let seen = view(subject).map_err(input_error)?;
    talk.say(format!("{} pictures on {}", seen.frames, seen.adapter));
    Ok(Data::new())
}

/// Refuses.
///
/// # Errors
/// [`CliError::Input`], always.
#[cfg(not(feature = "view"))]
pub fn run(args: &WindowArgs, _talk: Talk) -> Result<Data, CliError> {
    Err(crate::commands::picture::unavailable("open a window on", &args.scene, "view"))
}
