//! What no picture can be made of.

use crate::RenderError;
use stratiform_quantities::Range;
use stratiform_world::World;

/// Pixels each way.
const SIZE: Range = Range::closed(1.0, 65_536.0);

/// Texels a side of the height field.
const SIDE: Range = Range::closed(1.0, 8192.0);

/// κH of the thickest place, where the generated text ends.
const TAU: Range = Range::closed(0.0, 1e6);

/// Refuses what the passes cannot draw.
///
/// # Errors
/// [`RenderError::Domain`] with value and range, [`RenderError::InsideCloud`].
pub fn check(world: &World) -> Result<(), RenderError> {
    let (camera, field) = (&world.camera, &world.field);
    SIZE.check("columns of the picture", camera.width as f64)?;
    SIZE.check("rows of the picture", camera.height as f64)?;
    SIDE.check("texels a side of the height field", field.map().side() as f64)?;
    let cosine = Range { min_included: false, ..Range::closed(0.0, 1.0 + 1e-12) };
    cosine.check("cosine of the sun's zenith angle", world.sun.direction.z)?;
    TAU.check("greatest optical thickness", world.material.extinction_per_m * field.most())?;
    Range::above(0.0).check("altitude of the camera, m", camera.position.z)?;
    let height_m = camera.position.z - world.base_m;
    let thickness_m = field.thickness(camera.position.x, camera.position.y);
    if thickness_m > 0.0 && (0.0..=thickness_m).contains(&height_m) {
        return Err(RenderError::InsideCloud { height_m, thickness_m });
    }
    Ok(())
}
