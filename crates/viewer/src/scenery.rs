//! The scene as it stands: state and world together.

use crate::state::{Action, Motion, State};
use std::path::PathBuf;
use stratiform_render::Settings;
use stratiform_scene::{Interval, Scene, Sun};
use stratiform_world::{Camera, World, WorldError};

/// What is looked at.
#[derive(Debug)]
pub struct Scenery {
    scene: Scene,
    folder: PathBuf,
    world: World,
    state: State,
}

impl Scenery {
    /// A scene at its beginning.
    ///
    /// # Errors
    /// Those of [`World::build`].
    pub fn new(scene: Scene, folder: PathBuf, settings: Settings) -> Result<Self, WorldError> {
        let world = World::build(&scene, &folder, 0.0)?;
        let camera =
            scene.camera.ok_or_else(|| WorldError::Contents("the scene has no [camera]".to_owned()))?;
        let state = State::of(&scene, camera, settings);
        Ok(Self { scene, folder, world, state })
    }

    /// The world.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// What can be changed.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// So many seconds of motions.
    ///
    /// # Errors
    /// [`WorldError`] for a camera that would enter the cloud or the ground, and for a sun that the sky refuses: they stay where they are.
    pub fn step(
        &mut self,
        motions: impl IntoIterator<Item = Motion>,
        seconds: f64,
        fast: bool,
    ) -> Result<(), WorldError> {
        let mut next = self.state;
        motions.into_iter().for_each(|motion| next.step(motion, seconds, fast));
        let shone = self.shine(&mut next);
        let outside = self.world.outside(&Camera::of(&next.camera));
        if outside.is_err() {
            next.camera.position_m = self.state.camera.position_m;
        }
        self.take(next);
        shone.and(outside)
    }

    /// Moves the sun, and the sky with it; a sun that is refused is put back.
    fn shine(&mut self, next: &mut State) -> Result<(), WorldError> {
        let sun = |state: &State| (state.sun_theta_deg, state.sun_azimuth_deg);
        let (theta, azimuth_deg) = sun(next);
        if sun(&self.state) == sun(next) {
            return Ok(());
        }
        let theta_deg = Interval { min: theta, max: theta };
        let before = self.scene.sun;
        self.scene.sun = Sun { theta_deg, azimuth_deg, ..before };
        let shone = self.world.shine(&self.scene);
        if shone.is_err() {
            self.scene.sun = before;
            (next.sun_theta_deg, next.sun_azimuth_deg) = sun(&self.state);
        }
        shone
    }

    /// The mouse went so many pixels right and down.
    pub fn look(&mut self, way: [f64; 2]) {
        let mut next = self.state;
        next.look(way);
        self.take(next);
    }

    /// A key.
    pub fn act(&mut self, action: Action) {
        self.state.act(action);
    }

    /// A window of another size.
    pub fn resize(&mut self, [width, height]: [u32; 2]) {
        let mut next = self.state;
        (next.camera.width, next.camera.height) = (width, height);
        self.take(next);
    }

    /// So many seconds before the window, if time runs.
    ///
    /// # Errors
    /// [`WorldError`] if the cloud would reach the camera: then time stands.
    pub fn run(&mut self, seconds: f64) -> Result<(), WorldError> {
        if !self.state.running {
            return Ok(());
        }
        let moment_s = self.state.moment_s + self.state.rate * seconds;
        let advanced = self.world.advance(&self.scene, &self.folder, moment_s);
        match advanced {
            Ok(()) => self.state.moment_s = moment_s,
            Err(_) => self.state.running = false,
        }
        advanced
    }

    fn take(&mut self, state: State) {
        self.state = state;
        self.world.camera = Camera::of(&state.camera);
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

    use super::*;
    use std::path::Path;
    use stratiform_scene::named;

    fn scenery(change: impl Fn(&mut Scene)) -> Scenery {
        let mut scene = named("stratocumulus").unwrap();
        scene.clouds.as_mut().unwrap().side = Some(32);
        change(&mut scene);
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fit-configs/scenes");
        Scenery::new(scene, folder, Settings::default()).unwrap()
    }

    #[test]
    fn the_world_follows_the_state() {
        let mut scenery = scenery(|_| ());
        let before = scenery.world().clone();
        scenery.step([Motion::SunLeft, Motion::Ahead], 0.1, false).unwrap();
        scenery.resize([64, 32]);
        let after = scenery.world();
        assert_ne!(after.sun.direction, before.sun.direction);
        assert_ne!(after.camera.position, before.camera.position);
        assert_eq!((after.camera.width, after.camera.height), (64, 32));
    }

    #[test]
    fn a_clear_sky_goes_with_the_sun() {
        let mut scenery = scenery(|scene| {
            scene.sky =
                stratiform_scene::Sky { model: stratiform_scene::SkyModel::Clear, ..Default::default() };
        });
        let before = scenery.world().clone();
        scenery.step([Motion::SunLower], 1.0, false).unwrap();
        assert_ne!(scenery.world().sky, before.sky);
        assert_ne!(scenery.world().sun.irradiance, before.sun.irradiance, "a lower sun is redder");
    }

    #[test]
    fn the_camera_stays_out_of_cloud_and_ground() {
        let deep = |scene: &mut Scene| {
            let clouds = scene.clouds.as_mut().unwrap();
            clouds.pattern = Some(stratiform_scene::Pattern::Flat);
            (clouds.cover, clouds.cell_m, clouds.seed, clouds.evolution_s) = (None, None, None, None);
            clouds.wind_m_per_s = [0.0; 2];
            (clouds.side, clouds.thickness_m) = (None, Some(Interval { min: 0.0, max: 500.0 }));
            scene.camera.as_mut().unwrap().position_m[2] = 2510.0;
        };
        let mut scenery = scenery(deep);
        let refused = scenery.step([Motion::Down, Motion::SunLower], 0.1, false).unwrap_err();
        assert!(refused.to_string().contains("inside the cloud"), "{refused}");
        assert_eq!(scenery.state().camera.position_m[2], 2510.0);
        assert!(scenery.state().sun_theta_deg > 55.0, "what the world does not refuse goes on");
        scenery.step([Motion::Up], 0.1, false).unwrap();
        assert!(scenery.step([Motion::Down], 100.0, false).is_err(), "below the ground");
    }

    #[test]
    fn clouds_move_only_while_time_runs() {
        let mut scenery = scenery(|_| ());
        let before = scenery.world().field.clone();
        scenery.run(1.0).unwrap();
        assert_eq!(scenery.world().field, before);
        scenery.act(Action::RunOrPause);
        scenery.run(1.0).unwrap();
        assert_ne!(scenery.world().field, before);
        assert_eq!(scenery.state().moment_s, scenery.state().rate);
    }
}
