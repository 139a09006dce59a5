//! Time of each pass against resolution and exchanges of light between ground and cloud.

use super::{Draw, Subject, model_name};
use crate::CliError;
use stratiform_artifact::RenderCostRow;
use stratiform_gpu::Gpu;
use stratiform_render::{Radiosity, Settings};

/// Frames of which a time is the median.
const FRAMES: usize = 7;
/// Exchanges at every size; `None`: as many as needed.
const PASSES: [Option<u32>; 6] = [Some(0), Some(1), Some(2), Some(4), Some(8), None];

/// A row for each size, model, number of exchanges and pass.
///
/// # Errors
/// [`CliError::Input`] for what cannot be drawn, [`CliError::Failed`] where the device has no clock.
pub fn costs(
    gpu: &Gpu,
    subject: &Subject<'_>,
    sizes: &[[usize; 2]],
    watch: impl Fn(&str),
) -> Result<Vec<RenderCostRow>, CliError> {
    let mut rows = Vec::new();
    for &[width, height] in sizes {
        watch(&format!("{width} x {height}"));
        let mut world = subject.world.clone();
        (world.camera.width, world.camera.height) = (width, height);
        let mut draw = Draw::new(gpu, &world, &subject.settings, 1)?;
        for &model in subject.models {
            for passes in PASSES {
                let radiosity = Radiosity { passes, ..subject.settings.radiosity };
                let times = draw.times(&Settings { model, radiosity, ..subject.settings }, FRAMES)?;
                rows.extend(times.into_iter().map(|(pass, ms)| RenderCostRow {
                    scene: subject.name.to_owned(),
                    adapter: gpu.adapter().to_owned(),
                    width: width as u64,
                    height: height as u64,
                    model: model_name(model).to_owned(),
                    radiosity_side: u64::from(radiosity.side),
                    radiosity_passes: passes.map(u64::from),
                    pass,
                    ms,
                }));
            }
        }
    }
    if rows.is_empty() {
        return Err(CliError::Failed(format!("{} has no time stamps: no costs", gpu.adapter())));
    }
    Ok(rows)
}
