//! Keys held and mouse drawn.

use crate::keys::{Command, command};
use crate::state::{Action, Motion};
use std::collections::BTreeSet;
use winit::event::{ElementState, KeyEvent, MouseButton, WindowEvent};
use winit::keyboard::PhysicalKey;

/// What an event of the window asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wish {
    /// Begin to move.
    Move(Motion),
    /// Once.
    Do(Action),
    /// The mouse drew the picture so many pixels right and down.
    Look([f64; 2]),
    /// Close.
    Quit,
}

/// What is held just now.
#[derive(Debug, Default)]
pub struct Hands {
    held: BTreeSet<Motion>,
    fast: bool,
    drawing: bool,
    cursor: Option<[f64; 2]>,
}

impl Hands {
    /// Motions whose keys are held.
    pub fn held(&self) -> impl Iterator<Item = Motion> {
        self.held.iter().copied()
    }

    /// Whether no key is held.
    pub fn idle(&self) -> bool {
        self.held.is_empty()
    }

    /// Whether Shift is held.
    pub fn fast(&self) -> bool {
        self.fast
    }

    /// What the event asks for.
    pub fn feel(&mut self, event: &WindowEvent) -> Option<Wish> {
        match event {
            WindowEvent::CloseRequested => return Some(Wish::Quit),
            WindowEvent::Focused(false) => *self = Self::default(),
            WindowEvent::ModifiersChanged(modifiers) => self.fast = modifiers.state().shift_key(),
            WindowEvent::MouseInput { state, button: MouseButton::Left, .. } => {
                self.drawing = *state == ElementState::Pressed;
            }
            WindowEvent::CursorLeft { .. } => self.cursor = None,
            WindowEvent::CursorMoved { position, .. } => return self.cursor_at([position.x, position.y]),
            WindowEvent::KeyboardInput { event, .. } => return self.key(event),
            _ => (),
        }
        None
    }

    fn key(&mut self, event: &KeyEvent) -> Option<Wish> {
        let PhysicalKey::Code(code) = event.physical_key else { return None };
        self.press(command(code)?, event.state.is_pressed(), event.repeat)
    }

    fn press(&mut self, command: Command, pressed: bool, repeat: bool) -> Option<Wish> {
        match command {
            Command::Move(motion) if pressed => self.held.insert(motion).then_some(Wish::Move(motion)),
            Command::Move(motion) => {
                self.held.remove(&motion);
                None
            }
            Command::Do(action) => (pressed && !repeat).then_some(Wish::Do(action)),
            Command::Quit => pressed.then_some(Wish::Quit),
        }
    }

    fn cursor_at(&mut self, here: [f64; 2]) -> Option<Wish> {
        let before = self.cursor.replace(here)?;
        self.drawing.then(|| Wish::Look([here[0] - before[0], here[1] - before[1]]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_lasts_as_long_as_its_key() {
        let mut hands = Hands::default();
        let ahead = Command::Move(Motion::Ahead);
        assert_eq!(hands.press(ahead, true, false), Some(Wish::Move(Motion::Ahead)));
        assert_eq!(hands.press(ahead, true, true), None, "a key that repeats is held already");
        assert!(hands.held().eq([Motion::Ahead]));
        assert_eq!(hands.press(ahead, false, false), None);
        assert!(hands.idle());
    }

    #[test]
    fn an_action_happens_once() {
        let mut hands = Hands::default();
        let model = Command::Do(Action::OtherModel);
        assert_eq!(hands.press(model, true, false), Some(Wish::Do(Action::OtherModel)));
        assert_eq!(hands.press(model, true, true), None);
        assert_eq!(hands.press(model, false, false), None);
        assert_eq!(hands.press(Command::Quit, true, false), Some(Wish::Quit));
    }

    #[test]
    fn the_mouse_looks_while_its_button_is_down() {
        let mut hands = Hands::default();
        assert_eq!(hands.cursor_at([5.0, 5.0]), None);
        hands.drawing = true;
        assert_eq!(hands.cursor_at([7.0, 4.0]), Some(Wish::Look([2.0, -1.0])));
        assert_eq!(hands.feel(&WindowEvent::Focused(false)), None);
        assert_eq!(hands.cursor_at([9.0, 4.0]), None, "a window that lost the focus holds nothing");
    }
}
