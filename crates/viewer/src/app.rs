//! The window's events, and the loop that draws.

use crate::hands::{Hands, Wish};
use crate::scenery::Scenery;
use crate::stage::Stage;
use crate::title::title;
use crate::{ViewerError, events};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};
use stratiform_render::Settings;
use stratiform_scene::Scene;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::{StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow};
use winit::window::{Window, WindowId};

/// What is to be shown.
#[derive(Debug)]
pub struct Subject {
    /// Its name, for the title.
    pub name: String,
    /// The scene; its camera says the window's size.
    pub scene: Scene,
    /// The folder from which the scene names its files.
    pub folder: PathBuf,
    /// How it is drawn at first.
    pub settings: Settings,
    /// Close after so many pictures.
    pub frames: Option<u64>,
}

/// What was shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// Pictures.
    pub frames: u64,
    /// The device.
    pub adapter: String,
}

/// Opens a window and shows the subject until it is closed. Needs the main thread.
///
/// # Errors
/// [`ViewerError`] if there is no display, for a scene that cannot be drawn, and for a device that fails.
pub fn view(subject: Subject) -> Result<Seen, ViewerError> {
    let events = events::open()?;
    let scenery = Scenery::new(subject.scene, subject.folder, subject.settings)?;
    let mut app = App {
        name: subject.name,
        last_frame: subject.frames,
        scenery,
        hands: Hands::default(),
        window: None,
        stage: None,
        visible: true,
        shown: true,
        drawn: Instant::now(),
        note: String::new(),
        seen: Seen { frames: 0, adapter: String::new() },
        reopened: false,
        failure: None,
    };
    let ended = events.run_app(&mut app);
    app.failure.map_or(Ok(()), Err)?;
    ended.map_err(|error| ViewerError::Window { reason: error.to_string() })?;
    Ok(app.seen)
}

/// A key that is only touched moves as if held so long, s.
const TOUCH: f64 = 0.05;
/// A picture that took longer moves no further, s.
const LONGEST: f64 = 0.25;
/// How long a window that shows nothing is left alone.
const REST: Duration = Duration::from_millis(100);

struct App {
    name: String,
    last_frame: Option<u64>,
    scenery: Scenery,
    hands: Hands,
    window: Option<Arc<Window>>,
    stage: Option<Stage>,
    visible: bool,
    shown: bool,
    drawn: Instant,
    note: String,
    seen: Seen,
    reopened: bool,
    failure: Option<ViewerError>,
}

impl App {
    fn open(&mut self, events: &ActiveEventLoop) -> Result<(), ViewerError> {
        let camera = &self.scenery.state().camera;
        let attributes = Window::default_attributes()
            .with_title(&self.name)
            .with_inner_size(PhysicalSize::new(camera.width, camera.height));
        let window = events
            .create_window(attributes)
            .map_err(|error| ViewerError::Window { reason: error.to_string() })?;
        self.resize(window.inner_size());
        self.window = Some(Arc::new(window));
        self.set_stage()
    }

    fn set_stage(&mut self) -> Result<(), ViewerError> {
        let Some(window) = &self.window else { return Ok(()) };
        let stage = Stage::open(Arc::clone(window), &self.scenery)?;
        stage.adapter().clone_into(&mut self.seen.adapter);
        self.stage = Some(stage);
        window.request_redraw();
        Ok(())
    }

    /// A window without area keeps the former picture, unseen.
    fn resize(&mut self, PhysicalSize { width, height }: PhysicalSize<u32>) {
        self.visible = width > 0 && height > 0;
        if self.visible {
            self.scenery.resize([width, height]);
        }
    }

    /// The next picture; device and surface that are lost are opened anew, once.
    fn frame(&mut self) -> Result<(), ViewerError> {
        self.pass_time();
        let Some(stage) = self.stage.as_mut().filter(|_| self.visible) else { return Ok(()) };
        match stage.show(&self.scenery) {
            Ok(shown) => {
                self.seen.frames += u64::from(shown);
                self.shown = shown;
                self.reopened &= !shown;
            }
            Err(error) if error.is_loss() && !self.reopened => {
                self.reopened = true;
                // The surface must be gone before the window gets another.
                self.stage = None;
                self.note = error.to_string();
                self.set_stage()?;
            }
            Err(error) => return Err(error),
        }
        if let Some(window) = &self.window {
            window.set_title(&title(&self.name, self.scenery.state(), &self.note));
        }
        Ok(())
    }

    /// What keys and clock did since the last picture.
    fn pass_time(&mut self) {
        let seconds = self.drawn.elapsed().as_secs_f64().min(LONGEST);
        self.drawn = Instant::now();
        if !self.hands.idle() {
            let moved = self.scenery.step(self.hands.held(), seconds, self.hands.fast());
            self.tell(moved);
        }
        if self.scenery.state().running {
            let moved = self.scenery.run(seconds);
            self.tell(moved);
        }
    }

    /// The title says why something did not move.
    fn tell(&mut self, moved: Result<(), stratiform_world::WorldError>) {
        self.note = moved.map_or_else(|error| error.to_string(), |()| String::new());
    }

    fn grant(&mut self, wish: Wish, events: &ActiveEventLoop) {
        match wish {
            Wish::Quit => events.exit(),
            Wish::Do(action) => self.scenery.act(action),
            Wish::Look(way) => self.scenery.look(way),
            Wish::Move(motion) => {
                self.drawn = Instant::now();
                let moved = self.scenery.step([motion], TOUCH, self.hands.fast());
                self.tell(moved);
            }
        }
        if let Some(window) = &self.window {
            window.request_redraw();
        }
    }

    fn done(&self) -> bool {
        self.last_frame.is_some_and(|last| self.seen.frames >= last)
    }

    /// Whether the next picture differs from the last, or is asked for.
    fn goes_on(&self) -> bool {
        self.visible && (self.scenery.state().running || !self.hands.idle() || self.last_frame.is_some())
    }

    fn end(&mut self, result: Result<(), ViewerError>, events: &ActiveEventLoop) {
        if let Err(error) = result {
            self.failure = Some(error);
            events.exit();
        }
    }
}

impl ApplicationHandler for App {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.window.is_none() {
            let opened = self.open(events);
            self.end(opened, events);
        }
    }

    fn new_events(&mut self, _: &ActiveEventLoop, cause: StartCause) {
        if let (StartCause::ResumeTimeReached { .. }, Some(window)) = (cause, &self.window) {
            window.request_redraw();
        }
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let result = match &event {
            WindowEvent::RedrawRequested => self.frame(),
            _ => Ok(()),
        };
        if let WindowEvent::Resized(size) = &event {
            self.resize(*size);
        }
        self.end(result, events);
        if let Some(wish) = self.hands.feel(&event) {
            self.grant(wish, events);
        }
        if self.done() {
            events.exit();
        }
    }

    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        events.set_control_flow(ControlFlow::Wait);
        let Some(window) = self.window.as_ref().filter(|_| self.goes_on()) else { return };
        if self.shown {
            window.request_redraw();
        } else {
            events.set_control_flow(ControlFlow::WaitUntil(Instant::now() + REST));
        }
    }
}
