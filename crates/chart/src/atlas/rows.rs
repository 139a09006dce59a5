//! Cells as rows of `atlas.csv`, their counts, and what the atlas was made of.

use super::class::{Class, F32_SHARE};
use super::plane::{Density, Plane};
use super::sweep::{Cell, Precision};
use super::truth::SHARE;
use stratiform_artifact::{
    AtlasCount, AtlasDocument, AtlasMethod, AtlasPlane, AtlasRow, Provenance, hash_of,
};
use stratiform_methods::{Card, Promise};

/// Rows of `atlas.csv`.
pub fn rows(card: &Card, plane: Plane, cells: &[Cell]) -> Vec<AtlasRow> {
    let row = |cell: &Cell| AtlasRow {
        method: card.name.clone(),
        plane: plane.name(),
        x_name: plane.x.name().to_owned(),
        x: cell.place.x,
        y_name: plane.y.name().to_owned(),
        y: cell.place.y,
        precision: cell.precision.name().to_owned(),
        quantity: cell.quantity.name().to_owned(),
        class: cell.class.name().to_owned(),
        value: cell.value.filter(|value| value.is_finite()),
        truth: cell.truth,
        error: cell.error(),
    };
    cells.iter().map(row).collect()
}

/// Counts of a method in each precision that it has.
pub fn count(card: &Card, cells: &[Cell]) -> Vec<AtlasCount> {
    [Precision::F64, Precision::F32]
        .into_iter()
        .filter_map(|precision| counted(card, precision, cells))
        .collect()
}

fn counted(card: &Card, precision: Precision, cells: &[Cell]) -> Option<AtlasCount> {
    let cells: Vec<&Cell> = cells.iter().filter(|cell| cell.precision == precision).collect();
    let of = |class| cells.iter().filter(|cell| cell.class == class).count() as u64;
    let errors = cells.iter().filter_map(|cell| cell.error()).map(f64::abs);
    (!cells.is_empty()).then(|| AtlasCount {
        method: card.name.clone(),
        precision: precision.name().to_owned(),
        cells: cells.len() as u64,
        ok: of(Class::Ok),
        no_promise: of(Class::NoPromise),
        refused: of(Class::Refused),
        loses_digits: of(Class::LosesDigits),
        over_bound: of(Class::OverBound),
        above_one: of(Class::AboveOne),
        negative: of(Class::Negative),
        not_finite: of(Class::NotFinite),
        not_refused: of(Class::NotRefused),
        worst_error: errors.reduce(f64::max),
    })
}

const METHOD: &str = "planes through a base point; truth by discrete ordinates on the full medium";

/// What an atlas was made of.
pub fn document(cards: &[&Card], density: Density) -> AtlasDocument {
    let planes: Vec<AtlasPlane> = Plane::ALL.iter().map(described).collect();
    let methods: Vec<AtlasMethod> = cards.iter().map(|card| method(card)).collect();
    let quick = density == Density::Thin;
    AtlasDocument {
        schema: AtlasDocument::SCHEMA.to_owned(),
        provenance: Provenance::new(hash_of(&("stratiform/atlas", quick, &planes, &methods)), None, METHOD),
        quick,
        largest_f32_share: F32_SHARE,
        largest_truth_error: SHARE,
        planes,
        methods,
    }
}

fn described(plane: &Plane) -> AtlasPlane {
    AtlasPlane {
        name: plane.name(),
        x_name: plane.x.name().to_owned(),
        y_name: plane.y.name().to_owned(),
        held: plane.held(),
    }
}

fn method(card: &Card) -> AtlasMethod {
    AtlasMethod {
        name: card.name.clone(),
        title: card.title.to_owned(),
        radiance: card.promises.radiance.as_ref().map(Promise::to_string),
        flux: card.promises.flux.as_ref().map(Promise::to_string),
    }
}
