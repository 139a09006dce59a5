//! What can be changed while one looks, and what each key changes. At the end of its range a key does nothing more.

use stratiform_render::{Model, Settings};
use stratiform_scene::{Camera, Scene, direction};
use stratiform_world::Contribution;

/// What goes on as long as a key is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Motion {
    /// Where the camera looks.
    Ahead,
    /// Away from there.
    Back,
    /// To the left of the picture.
    Left,
    /// To its right.
    Right,
    /// To the zenith.
    Up,
    /// To the ground.
    Down,
    /// Sun to the zenith.
    SunHigher,
    /// Sun to the horizon.
    SunLower,
    /// Sun against the clock, seen from above.
    SunLeft,
    /// Sun with the clock.
    SunRight,
}

/// What happens once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Time.
    RunOrPause,
    /// Time at half the speed.
    Slower,
    /// Time at twice the speed.
    Faster,
    /// A quarter of a stop more.
    Brighter,
    /// A quarter of a stop less.
    Darker,
    /// Angular or fitted.
    OtherModel,
    /// On or off, by its place.
    Contribution(usize),
}

/// Of the camera, m/s.
const SPEED: f64 = 300.0;
/// With Shift.
const FAST: f64 = 5.0;
/// Of the sun, degrees/s.
const TURN: f64 = 15.0;
/// The sun's greatest angle to the zenith, degrees.
const LOWEST_SUN: f64 = 89.0;
/// The camera's greatest elevation, degrees.
const STEEPEST: f64 = 89.0;
/// Stops.
const EXPOSURES: [f64; 2] = [-20.0, 20.0];
/// Seconds of the scene in one.
const RATES: [f64; 2] = [1.0, 4096.0];

/// All that changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Where one looks from.
    pub camera: Camera,
    /// The sun's angle to the zenith, degrees.
    pub sun_theta_deg: f64,
    /// Clockwise from north, degrees in [0, 360).
    pub sun_azimuth_deg: f64,
    /// The clouds' moment, s.
    pub moment_s: f64,
    /// Seconds of the scene in one.
    pub rate: f64,
    /// Whether time runs.
    pub running: bool,
    /// Stops.
    pub exposure_ev: f64,
    /// What is drawn.
    pub settings: Settings,
}

impl State {
    /// As the scene says, time standing.
    pub fn of(scene: &Scene, camera: Camera, settings: Settings) -> Self {
        Self {
            camera,
            sun_theta_deg: scene.sun.theta_deg.min,
            sun_azimuth_deg: turned(scene.sun.azimuth_deg),
            moment_s: 0.0,
            rate: 64.0,
            running: false,
            exposure_ev: scene.picture.exposure_ev,
            settings,
        }
    }

    /// After so many seconds of a motion.
    pub fn step(&mut self, motion: Motion, seconds: f64, fast: bool) {
        let turn = TURN * seconds;
        match motion {
            Motion::SunHigher => self.sun_theta_deg = (self.sun_theta_deg - turn).max(0.0),
            Motion::SunLower => self.sun_theta_deg = (self.sun_theta_deg + turn).min(LOWEST_SUN),
            Motion::SunLeft => self.sun_azimuth_deg = turned(self.sun_azimuth_deg - turn),
            Motion::SunRight => self.sun_azimuth_deg = turned(self.sun_azimuth_deg + turn),
            _ => self.fly(motion, SPEED * seconds * if fast { FAST } else { 1.0 }),
        }
    }

    fn fly(&mut self, motion: Motion, metres: f64) {
        let [ahead, right, _] = self.camera.axes();
        let zenith = direction(0.0, 90.0);
        let (towards, metres) = match motion {
            Motion::Ahead => (ahead, metres),
            Motion::Back => (ahead, -metres),
            Motion::Right => (right, metres),
            Motion::Left => (right, -metres),
            Motion::Up => (zenith, metres),
            Motion::Down => (zenith, -metres),
            _ => return,
        };
        for (place, component) in self.camera.position_m.iter_mut().zip(towards) {
            *place += metres * component;
        }
    }

    /// The picture follows the mouse, which went so many pixels right and down.
    pub fn look(&mut self, [right, down]: [f64; 2]) {
        let camera = &mut self.camera;
        let degrees = camera.field_of_view_deg / f64::from(camera.height);
        camera.azimuth_deg = turned(camera.azimuth_deg - degrees * right);
        camera.elevation_deg = (camera.elevation_deg + degrees * down).clamp(-STEEPEST, STEEPEST);
    }

