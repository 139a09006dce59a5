//! Charts as SVG text: panels with linear, logarithmic or polar axes, lines, areas, error bars, dashes and markers.
//!
//! Written here rather than taken from a plotting crate, because a figure of this report is a grid of panels of
//! unequal width with one legend above them, subscripts in its labels and several dash patterns and markers per
//! colour, and because its bytes must not depend on what was drawn before. An SVG made here has no `id` at
//! all: data are clipped by nested `svg` viewports. Hence any number of figures can stand in one page.
//!
//! Lengths are in user units, 1/96 inch when printed at full width (720 units, 19 cm). Values that an axis
//! cannot show (not finite, or not positive on a logarithmic axis) are left out of the drawing, and they never
//! reach the text.

mod figure;
mod label;
mod names;
mod panel;
mod polar;
mod scale;
mod series;
mod style;

pub use figure::{Figure, LegendEntry, Row};
pub use label::html;
pub use panel::{Axis, Mark, Panel};
pub use scale::Scale;
pub use series::{Point, Series};
pub use style::{Line, Marker, Style, palette};
