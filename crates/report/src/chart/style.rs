//! Colours, dashes and markers.

/// Colours that stay apart for colour-blind readers (Okabe & Ito 2008, "Color universal design").
pub mod palette {
    /// Black.
    pub const BLACK: &str = "#000000";
    /// Orange.
    pub const ORANGE: &str = "#D98200";
    /// Bluish green.
    pub const GREEN: &str = "#009E73";
    /// Blue.
    pub const BLUE: &str = "#0072B2";
    /// Vermilion.
    pub const VERMILION: &str = "#D55E00";
    /// Reddish purple.
    pub const PURPLE: &str = "#A8508A";
    /// Grey.
    pub const GREY: &str = "#8A8A8A";
}

/// How points are joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// They are not.
    None,
    /// ———
    Solid,
    /// – – –
    Dashed,
    /// ·····
    Dotted,
    /// – · –
    DashDot,
    /// They go round a polygon, which is filled.
    Filled,
}

impl Line {
    /// The value of `stroke-dasharray`, for all but solid lines.
    pub fn dashes(self) -> Option<&'static str> {
        match self {
            Line::None | Line::Solid | Line::Filled => None,
            Line::Dashed => Some("7 4"),
            Line::Dotted => Some("2 3"),
            Line::DashDot => Some("8 3 2 3"),
        }
    }
}

/// How a point is marked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Marker {
    /// Not at all.
    None,
    /// ●
    Circle,
    /// ○
    Ring,
    /// ■
    Square,
    /// ▲
    Triangle,
    /// ◆
    Diamond,
    /// ×
    Cross,
}

impl Marker {
    /// Path of the marker around the origin, half its size being `r`; crosses and rings are stroked, the others filled.
    pub fn path(self, r: f64) -> String {
        match self {
            Marker::None => String::new(),
            Marker::Circle | Marker::Ring => {
                format!(
                    "M{:.2} 0a{r:.2} {r:.2} 0 1 0 {:.2} 0a{r:.2} {r:.2} 0 1 0 {:.2} 0z",
                    -r,
                    2.0 * r,
                    -2.0 * r
                )
            }
            Marker::Square => {
                let a = 0.88 * r;
                format!("M{:.2} {:.2}h{:.2}v{:.2}h{:.2}z", -a, -a, 2.0 * a, 2.0 * a, -2.0 * a)
            }
            Marker::Triangle => {
                let (half, up, down) = (1.08 * r, -1.1 * r, 0.8 * r);
                format!("M0 {up:.2}L{half:.2} {down:.2}L{:.2} {down:.2}z", -half)
            }
            Marker::Diamond => {
                let a = 1.25 * r;
                format!("M0 {:.2}L{a:.2} 0L0 {a:.2}L{:.2} 0z", -a, -a)
            }
            Marker::Cross => format!("M{:.2} {:.2}L{r:.2} {r:.2}M{:.2} {r:.2}L{r:.2} {:.2}", -r, -r, -r, -r),
        }
    }

    /// Whether the marker is drawn as an outline.
    pub fn stroked(self) -> bool {
        matches!(self, Marker::Cross | Marker::Ring)
    }
}

/// Colour, line and marker of a series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// A colour of [`palette`].
    pub colour: &'static str,
    /// Line.
    pub line: Line,
    /// Stroke width in units.
    pub width: f64,
    /// Marker.
    pub marker: Marker,
}

impl Style {
    /// A line without markers.
    pub const fn line(colour: &'static str, line: Line) -> Self {
        Self { colour, line, width: 1.6, marker: Marker::None }
    }

    /// A polygon without an outline.
    pub const fn filled(colour: &'static str) -> Self {
        Self { colour, line: Line::Filled, width: 0.0, marker: Marker::None }
    }

    /// Markers without a line.
    pub const fn points(colour: &'static str, marker: Marker) -> Self {
        Self { colour, line: Line::None, width: 1.2, marker }
    }

    /// The same with a marker.
    pub const fn with_marker(self, marker: Marker) -> Self {
        Self { marker, ..self }
    }

    /// The same with another stroke width.
    pub const fn with_width(self, width: f64) -> Self {
        Self { width, ..self }
    }
}