    /// After a key.
    pub fn act(&mut self, action: Action) {
        match action {
            Action::RunOrPause => self.running = !self.running,
            Action::Slower => self.rate = (0.5 * self.rate).max(RATES[0]),
            Action::Faster => self.rate = (2.0 * self.rate).min(RATES[1]),
            Action::Brighter => self.exposure_ev = (self.exposure_ev + 0.25).min(EXPOSURES[1]),
            Action::Darker => self.exposure_ev = (self.exposure_ev - 0.25).max(EXPOSURES[0]),
            Action::OtherModel => {
                self.settings.model = match self.settings.model {
                    Model::Angular => Model::Fitted,
                    Model::Fitted => Model::Angular,
                }
            }
            Action::Contribution(place) => self.switch(Contribution::ALL[place]),
        }
    }

    fn switch(&mut self, contribution: Contribution) {
        let set = &mut self.settings.contributions;
        *set = if set.has(contribution) { set.without(contribution) } else { set.with(contribution) };
    }
}

/// An azimuth in [0, 360).
fn turned(degrees: f64) -> f64 {
    let rest = degrees.rem_euclid(360.0);
    // A hair below 0 is rounded to 360.
    if rest < 360.0 { rest } else { 0.0 }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

    use super::*;
    use stratiform_scene::named;

    fn state() -> State {
        let scene = named("stratocumulus").unwrap();
        let camera = Camera {
            position_m: [0.0, 0.0, 3000.0],
            azimuth_deg: 90.0,
            elevation_deg: 0.0,
            ..scene.camera.unwrap()
        };
        State::of(&scene, camera, Settings::default())
    }

    fn moved(motion: Motion, seconds: f64, fast: bool) -> [f64; 3] {
        let mut state = state();
        state.step(motion, seconds, fast);
        state.camera.position_m.map(f64::round)
    }

    #[test]
    fn the_camera_goes_where_it_looks() {
        assert_eq!(moved(Motion::Ahead, 1.0, false), [300.0, 0.0, 3000.0]);
        assert_eq!(moved(Motion::Back, 1.0, true), [-1500.0, 0.0, 3000.0]);
        assert_eq!(moved(Motion::Right, 1.0, false), [0.0, -300.0, 3000.0]);
        assert_eq!(moved(Motion::Left, 0.5, false), [0.0, 150.0, 3000.0]);
        assert_eq!(moved(Motion::Up, 1.0, false), [0.0, 0.0, 3300.0]);
        assert_eq!(moved(Motion::Down, 1.0, false), [0.0, 0.0, 2700.0]);
    }

    #[test]
    fn azimuths_go_round() {
        assert_eq!((turned(-90.0), turned(360.0), turned(725.0)), (270.0, 0.0, 5.0));
        assert!(turned(-1e-20) < 360.0);
        let mut state = state();
        state.sun_azimuth_deg = 5.0;
        state.step(Motion::SunLeft, 1.0, false);
        assert_eq!(state.sun_azimuth_deg, 350.0);
    }

    #[test]
    fn the_sun_stays_between_zenith_and_horizon() {
        let mut state = state();
        state.step(Motion::SunLower, 100.0, false);
        assert_eq!(state.sun_theta_deg, LOWEST_SUN);
        state.step(Motion::SunHigher, 100.0, false);
        assert_eq!(state.sun_theta_deg, 0.0);
    }

    #[test]
    fn a_drag_takes_the_picture_along() {
        let mut state = state();
        let height = f64::from(state.camera.height);
        state.look([height, height]);
        assert!((state.camera.azimuth_deg - (90.0 - state.camera.field_of_view_deg)).abs() < 1e-9);
        assert!((state.camera.elevation_deg - state.camera.field_of_view_deg).abs() < 1e-9);
        state.look([0.0, 1e6]);
        assert_eq!(state.camera.elevation_deg, STEEPEST);
    }

    #[test]
    fn keys_that_switch_switch_back() {
        let before = state();
        for action in
            [Action::RunOrPause, Action::OtherModel, Action::Contribution(0), Action::Contribution(6)]
        {
            let mut state = before;
            state.act(action);
            assert_ne!(state, before, "{action:?}");
            state.act(action);
            assert_eq!(state, before, "{action:?}");
        }
        let mut state = before;
        state.act(Action::Contribution(5));
        assert!(!state.settings.contributions.has(Contribution::Sky));
        assert!(state.settings.contributions.has(Contribution::Ground));
    }

    #[test]
    fn speed_and_exposure_end_somewhere() {
        let mut state = state();
        let many = |state: &mut State, action| (0..400).for_each(|_| state.act(action));
        many(&mut state, Action::Faster);
        many(&mut state, Action::Brighter);
        assert_eq!((state.rate, state.exposure_ev), (RATES[1], EXPOSURES[1]));
        many(&mut state, Action::Slower);
        many(&mut state, Action::Darker);
        assert_eq!((state.rate, state.exposure_ev), (RATES[0], EXPOSURES[0]));
    }
}
