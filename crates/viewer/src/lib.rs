//! A window on the renderer, with sun, camera and time under keys and mouse.
//!
//! | file | what |
//! | --- | --- |
//! | `keys` | which key says what |
//! | `state` | what can be changed while one looks, and what each key changes |
//! | `scenery` | the scene as it stands: keeps the world with the state, refuses what the world refuses |
//! | `stage` | window, device, renderer: shows the scenery |
//! | `hands` | keys held, mouse drawn |
//! | `events` | the connection to the display |
//! | `app` | the window, and the loop that draws |
//!
//! The picture goes from the renderer's buffer to the window without leaving the device, through `tone.wgsl`, which is
//! `stratiform_imaging::Tone`. A pixel that is no number is magenta; the first picture is checked as the renderer's own are.

mod app;
mod error;
mod events;
mod hands;
mod keys;
mod scenery;
mod stage;
mod state;
mod title;

pub use app::{Seen, Subject, view};
pub use error::ViewerError;
pub use keys::HELP;
pub use stage::TONE;
