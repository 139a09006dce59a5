//! From the device's bytes to an image that is one.

use crate::RenderError;
use stratiform_imaging::Image;

/// The image, unless a ray did not end or a pixel is no number.
///
/// # Errors
/// [`RenderError::Endless`] and [`RenderError::NotFinite`], with the pixel.
pub fn image(width: usize, height: usize, bytes: &[u8]) -> Result<Image, RenderError> {
    let numbers: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(bytes);
    let pixel = |(index, [r, g, b, ended]): (usize, &[f32; 4])| {
        let (x, y, value) = (index % width, index / width, [*r, *g, *b]);
        if *ended == 0.0 {
            Err(RenderError::Endless { x, y })
        } else if value.iter().all(|v| v.is_finite()) {
            Ok(value)
        } else {
            Err(RenderError::NotFinite { x, y, value })
        }
    };
    let pixels = numbers.iter().enumerate().map(pixel).collect::<Result<_, _>>()?;
    Ok(Image::new(width, height, pixels)?)
}

/// Whether there is no light in any pixel.
pub fn black(image: &Image) -> bool {
    image.pixels().iter().flatten().all(|v| *v == 0.0)
}
