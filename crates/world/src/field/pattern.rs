//! Thickness of a procedural layer.
//!
//! A pattern is a smooth function of place and time without unit; the share 1 - `cover` of its lowest values is clear sky, the highest half
//! per cent is as thick as the layer gets, and a cubic leads from one to the other. Both limits are found once, at the moment 0 over a
//! coarse lattice, so that a pattern that only drifts keeps its shape. With a wind w the pattern at (x, y) is that at (x, y) - w t of the still air.

use super::hash::seed;
use super::noise::{Cells, Octaves};
use crate::{HeightField, Map, WorldError};
use rayon::prelude::*;
use std::f64::consts::TAU;
use stratiform_scene::{Clouds, Pattern, PatternKeys};

/// Points a side of the lattice that limits are found on.
const LATTICE: usize = 192;
/// Share of the plane that is as thick as the layer gets.
const TOPS: f64 = 0.005;
/// Buds across a cell.
const BUDS: usize = 3;

/// The field of `clouds` at a moment.
pub fn field(clouds: &Clouds, keys: &PatternKeys, moment_s: f64) -> Result<HeightField, WorldError> {
    if keys.pattern == Pattern::Flat {
        let side = clouds.side.unwrap_or(1) as usize;
        return HeightField::new(Map::new(side, clouds.extent_m, vec![keys.thickness_m.max; side * side])?);
    }
    let turn = clouds.evolution_s.map_or(0.0, |period| moment_s / period);
    let [low, high] = limits(&Shape::new(clouds, keys, 0.0), keys.cover);
    let shape = Shape::new(clouds, keys, turn - libm::floor(turn));
    let drift = clouds.wind_m_per_s.map(|wind| wind * moment_s / clouds.extent_m);
    let side = keys.side as usize;
    let thickness = |i: usize| {
        let place = |index: usize, drift: f64| (index as f64 + 0.5) / side as f64 - drift;
        let value = shape.value(place(i % side, drift[0]), place(i / side, drift[1]));
        let share = ((value - low) / (high - low)).clamp(0.0, 1.0);
        keys.thickness_m.min
            + (keys.thickness_m.max - keys.thickness_m.min) * share * share * (3.0 - 2.0 * share)
    };
    let values = (0..side * side).into_par_iter().map(thickness).collect();
    HeightField::new(Map::new(side, clouds.extent_m, values)?)
}

/// The values that become nothing and the greatest thickness.
fn limits(shape: &Shape, cover: f64) -> [f64; 2] {
    let place = |index: usize| (index as f64 + 0.5) / LATTICE as f64;
    let mut values: Vec<f64> = (0..LATTICE * LATTICE)
        .into_par_iter()
        .map(|i| shape.value(place(i % LATTICE), place(i / LATTICE)))
        .collect();
    values.sort_by(f64::total_cmp);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of the length")]
    let at = |share: f64| values[((share * values.len() as f64) as usize).min(values.len() - 1)];
    [at(1.0 - cover), at(1.0 - TOPS)]
}

/// A pattern at one moment, in still air.
enum Shape {
    Stratocumulus { cells: Cells, buds: Cells, bend: [Octaves; 2], rough: Octaves, bend_by: f64 },
    Ripples { waves: [f64; 2], bend: Octaves, rough: Octaves },
}

impl Shape {
    fn new(clouds: &Clouds, keys: &PatternKeys, turn: f64) -> Self {
        let side = keys.side as usize;
        let many = whole(clouds.extent_m / keys.cell_m);
        let octaves = |cells: usize, count: u32, stream: u32| {
            Octaves::new(cells, count, side, seed(keys.seed, stream), turn)
        };
        match keys.pattern {
            Pattern::Ripples => Self::Ripples {
                waves: waves(many, clouds.wind_m_per_s),
                bend: octaves((many / 4).max(1), 3, 1),
                rough: octaves((many / 3).max(1), keys.octaves, 2),
            },
            _ => Self::Stratocumulus {
                cells: Cells::new(many, seed(keys.seed, 0), turn),
                buds: Cells::new(BUDS * many, seed(keys.seed, 4), turn),
                bend: [octaves(many, 2, 1), octaves(many, 2, 2)],
                rough: octaves((many / 2).max(1), keys.octaves, 3),
                bend_by: 0.3 / many as f64,
            },
        }
    }

    fn value(&self, u: f64, v: f64) -> f64 {
        match self {
            Self::Stratocumulus { cells, buds, bend: [east, north], rough, bend_by } => {
                let (du, dv) = (bend_by * east.value(u, v), bend_by * north.value(u, v));
                0.5 * rough.value(u, v) - cells.value(u + du, v + dv) - 0.3 * buds.value(u + du, v + dv)
            }
            Self::Ripples { waves, bend, rough } => {
                let phase = waves[0] * u + waves[1] * v + 0.8 * bend.value(u, v);
                0.35 * libm::cos(TAU * phase) + 0.6 * rough.value(u, v)
            }
        }
    }
}

/// Whole waves across the period each way, `many` along the wind; towards the north where there is none.
fn waves(many: usize, [east, north]: [f64; 2]) -> [f64; 2] {
    let speed = libm::hypot(east, north);
    let [along_x, along_y] = if speed > 0.0 { [east / speed, north / speed] } else { [0.0, 1.0] };
    [libm::round(many as f64 * along_x), libm::round(many as f64 * along_y)]
}

/// The nearest whole number of cells, at least one.
pub fn whole(cells: f64) -> usize {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 or more")]
    (libm::round(cells).max(1.0) as usize)
}
