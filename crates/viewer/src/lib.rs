//! A window on the renderer, with sun, camera and time under keys and mouse.
