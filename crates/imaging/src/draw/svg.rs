//! A picture in a frame: title above, scale bar below, everything inside one `svg` element without ids.

use super::base64::base64;
use crate::{Image, ImagingError, Tone};
use std::fmt::Write;

/// Width of the drawing in user units.
const WIDTH: f64 = 480.0;
const TITLE: f64 = 22.0;
const BAR: f64 = 46.0;

/// A scale bar.
pub(super) struct Bar {
    /// Colours from its start to its end.
    pub steps: Vec<[u8; 3]>,
    /// Numbers at start, middle and end.
    pub ends: [f64; 3],
    /// What they are.
    pub label: String,
}

/// `image` as `tone` shows it, under its title.
///
/// # Errors
/// As [`Image::to_png`].
pub fn picture_svg(title: &str, image: &Image, tone: &Tone) -> Result<String, ImagingError> {
    Ok(framed(title, (image.width(), image.height()), &image.to_png(tone)?, None))
}

pub(super) fn framed(title: &str, (columns, rows): (usize, usize), png: &[u8], bar: Option<&Bar>) -> String {
    let height = WIDTH * rows as f64 / columns as f64;
    let whole = TITLE + height + if bar.is_some() { BAR } else { 0.0 };
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {whole:.1}\" width=\"{WIDTH}\" role=\"img\" \
         aria-label=\"{title}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#111\">\
         <text x=\"0\" y=\"15\" font-size=\"14\" font-weight=\"bold\">{title}</text>\
         <image x=\"0\" y=\"{TITLE}\" width=\"{WIDTH}\" height=\"{height:.1}\" preserveAspectRatio=\"none\" \
         image-rendering=\"pixelated\" href=\"data:image/png;base64,{data}\"/>",
        title = escaped(title),
        data = base64(png)
    );
    if let Some(bar) = bar {
        svg.push_str(&drawn(bar, TITLE + height + 8.0));
    }
    svg + "</svg>\n"
}

fn drawn(bar: &Bar, y: f64) -> String {
    let step = WIDTH / bar.steps.len() as f64;
    let mut svg = String::new();
    for (i, [r, g, b]) in bar.steps.iter().enumerate() {
        let x = i as f64 * step;
        // Writing to a string cannot fail.
        let _ = write!(
            svg,
            "<rect x=\"{x:.2}\" y=\"{y:.1}\" width=\"{:.2}\" height=\"10\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>",
            step + 0.3
        );
    }
    let ends = [(0.0, "start"), (0.5, "middle"), (1.0, "end")];
    for ((share, anchor), value) in ends.iter().zip(bar.ends) {
        let (x, y) = (share * WIDTH, y + 22.0);
        let _ = write!(svg, "<text x=\"{x}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{value}</text>");
    }
    let (x, y, label) = (0.5 * WIDTH, y + 36.0, escaped(&bar.label));
    let _ = write!(svg, "<text x=\"{x}\" y=\"{y:.1}\" text-anchor=\"middle\">{label}</text>");
    svg
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
