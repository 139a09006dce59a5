//! The ground of a scene as a map.

use crate::{Ground, Map, WorldError};
use std::path::Path;
use stratiform_scene as said;

/// The ground that `ground` says, over `extent_m` unless it has its own; its image is named from `folder`.
pub fn ground(ground: &said::Ground, extent_m: f64, folder: &Path) -> Result<Ground, WorldError> {
    let extent_m = ground.extent_m.unwrap_or(extent_m);
    let _ = folder;
    match ground.albedo {
        Some(albedo) => Ok(Ground { albedo: Map::new(1, extent_m, vec![albedo.rgb()])? }),
        None => Err(WorldError::Contents("ground patterns are not made yet".to_owned())),
    }
}
