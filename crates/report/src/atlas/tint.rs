//! How a class looks: a colour that stands apart for any eye, and a sign on those that matter.

use maud::{Markup, html};
use stratiform_artifact::AtlasRow;

/// Colours after Okabe & Ito 2008, in the order of [`AtlasRow::CLASSES`].
const COLOURS: [&str; 9] =
    ["#009E73", "#A9DCCB", "#E6E6E6", "#56B4E9", "#E69F00", "#CC79A7", "#D55E00", "#000000", "#F0E442"];

/// In words, in the same order.
pub const MEANINGS: [&str; 9] = [
    "promise kept",
    "sound, nothing promised",
    "refused",
    "f32 loses digits",
    "over the bound",
    "above one",
    "negative",
    "not finite",
    "answered outside its domain",
];

/// Place of a class among [`AtlasRow::CLASSES`].
pub fn place(class: &str) -> usize {
    AtlasRow::CLASSES.iter().position(|known| *known == class).unwrap_or(AtlasRow::CLASSES.len() - 1)
}

/// A rectangle of a class.
pub fn cell(place: usize, [x, y, width, height]: [f64; 4]) -> Markup {
    let signed = (3..COLOURS.len()).contains(&place);
    let size = 0.22 * width.min(height);
    let (cx, cy) = (x + 0.5 * width, y + 0.5 * height);
    let path = match place {
        3 => format!("M{:.1} {cy:.1}h{:.1}", cx - size, 2.0 * size),
        _ => format!(
            "M{:.1} {:.1}l{w:.1} {w:.1}m0 {:.1}l{:.1} {w:.1}",
            cx - size,
            cy - size,
            -2.0 * size,
            -2.0 * size,
            w = 2.0 * size
        ),
    };
    html! {
        rect x=(format!("{x:.1}")) y=(format!("{y:.1}")) width=(format!("{width:.1}"))
            height=(format!("{height:.1}")) fill=(COLOURS[place]) {}
        @if signed { path d=(path) stroke=(if place == 7 { "#fff" } else { "#000" }) stroke-width="0.9" fill="none" {} }
    }
}
