//! One coordinate system: frame, grid, ticks, labels, and the data clipped to it.

use super::label;
use super::names::names;
use super::series::Area;
use super::{Scale, Series, polar};
use maud::{Markup, html};

/// Font size of labels, in units.
pub const TEXT: f64 = 13.0;
/// Font size of tick labels, in units.
pub const SMALL: f64 = 12.0;

const LEFT: f64 = 68.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 10.0;
const TOP_WITH_TITLE: f64 = 24.0;
const BOTTOM: f64 = 44.0;

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Quantity and unit, in the markup of [`super::label`].
    pub label: String,
    /// Scale.
    pub scale: Scale,
}

impl Axis {
    /// An axis with its label.
    pub fn new(label: &str, scale: Scale) -> Self {
        Self { label: label.to_owned(), scale }
    }
}

/// A named vertical line, or a name beside a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Where.
    pub x: f64,
    /// Height of the point; none for a line.
    pub y: Option<f64>,
    /// Its name; of a line, written at the upper end, right of it.
    pub label: String,
}

/// One coordinate system.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Heading above the frame; may be empty.
    pub title: String,
    /// Abscissa.
    pub x: Axis,
    /// Ordinate.
    pub y: Axis,
    /// Data, the last drawn on top.
    pub series: Vec<Series>,
    /// Reference lines and names of points.
    pub marks: Vec<Mark>,
}

impl Panel {
    /// The panel as SVG elements in a cell of the given place and size.
    pub fn draw(&self, x: f64, y: f64, width: f64, height: f64) -> Markup {
        let top = if self.title.is_empty() { TOP } else { TOP_WITH_TITLE };
        let (width, height) = (width - LEFT - RIGHT, height - top - BOTTOM);
        let area = Area { x: self.x.scale, y: self.y.scale, width, height };
        if self.x.scale.is_round() {
            return polar::draw(self, &area, x + LEFT, y + top);
        }
        html! {
            g transform=(format!("translate({:.2} {:.2})", x + LEFT, y + top)) {
                (self.ticks(&area))
                svg width=(format!("{width:.2}")) height=(format!("{height:.2}")) {
                    @for series in &self.series { (series.draw(&area)) }
                    @for mark in self.marks.iter().filter(|mark| mark.y.is_none()) { (draw_line(mark, &area)) }
                    @for name in names(&self.marks, &area) { (name.draw()) }
                }
                rect width=(format!("{width:.2}")) height=(format!("{height:.2}")) fill="none" stroke="#333" {}
                (self.labels(&area))
            }
        }
    }

    fn ticks(&self, area: &Area) -> Markup {
        let (w, h) = (area.width, area.height);
        // One label needs about 60 units along x and 44 along y.
        let across = area.x.ticks((w / 60.0) as usize);
        let up = area.y.ticks((h / 44.0) as usize);
        html! {
            @for tick in &across {
                @if let Some(x) = area.x.position(tick.value).map(|p| p * w) {
                    (tick_line(x, h, x, h - if tick.label.is_some() { 6.0 } else { 3.0 }))
                    @if let Some(text) = &tick.label {
                        (grid_line(x, 0.0, x, h))
                        text x=(format!("{x:.2}")) y=(format!("{:.2}", h + 16.0)) font-size=(SMALL)
                            text-anchor="middle" { (label::svg(text, SMALL)) }
                    }
                }
            }
            @for tick in &up {
                @if let Some(y) = area.y.position(tick.value).map(|p| (1.0 - p) * h) {
                    (tick_line(0.0, y, if tick.label.is_some() { 6.0 } else { 3.0 }, y))
                    @if let Some(text) = &tick.label {
                        (grid_line(0.0, y, w, y))
                        text x="-6" y=(format!("{:.2}", y + 4.0)) font-size=(SMALL)
                            text-anchor="end" { (label::svg(text, SMALL)) }
                    }
                }
            }
        }
    }

    fn labels(&self, area: &Area) -> Markup {
        let (w, h) = (area.width, area.height);
        let turned = format!("translate({:.2} {:.2}) rotate(-90)", 13.0 - LEFT, h / 2.0);
        html! {
            @if !self.title.is_empty() {
                text x="0" y="-8" font-size=(TEXT) font-weight="bold" { (label::svg(&self.title, TEXT)) }
            }
            text class="axis" x=(format!("{:.2}", w / 2.0)) y=(format!("{:.2}", h + 36.0)) font-size=(TEXT)
                text-anchor="middle" { (label::svg(&self.x.label, TEXT)) }
            text class="axis" transform=(turned) font-size=(TEXT)
                text-anchor="middle" { (label::svg(&self.y.label, TEXT)) }
        }
    }
}

fn line(x1: f64, y1: f64, x2: f64, y2: f64, colour: &str) -> Markup {
    html! { path d=(format!("M{x1:.2} {y1:.2}L{x2:.2} {y2:.2}")) stroke=(colour) {} }
}

fn tick_line(x1: f64, y1: f64, x2: f64, y2: f64) -> Markup {
    line(x1, y1, x2, y2, "#333")
}

fn grid_line(x1: f64, y1: f64, x2: f64, y2: f64) -> Markup {
    line(x1, y1, x2, y2, "#e4e4e4")
}

/// Where the name of a line stands: on whichever side of `x` has room.
fn beside(mark: &Mark, x: f64, area: &Area) -> (f64, &'static str) {
    let fits = x + label::width(&mark.label, SMALL) + 8.0 < area.width;
    if fits { (x + 5.0, "start") } else { (x - 5.0, "end") }
}

fn draw_line(mark: &Mark, area: &Area) -> Markup {
    let Some(x) = area.x.position(mark.x).map(|p| p * area.width) else { return html! {} };
    let (at, anchor) = beside(mark, x, area);
    html! {
        path d=(format!("M{x:.2} 0V{:.2}", area.height)) stroke="#666" stroke-dasharray="2 3" {}
        text x=(format!("{at:.2}")) y="14" font-size=(SMALL) fill="#444" text-anchor=(anchor) {
            (label::svg(&mark.label, SMALL))
        }
    }
}
