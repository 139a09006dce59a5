//! A scene and its files made concrete.

use crate::field::height_field;
use crate::{Air, Camera, ClearSky, Material, Sky, Sun, World, WorldError, ground_map};
use glam::DVec3;
use std::f64::consts::PI;
use std::path::Path;
use stratiform_quantities::Range;
use stratiform_scene as said;
use stratiform_scene::{Scene, SkyModel, direction};

impl World {
    /// What `scene` says, its files named from `folder`, the clouds as they are at `moment_s`.
    ///
    /// # Errors
    /// [`WorldError::Contents`] for a scene that is no picture, a camera inside the cloud, or droplets other than those of the tables; those of
    /// the files.
    pub fn build(scene: &Scene, folder: &Path, moment_s: f64) -> Result<Self, WorldError> {
        let (said_camera, clouds) = picture(scene)?;
        let tables = folder.join(&clouds.tables);
        let material = Material::load(&tables)?;
        agree(scene, &material, &tables)?;
        let (sun, sky) = lights(scene, clouds)?;
        let world = Self {
            camera: Camera::of(said_camera),
            sun,
            sky,
            ground: ground_map::ground(&scene.ground_or_default(), clouds.extent_m, folder)?,
            base_m: clouds.base_m,
            field: height_field(clouds, folder, moment_s)?,
            material,
        };
        world.outside(&world.camera)?;
        Ok(world)
    }

    /// Moves the clouds to another moment of the same scene.
    ///
    /// # Errors
    /// Those of [`build`](Self::build) that concern clouds and camera; then nothing has changed.
    pub fn advance(&mut self, scene: &Scene, folder: &Path, moment_s: f64) -> Result<(), WorldError> {
        let (_, clouds) = picture(scene)?;
        let before = std::mem::replace(&mut self.field, height_field(clouds, folder, moment_s)?);
        let outside = self.outside(&self.camera);
        if outside.is_err() {
            self.field = before;
        }
        outside
    }

    /// Moves the sun to where the scene has it now; the sky goes with it.
    ///
    /// # Errors
    /// Those of [`build`](Self::build) that concern sun and sky; then nothing has changed.
    pub fn shine(&mut self, scene: &Scene) -> Result<(), WorldError> {
        let (_, clouds) = picture(scene)?;
        (self.sun, self.sky) = lights(scene, clouds)?;
        Ok(())
    }

    /// Refuses a camera that is inside the cloud, below the ground, or out of this world.
    ///
    /// # Errors
    /// [`WorldError::Domain`] for its altitude, [`WorldError::Contents`] where it is in the cloud.
    pub fn outside(&self, camera: &Camera) -> Result<(), WorldError> {
        let [x, y, z] = camera.position.to_array();
        Range { min_included: false, ..Range::closed(0.0, 1e6) }.check("camera.position_m.z", z)?;
        let thickness = self.field.thickness(x, y);
        if thickness > 0.0 && (self.base_m..=self.base_m + thickness).contains(&z) {
            return Err(WorldError::Contents(format!(
                "the camera at camera.position_m = [{x}, {y}, {z}] is inside the cloud, which reaches from {} to {} m there",
                self.base_m,
                self.base_m + thickness
            )));
        }
        Ok(())
    }
}

fn picture(scene: &Scene) -> Result<(&said::Camera, &said::Clouds), WorldError> {
    match (&scene.camera, &scene.clouds) {
        (Some(camera), Some(clouds)) => Ok((camera, clouds)),
        _ => Err(WorldError::Contents(format!(
            "`{}` is no picture: it has neither [camera] nor [clouds]",
            scene.title
        ))),
    }
}

impl Camera {
    /// As the scene says.
    pub fn of(camera: &said::Camera) -> Self {
        let [forward, right, up] = camera.axes().map(DVec3::from_array);
        Self {
            position: DVec3::from_array(camera.position_m),
            forward,
            right,
            up,
            tan_half: camera.tan_half(),
            width: camera.width as usize,
            height: camera.height as usize,
        }
    }
}

/// Sun and sky above the clouds; without an irradiance of its own the sun has the colour that clear air leaves it.
fn lights(scene: &Scene, clouds: &said::Clouds) -> Result<(Sun, Sky), WorldError> {
    let mut sun = sun(&scene.sun)?;
    let sky = sky(scene, &sun, clouds)?;
    if let (Sky::Clear(clear), None) = (&sky, scene.sun.irradiance) {
        sun.irradiance = clear.sun_irradiance();
    }
    Ok((sun, sky))
}

fn sun(sun: &said::Sun) -> Result<Sun, WorldError> {
    let theta_deg = sun.theta_deg.single().ok_or_else(|| {
        let said::Interval { min, max } = sun.theta_deg;
        WorldError::Contents(format!("sun.theta_deg runs from {min} to {max}: a picture needs one value"))
    })?;
    Ok(Sun {
        direction: DVec3::from_array(direction(sun.azimuth_deg, 90.0 - theta_deg)),
        irradiance: sun.irradiance.unwrap_or([1.0; 3]),
        angular_radius_deg: sun.angular_radius_deg,
    })
}

/// Share of the sun's light that a uniform sky has where nobody says: that of Bouthors, Neyret & Lefebvre 2006.
const SHARE: f64 = 0.25;

/// The sky above the base of the clouds.
fn sky(scene: &Scene, sun: &Sun, clouds: &said::Clouds) -> Result<Sky, WorldError> {
    let said = &scene.sky;
    if said.model == SkyModel::Uniform {
        return Ok(Sky::Uniform([said.share.unwrap_or(SHARE) / PI; 3]));
    }
    let usual = Air::default();
    let air = Air {
        turbidity: said.turbidity.unwrap_or(usual.turbidity),
        ground_albedo: scene.ground_or_default().mean_albedo().unwrap_or(usual.ground_albedo),
        altitude_m: clouds.base_m,
        ..usual
    };
    Ok(Sky::Clear(ClearSky::new(sun.direction, &air)?))
}

/// How far the record of a folder may be from the scene, relative: digits that people write.
const SAME: f64 = 1e-6;

/// Refuses tables of another cloud than the scene's.
fn agree(scene: &Scene, material: &Material, tables: &Path) -> Result<(), WorldError> {
    let droplets = &scene.droplets;
    let radius = droplets.effective_radius_um.single();
    let number = droplets.number_density_per_cm3;
    let by_paper = material.extinction_convention == stratiform_quantities::ExtinctionConvention::Paper;
    let extinction = number.zip(radius).filter(|_| by_paper).map(|(number, r)| 1e-6 * number * PI * r * r);
    let claims = [
        ("droplets.theta_f_deg", Some(droplets.theta_f_deg), material.theta_f_deg),
        (
            "droplets.single_scattering_albedo",
            droplets.single_scattering_albedo.map(|omega| omega.get()),
            material.single_scattering_albedo,
        ),
        (
            "the extinction per metre of droplets.effective_radius_um and number_density_per_cm3",
            extinction,
            material.extinction_per_m,
        ),
    ];
    for (name, scene, folder) in claims {
        let Some(scene) = scene.filter(|scene| (scene - folder).abs() > SAME * folder.abs()) else {
            continue;
        };
        return Err(WorldError::Folder {
            folder: tables.to_owned(),
            message: format!(
                "its tables are of another cloud: {name} is {scene} in the scene and {folder} in the folder"
            ),
        });
    }
    Ok(())
}
