//! A figure: title, one legend for all panels, rows of panels.

use super::panel::{Panel, TEXT};
use super::series::{OPACITY, marker};
use super::{Line, Marker, Style, label};
use maud::{Markup, html};

/// Width of every figure in units.
const WIDTH: f64 = 720.0;
const LEGEND_ROW: f64 = 21.0;
/// Length of the sample before a legend's text, and the space after it.
const SAMPLE: f64 = 34.0;
const GAP: f64 = 18.0;

/// A line of the legend.
#[derive(Clone, Debug, PartialEq)]
pub struct LegendEntry {
    /// What it is, in the markup of [`super::label`].
    pub label: String,
    /// How it is drawn.
    pub style: Style,
}

impl LegendEntry {
    /// An entry.
    pub fn new(label: impl Into<String>, style: Style) -> Self {
        Self { label: label.into(), style }
    }
}

/// Panels side by side, of equal width.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Height in units, labels included.
    pub height: f64,
    /// Left to right.
    pub panels: Vec<Panel>,
}

/// A figure with everything needed to draw and to explain it.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// File name without `.svg`.
    pub name: String,
    /// Heading.
    pub title: String,
    /// What the reader sees, in the markup of [`super::label`].
    pub caption: String,
    /// Legend.
    pub legend: Vec<LegendEntry>,
    /// Top to bottom.
    pub rows: Vec<Row>,
}

impl Figure {
    /// The `svg` element.
    pub fn draw(&self) -> Markup {
        let (places, legend_height) = self.legend_places();
        let top = 30.0 + legend_height;
        let height = self.rows.iter().fold(top, |sum, row| sum + row.height);
        html! {
            svg xmlns="http://www.w3.org/2000/svg" width=(WIDTH) height=(height) role="img"
                viewBox=(format!("0 0 {WIDTH} {height}")) aria-label=(label::plain(&self.title))
                font-family="Helvetica, Arial, 'DejaVu Sans', sans-serif" font-size=(TEXT) fill="#111" {
                title { (label::plain(&self.title)) }
                rect width=(WIDTH) height=(height) fill="#fff" {}
                text x="8" y="19" font-size="15" font-weight="bold" { (label::svg(&self.title, 15.0)) }
                @for (entry, (x, y)) in self.legend.iter().zip(places) { (draw_entry(entry, x, y)) }
                (self.draw_rows(top))
            }
        }
    }

    fn draw_rows(&self, top: f64) -> Markup {
        let tops = self.rows.iter().scan(top, |y, row| {
            *y += row.height;
            Some(*y - row.height)
        });
        html! {
            @for (row, y) in self.rows.iter().zip(tops) {
                @let width = WIDTH / row.panels.len().max(1) as f64;
                @for (i, panel) in row.panels.iter().enumerate() {
                    (panel.draw(i as f64 * width, y, width, row.height))
                }
            }
        }
    }

    /// Where each entry stands, wrapped into lines, and the height they take.
    fn legend_places(&self) -> (Vec<(f64, f64)>, f64) {
        let (mut x, mut y) = (10.0, 40.0);
        let mut places = Vec::new();
        for entry in &self.legend {
            let width = SAMPLE + label::width(&entry.label, TEXT) + GAP;
            if x + width - GAP > WIDTH && x > 10.0 {
                (x, y) = (10.0, y + LEGEND_ROW);
            }
            places.push((x, y));
            x += width;
        }
        let height = if self.legend.is_empty() { 0.0 } else { y - 40.0 + LEGEND_ROW + 4.0 };
        (places, height)
    }

    /// The figure as a file of its own.
    pub fn to_svg(&self) -> String {
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n", self.draw().into_string())
    }
}

fn draw_entry(entry: &LegendEntry, x: f64, y: f64) -> Markup {
    let style = &entry.style;
    html! {
        @if style.line == Line::Filled {
            path d=(format!("M{x:.2} {:.2}h28v10h-28z", y - 5.0)) fill=(style.colour) fill-opacity=(OPACITY) {}
        } @else if style.line != Line::None {
            path d=(format!("M{x:.2} {y:.2}h28")) stroke=(style.colour) stroke-width=(style.width)
                stroke-dasharray=[style.line.dashes()] {}
        }
        @if style.marker != Marker::None { (marker(style, x + 14.0, y)) }
        text x=(format!("{:.2}", x + SAMPLE)) y=(format!("{:.2}", y + 4.5)) font-size=(TEXT) {
            (label::svg(&entry.label, TEXT))
        }
    }
}
