//! Writes a scene's thickness map: `heights SCENE FILE`. FILE gets side² little-endian f32, metres, row by row from the south-west.

use std::error::Error;
use std::fs;
use std::path::Path;
use stratiform_scene::find;
use stratiform_world::World;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(scene), Some(file)) = (arguments.next(), arguments.next()) else {
        return Err("usage: heights SCENE FILE".into());
    };
    let (_, read) = find(&scene)?;
    let folder = Path::new(&scene).parent().unwrap_or(Path::new("."));
    let world = World::build(&read, folder, 0.0)?;
    #[allow(clippy::cast_possible_truncation, reason = "a picture needs no more digits")]
    let bytes: Vec<u8> = world.field.map().values().iter().flat_map(|h| (*h as f32).to_le_bytes()).collect();
    fs::write(file, bytes)?;
    Ok(())
}
