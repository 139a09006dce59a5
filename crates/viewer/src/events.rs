//! The connection to the display.

use crate::ViewerError;
use std::any::Any;
use std::panic;
use winit::event_loop::EventLoop;

/// Opens it. winit panics where a library or an extension of the display is missing: here that is an error like any other.
///
/// # Errors
/// [`ViewerError::NoDisplay`].
pub fn open() -> Result<EventLoop<()>, ViewerError> {
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| ()));
    let made = panic::catch_unwind(EventLoop::new);
    panic::set_hook(hook);
    let reason = match made {
        Ok(Ok(events)) => return Ok(events),
        Ok(Err(error)) => without_place(&error.to_string()).to_owned(),
        Err(said) => text(said.as_ref()),
    };
    Err(ViewerError::NoDisplay { reason })
}

/// What a panic said.
fn text(said: &(dyn Any + Send)) -> String {
    let text = said.downcast_ref::<String>().map(String::as_str).or(said.downcast_ref::<&str>().copied());
    text.unwrap_or("unknown").to_owned()
}

/// The message without the line of winit that it comes from.
fn without_place(message: &str) -> &str {
    let place = message.rsplit_once(".rs:").and_then(|(_, rest)| rest.split_once(": "));
    place.map_or(message, |(_, reason)| reason)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_do_not_tell_where_they_were_compiled() {
        assert_eq!(
            without_place("os error at /a/src/mod.rs:765: DISPLAY is not set."),
            "DISPLAY is not set."
        );
        assert_eq!(without_place("not supported"), "not supported");
    }

    #[test]
    fn panics_are_read() {
        assert_eq!(text(&"plain"), "plain");
        assert_eq!(text(&"formatted".to_owned()), "formatted");
        assert_eq!(text(&7), "unknown");
    }
}
