//! Which key says what. Keys are told by their place, with the names that an American keyboard prints there.

use crate::state::{Action, Motion};
use winit::keyboard::KeyCode;

/// The keys in one line.
pub const HELP: &str = "keys: W A S D move, Q E down and up (Shift: faster), drag to look, arrows or I J K L sun, Space time, [ ] its speed, \
                        + - exposure, M model, 1 to 7 contributions, Escape quits";

/// What a key says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// As long as it is held.
    Move(Motion),
    /// Once.
    Do(Action),
    /// Close the window.
    Quit,
}

/// What this key says.
pub fn command(key: KeyCode) -> Option<Command> {
    motion(key).map(Command::Move).or_else(|| action(key).map(Command::Do)).or(match key {
        KeyCode::Escape => Some(Command::Quit),
        _ => None,
    })
}

fn motion(key: KeyCode) -> Option<Motion> {
    Some(match key {
        KeyCode::KeyW => Motion::Ahead,
        KeyCode::KeyS => Motion::Back,
        KeyCode::KeyA => Motion::Left,
        KeyCode::KeyD => Motion::Right,
        KeyCode::KeyE => Motion::Up,
        KeyCode::KeyQ => Motion::Down,
        KeyCode::ArrowUp | KeyCode::KeyI => Motion::SunHigher,
        KeyCode::ArrowDown | KeyCode::KeyK => Motion::SunLower,
        KeyCode::ArrowLeft | KeyCode::KeyJ => Motion::SunLeft,
        KeyCode::ArrowRight | KeyCode::KeyL => Motion::SunRight,
        _ => return None,
    })
}

fn action(key: KeyCode) -> Option<Action> {
    Some(match key {
        KeyCode::Space => Action::RunOrPause,
        KeyCode::BracketLeft => Action::Slower,
        KeyCode::BracketRight => Action::Faster,
        KeyCode::Equal | KeyCode::NumpadAdd => Action::Brighter,
        KeyCode::Minus | KeyCode::NumpadSubtract => Action::Darker,
        KeyCode::KeyM => Action::OtherModel,
        KeyCode::Digit1 => Action::Contribution(0),
        KeyCode::Digit2 => Action::Contribution(1),
        KeyCode::Digit3 => Action::Contribution(2),
        KeyCode::Digit4 => Action::Contribution(3),
        KeyCode::Digit5 => Action::Contribution(4),
        KeyCode::Digit6 => Action::Contribution(5),
        KeyCode::Digit7 => Action::Contribution(6),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_say_what_the_help_says() {
        assert_eq!(command(KeyCode::KeyW), Some(Command::Move(Motion::Ahead)));
        assert_eq!(command(KeyCode::ArrowLeft), command(KeyCode::KeyJ));
        assert_eq!(command(KeyCode::Digit7), Some(Command::Do(Action::Contribution(6))));
        assert_eq!(command(KeyCode::Escape), Some(Command::Quit));
        assert_eq!(command(KeyCode::F1), None);
    }
}
