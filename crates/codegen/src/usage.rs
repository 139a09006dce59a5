#![doc = include_str!("usage.md")]
