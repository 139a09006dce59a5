//! Thickness from a picture of heights, north at its top.

use crate::{HeightField, Map, WorldError};
use std::path::Path;
use stratiform_imaging::read_grey;
use stratiform_quantities::Range;
use stratiform_scene::Clouds;

/// The field in the file at `path`, `scale_m` for its 1, drifted with the wind by linear interpolation.
pub fn field(clouds: &Clouds, path: &Path, scale_m: f64, moment_s: f64) -> Result<HeightField, WorldError> {
    let grey = read_grey(path)?;
    let side = square(path, grey.width(), grey.height())?;
    let mut values = Vec::with_capacity(side * side);
    for (i, _) in grey.values().iter().enumerate() {
        let (column, row) = (i % side, side - 1 - i / side);
        let thickness = scale_m * f64::from(grey.values()[row * side + column]);
        let name =
            || format!("{}: thickness_m in column {column} of row {row} from the top left", path.display());
        let domain = Range::closed(0.0, 1e5);
        values.push(if domain.contains(thickness) { thickness } else { domain.check(&name(), thickness)? });
    }
    let still = Map::new(side, clouds.extent_m, values)?;
    HeightField::new(drifted(still, clouds.wind_m_per_s.map(|wind| wind * moment_s))?)
}

/// The map moved by `drift` metres to the east and north.
fn drifted(map: Map<f64>, drift: [f64; 2]) -> Result<Map<f64>, WorldError> {
    if drift == [0.0, 0.0] {
        return Ok(map);
    }
    let (side, step) = (map.side(), map.extent_m() / map.side() as f64);
    let centre = |index: usize| (index as f64 + 0.5) * step;
    let value = |i: usize| map.value(centre(i % side) - drift[0], centre(i / side) - drift[1]);
    Map::new(side, map.extent_m(), (0..side * side).map(value).collect())
}

/// The side of a square picture.
pub fn square(path: &Path, width: usize, height: usize) -> Result<usize, WorldError> {
    if width == height {
        return Ok(width);
    }
    Err(WorldError::Contents(format!("{}: {width} x {height} pixels are not square", path.display())))
}
