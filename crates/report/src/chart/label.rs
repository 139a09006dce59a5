//! Text with `_{subscripts}` and `^{superscripts}`, for SVG, HTML and plain text.

use maud::{Markup, html};

#[derive(Clone, Copy, PartialEq)]
enum Level {
    Base,
    Sub,
    Super,
}

/// Splits `text` at its subscripts and superscripts. An opening without an end reaches to the end.
fn pieces(text: &str) -> Vec<(Level, &str)> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some((at, level)) = next_opening(rest) {
        pieces.push((Level::Base, &rest[..at]));
        let inside = &rest[at + 2..];
        let end = inside.find('}').unwrap_or(inside.len());
        pieces.push((level, &inside[..end]));
        rest = inside.get(end + 1..).unwrap_or("");
    }
    pieces.push((Level::Base, rest));
    pieces.retain(|(_, piece)| !piece.is_empty());
    pieces
}

fn next_opening(text: &str) -> Option<(usize, Level)> {
    [(text.find("_{"), Level::Sub), (text.find("^{"), Level::Super)]
        .into_iter()
        .filter_map(|(at, level)| at.map(|at| (at, level)))
        .min_by_key(|(at, _)| *at)
}

/// Content of an SVG `text` element of `size` units. Shifts are by `dy`: not every reader knows `baseline-shift`.
pub fn svg(text: &str, size: f64) -> Markup {
    let mut height = 0.0;
    let spans: Vec<_> = pieces(text)
        .into_iter()
        .map(|(level, piece)| {
            let target = match level {
                Level::Base => 0.0,
                Level::Sub => 0.25 * size,
                Level::Super => -0.35 * size,
            };
            let (dy, font) = (target - height, if level == Level::Base { size } else { 0.74 * size });
            height = target;
            (piece, dy, font)
        })
        .collect();
    html! {
        @for (piece, dy, font) in spans {
            @if dy == 0.0 && font == size { (piece) }
            @else {
                // Some readers drop a space at the start of a span, none drops one between spans.
                @if piece.starts_with(' ') { " " }
                tspan dy=(format!("{dy:.2}")) font-size=(format!("{font:.1}")) { (piece.trim_start()) }
            }
        }
    }
}

/// The same text in a page.
pub fn html(text: &str) -> Markup {
    html! {
        @for (level, piece) in pieces(text) {
            @match level {
                Level::Base => (piece),
                Level::Sub => sub { (piece) },
                Level::Super => sup { (piece) },
            }
        }
    }
}

/// The same text without raised and lowered parts.
pub fn plain(text: &str) -> String {
    pieces(text).into_iter().map(|(_, piece)| piece).collect()
}

/// About the length of `text` in units, for a sans-serif face of `size` units.
pub fn width(text: &str, size: f64) -> f64 {
    pieces(text)
        .into_iter()
        .map(|(level, piece)| {
            let font = if level == Level::Base { size } else { 0.74 * size };
            0.58 * font * piece.chars().count() as f64
        })
        .fold(0.0, |sum, w| sum + w)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subscripts_come_back_to_the_line() {
        let text = svg("T_{ms}, m^{−1}", 10.0).into_string();
        assert_eq!(
            text,
            "T<tspan dy=\"2.50\" font-size=\"7.4\">ms</tspan><tspan dy=\"-2.50\" font-size=\"10.0\">, m\
             </tspan><tspan dy=\"-3.50\" font-size=\"7.4\">−1</tspan>"
        );
        assert_eq!(html("κ_{c}").into_string(), "κ<sub>c</sub>");
        assert_eq!(plain("κ_{c} (m^{−1})"), "κc (m−1)");
    }

    #[test]
    fn a_space_after_a_subscript_stays() {
        let text = svg("θ_{l} (degrees)", 10.0).into_string();
        assert!(text.contains("</tspan> <tspan") && text.contains(">(degrees)<"), "{text}");
    }

    #[test]
    fn text_is_escaped() {
        assert_eq!(svg("<b>&", 10.0).into_string(), "&lt;b&gt;&amp;");
        assert_eq!(html("x_{<i>").into_string(), "x<sub>&lt;i&gt;</sub>");
    }
}
