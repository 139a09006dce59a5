//! The ground of a scene as a map.

use crate::field::hash::seed;
use crate::field::noise::{Cells, Octaves};
use crate::field::{square, whole};
use crate::{Ground, Map, WorldError};
use std::path::Path;
use stratiform_imaging::{read_exr, read_png};
use stratiform_quantities::Range;
use stratiform_scene as said;
use stratiform_scene::GroundPattern;

/// Texels a side of a pattern that does not say.
const SIDE: u32 = 256;
/// Bays, floes and squares to the period where nobody says.
const MANY: f64 = 8.0;

/// The ground that `ground` says, over `extent_m` unless it has its own; its image is named from `folder`.
pub fn ground(ground: &said::Ground, extent_m: f64, folder: &Path) -> Result<Ground, WorldError> {
    let extent_m = ground.extent_m.unwrap_or(extent_m);
    let albedo = match (ground.kinds(), ground.pattern, &ground.image) {
        (Some(kinds), Some(kind), _) => pattern(ground, kind, kinds.map(|albedo| albedo.rgb()), extent_m)?,
        (Some([albedo, _]), None, _) => Map::new(1, extent_m, vec![albedo.rgb()])?,
        (None, _, Some(image)) => from_image(&folder.join(image), extent_m)?,
        (None, _, None) => {
            return Err(WorldError::Contents("ground needs one of albedo, pattern and image".to_owned()));
        }
    };
    Ok(Ground { albedo })
}

/// Texels of one kind or the other.
fn pattern(
    ground: &said::Ground,
    kind: GroundPattern,
    [one, other]: [[f64; 3]; 2],
    extent_m: f64,
) -> Result<Map<[f64; 3]>, WorldError> {
    let side = ground.side.unwrap_or(SIDE) as usize;
    let many = whole(ground.cell_m.map_or(MANY, |cell| extent_m / cell));
    let seed = seed(ground.seed.unwrap_or(2006), 7);
    let values = values(kind, side, many, seed);
    let middle = median(&values);
    let texels = values.iter().map(|value| if *value < middle { one } else { other }).collect();
    Map::new(side, extent_m, texels)
}

/// A number for each texel; the lower half of them is the first kind.
fn values(kind: GroundPattern, side: usize, many: usize, seed: u64) -> Vec<f64> {
    let shore = Octaves::new((many / 4).max(1), 7, side, seed, 0.0);
    let floes = Cells::new(many, seed, 0.0);
    let value = |i: usize| {
        let (u, v) = ((i % side) as f64 + 0.5, (i / side) as f64 + 0.5);
        let (u, v) = (u / side as f64, v / side as f64);
        match kind {
            GroundPattern::WaterIce => u,
            GroundPattern::Coast => shore.value(u, v),
            GroundPattern::Floes => 0.2 * shore.value(u, v) - floes.value(u, v),
            GroundPattern::Checker => parity(u, v, many),
        }
    };
    (0..side * side).map(value).collect()
}

/// 0 or 1 by turns.
fn parity(u: f64, v: f64, many: usize) -> f64 {
    let steps = libm::floor(u * many as f64) + libm::floor(v * many as f64);
    steps - 2.0 * libm::floor(0.5 * steps)
}

/// The value that half of them lie below.
fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

/// Linear sRGB of a PNG or EXR, north at its top.
fn from_image(path: &Path, extent_m: f64) -> Result<Map<[f64; 3]>, WorldError> {
    let exr = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("exr"));
    let image = if exr { read_exr(path)?.image } else { read_png(path)? };
    let side = square(path, image.width(), image.height())?;
    let mut texels = Vec::with_capacity(side * side);
    for i in 0..side * side {
        let (column, row) = (i % side, side - 1 - i / side);
        let albedo = image.at(column, row).map(f64::from);
        for share in albedo {
            let name =
                || format!("{}: albedo in column {column} of row {row} from the top left", path.display());
            let domain = Range::closed(0.0, 1.0);
            if !domain.contains(share) {
                domain.check(&name(), share)?;
            }
        }
        texels.push(albedo);
    }
    Map::new(side, extent_m, texels)
}
