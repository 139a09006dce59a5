//! Pictures of the scenes that show one effect each, and what is measured in them.
//!
//! Θ is the scattering angle of sunlight that reaches a pixel after one event, the angle between its line of sight and the sun.

pub mod solved;

use glam::DVec3;
use stratiform_gpu::Gpu;
use stratiform_imaging::profile::{Profile, Steps};
use stratiform_imaging::{Image, ImagingError, srgb};
use stratiform_quantities::DomainError;
use stratiform_render::{Contributions, RenderError, Renderer, Settings};
use stratiform_scene::{Scene, SceneError, Sky};
use stratiform_transport::TransportError;
use stratiform_world::{Camera, Contribution, Ground, HeightField, Map, World, WorldError};

/// What stops a picture.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs, reason = "each is what it says")]
pub enum EffectError {
    #[error(transparent)]
    Scene(#[from] SceneError),
    #[error(transparent)]
    World(#[from] WorldError),
    #[error(transparent)]
    Render(#[from] RenderError),
    #[error(transparent)]
    Imaging(#[from] ImagingError),
    #[error(transparent)]
    Transport(#[from] TransportError),
    #[error(transparent)]
    Domain(#[from] DomainError),
}

/// Texels a side of a field in tests, a quarter of a picture's or less.
const SIDE: u32 = 128;

/// The world of `fit-configs/scenes/NAME.toml` as it begins, with a coarser field, under a white sun and a uniform sky.
///
/// # Errors
/// Those of the scene and its files.
pub fn world(name: &str) -> Result<World, EffectError> {
    world_over(name, None)
}

/// The same, repeating every `extent_m` metres in place of the scene's own period.
///
/// # Errors
/// Those of the scene and its files.
pub fn world_over(name: &str, extent_m: Option<f64>) -> Result<World, EffectError> {
    let folder = crate::root().join("fit-configs/scenes");
    let mut scene = Scene::load(&folder.join(name).with_extension("toml"))?;
    if let Some(clouds) = &mut scene.clouds {
        clouds.side = Some(SIDE);
        clouds.extent_m = extent_m.unwrap_or(clouds.extent_m);
    }
    scene.sky = Sky::default();
    scene.sun.irradiance = None;
    Ok(World::build(&scene, &folder, 0.0)?)
}

/// The same with a layer of one thickness.
///
/// # Errors
/// [`WorldError`] for a thickness out of its domain.
pub fn flat(world: &World, thickness_m: f64) -> Result<World, EffectError> {
    let field = HeightField::flat(thickness_m, world.field.map().extent_m())?;
    Ok(World { field, ..world.clone() })
}

/// The same over a ground of one grey.
///
/// # Errors
/// [`WorldError`] for a period out of its domain.
pub fn over(world: &World, albedo: f64) -> Result<World, EffectError> {
    let albedo = Map::new(1, world.field.map().extent_m(), vec![[albedo; 3]])?;
    Ok(World { ground: Ground { albedo }, ..world.clone() })
}

/// The same through another size and field of view, from the lower to the upper edge.
#[must_use]
pub fn seen(world: &World, [width, height]: [usize; 2], field_of_view_deg: f64) -> World {
    let tan_half = libm::tan(0.5 * field_of_view_deg.to_radians());
    World { camera: Camera { width, height, tan_half, ..world.camera }, ..world.clone() }
}

/// The same with the camera turned, its right level.
#[must_use]
pub fn towards(world: &World, forward: DVec3) -> World {
    let right = forward.cross(DVec3::Z).normalize();
    let camera = Camera { forward, right, up: right.cross(forward), ..world.camera };
    World { camera, ..world.clone() }
}

/// The same with the camera moved.
#[must_use]
pub fn from(world: &World, position: DVec3) -> World {
    World { camera: Camera { position, ..world.camera }, ..world.clone() }
}

/// All light but some.
pub fn without(contributions: &[Contribution]) -> Settings {
    let all = Contributions::all();
    let contributions = contributions.iter().fold(all, |kept, contribution| kept.without(*contribution));
    Settings { contributions, ..Settings::default() }
}

/// Light of the sun alone, as the cloud scatters it widely.
pub fn sunlight() -> Settings {
    without(&[Contribution::Background, Contribution::Halo, Contribution::Sky, Contribution::Ground])
}

/// A picture.
///
/// # Errors
/// Those of the renderer.
pub fn draw(gpu: &Gpu, world: &World, settings: &Settings) -> Result<Image, EffectError> {
    Ok(Renderer::new(gpu, world, settings)?.draw()?)
}

/// Line of sight of a pixel's centre.
pub fn ray(world: &World, (x, y): (usize, usize)) -> DVec3 {
    world.camera.ray(x as f64 + 0.5, y as f64 + 0.5)
}

/// Θ of a pixel's centre, degrees.
pub fn scattering_deg(world: &World, place: (usize, usize)) -> f64 {
    let ray = ray(world, place);
    libm::atan2(ray.cross(world.sun.direction).length(), ray.dot(world.sun.direction)).to_degrees()
}

/// Optical thickness of the cloud along a line of sight from below, by its thickness where that meets the base.
pub fn path(world: &World, ray: DVec3) -> f64 {
    let place = world.camera.position + ray * ((world.base_m - world.camera.position.z) / ray.z);
    world.field.thickness(place.x, place.y) * world.material.extinction_per_m / ray.z
}

/// Angle that a pixel in the middle spans, degrees.
pub fn pixel_deg(camera: &Camera) -> f64 {
    (2.0 * camera.tan_half / camera.height as f64).to_degrees()
}

/// All pixels, as (column, row).
pub fn places(image: &Image) -> impl Iterator<Item = (usize, usize)> {
    let width = image.width();
    (0..width * image.height()).map(move |i| (i % width, i / width))
}

/// A channel over Θ, from `low` to `high` in steps of a pixel.
///
/// # Errors
/// [`ImagingError`] for a pixel that is no number.
pub fn rings(
    world: &World,
    image: &Image,
    channel: usize,
    low: f64,
    high: f64,
) -> Result<Profile, EffectError> {
    let width = pixel_deg(&world.camera);
    let pixel = |(x, y)| (scattering_deg(world, (x, y)), f64::from(image.at(x, y)[channel]));
    Ok(Profile::new(&steps(low, high, width), places(image).map(pixel))?)
}

/// Steps of about `width` that fill what lies between.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of steps")]
pub fn steps(low: f64, high: f64, width: f64) -> Steps {
    let count = libm::ceil((high - low) / width).max(1.0);
    Steps { start: low, width: (high - low) / count, count: count as usize }
}

/// A pixel's luminance.
pub fn luminance(pixel: [f32; 3]) -> f64 {
    srgb::luminance(pixel.map(f64::from))
}
