//! Data drawn into a panel: lines, markers, error bars.

use super::{Line, Marker, Scale, Style, polar};
use maud::{Markup, html};
use std::fmt::Write;

/// A datum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Abscissa.
    pub x: f64,
    /// Ordinate.
    pub y: f64,
    /// Half the length of the error bar; 0 draws none.
    pub error: f64,
}

impl Point {
    /// A datum without error bar.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y, error: 0.0 }
    }
}

/// Points with a style.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Style.
    pub style: Style,
    /// Points in drawing order.
    pub points: Vec<Point>,
}

/// A data area: scales and size in units.
pub struct Area {
    /// Scale along x.
    pub x: Scale,
    /// Scale along y.
    pub y: Scale,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

/// Of filled polygons.
pub const OPACITY: f64 = 0.5;

/// Half the size of a marker.
pub const MARKER: f64 = 3.4;

impl Area {
    /// Place of a datum, y downwards.
    pub fn place(&self, x: f64, y: f64) -> Option<(f64, f64)> {
        if self.x.is_round() {
            return polar::place(self, x, y);
        }
        Some((self.x.position(x)? * self.width, (1.0 - self.y.position(y)?) * self.height))
    }
}

impl Series {
    /// The series as SVG elements.
    pub fn draw(&self, area: &Area) -> Markup {
        let path = self.path(area);
        html! {
            @if !path.is_empty() && self.style.line == Line::Filled {
                path d=(path) fill=(self.style.colour) fill-opacity=(OPACITY) {}
            } @else if !path.is_empty() {
                path d=(path) fill="none" stroke=(self.style.colour) stroke-width=(self.style.width)
                    stroke-linejoin="round" stroke-dasharray=[self.style.line.dashes()] {}
            }
            @for point in &self.points {
                @if point.error > 0.0 { (self.error_bar(area, point)) }
            }
            @if self.style.marker != Marker::None {
                @for (x, y) in self.points.iter().filter_map(|p| area.place(p.x, p.y)) {
                    (marker(&self.style, x, y))
                }
            }
        }
    }

    fn path(&self, area: &Area) -> String {
        let mut path = String::new();
        if self.style.line == Line::None {
            return path;
        }
        let mut pen_down = false;
        let places: Vec<_> = self.points.iter().map(|p| area.place(p.x, p.y)).collect();
        for place in thinned(&places) {
            if let Some((x, y)) = place {
                let _ = write!(path, "{}{x:.1} {y:.1}", if pen_down { 'L' } else { 'M' });
            }
            pen_down = place.is_some();
        }
        if self.style.line == Line::Filled && !path.is_empty() {
            path.push('Z');
        }
        path
    }

    fn error_bar(&self, area: &Area, point: &Point) -> Markup {
        let Some((x, middle)) = area.place(point.x, point.y) else { return html! {} };
        let end = |y: f64, beyond: f64| {
            area.place(point.x, y).map_or(beyond, |(_, y)| y.clamp(-9.0, area.height + 9.0))
        };
        let (top, bottom) = (end(point.y + point.error, -9.0), end(point.y - point.error, area.height + 9.0));
        let mut path = format!("M{x:.2} {top:.2}V{bottom:.2}");
        for y in [top, bottom] {
            if (y - middle).abs() > 1.0 {
                let _ = write!(path, "M{:.2} {y:.2}h6", x - 3.0);
            }
        }
        html! { path class="error" d=(path) fill="none" stroke=(self.style.colour) stroke-width="1.1" {} }
    }
}

/// One marker.
pub fn marker(style: &Style, x: f64, y: f64) -> Markup {
    let path = style.marker.path(MARKER);
    let place = format!("translate({x:.2} {y:.2})");
    html! {
        @if style.marker.stroked() {
            path d=(path) transform=(place) fill="none" stroke=(style.colour) stroke-width="1.4" {}
        } @else {
            path d=(path) transform=(place) fill=(style.colour) {}
        }
    }
}

/// Keeps the first, lowest, highest and last of neighbours that fall into the same half unit: what a printer can show.
fn thinned(places: &[Option<(f64, f64)>]) -> Vec<Option<(f64, f64)>> {
    let column = |place: &Option<(f64, f64)>| place.map(|(x, _)| libm::floor(2.0 * x) as i64);
    let mut kept = Vec::new();
    for group in places.chunk_by(|a, b| column(a) == column(b)) {
        let height = |i: usize| group[i].map_or(0.0, |(_, y)| y);
        let by_height = |a: &usize, b: &usize| height(*a).total_cmp(&height(*b));
        let mut wanted = vec![0, group.len() - 1];
        wanted.extend((0..group.len()).min_by(by_height));
        wanted.extend((0..group.len()).max_by(by_height));
        wanted.sort_unstable();
        wanted.dedup();
        kept.extend(wanted.into_iter().map(|i| group[i]));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::palette::BLACK;

    fn area() -> Area {
        Area {
            x: Scale::linear([0.0, 1.0]),
            y: Scale::logarithmic([1.0, 100.0]),
            width: 100.0,
            height: 100.0,
        }
    }

    #[test]
    fn what_a_log_axis_cannot_show_breaks_the_line() {
        let points = vec![
            Point::new(0.0, 1.0),
            Point::new(0.2, 10.0),
            Point::new(0.5, 0.0),
            Point::new(0.8, f64::NAN),
            Point::new(1.0, 10.0),
        ];
        let svg = Series { style: Style::line(BLACK, Line::Solid), points }.draw(&area()).into_string();
        assert_eq!(svg.matches('M').count(), 2, "{svg}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }

    #[test]
    fn a_datum_stands_where_its_axis_says() {
        let (x, y) = area().place(0.5, 10.0).unwrap();
        assert!((x - 50.0).abs() < 1e-9 && (y - 50.0).abs() < 1e-9);
        let (left, low) = area().place(0.25, 2.0).unwrap();
        let per_unit = 100.0 / 1.06;
        assert!((x - left - 0.25 * per_unit).abs() < 1e-9);
        assert!((low - y - 0.5 * libm::log10(5.0) * per_unit).abs() < 1e-9);
    }

    #[test]
    fn an_error_bar_that_reaches_zero_ends_at_the_edge() {
        let points = vec![Point { x: 0.5, y: 5.0, error: 6.0 }];
        let svg = Series { style: Style::points(BLACK, Marker::Circle), points }.draw(&area()).into_string();
        assert!(svg.contains("V109.00"), "{svg}");
    }

    #[test]
    fn thinning_keeps_peaks() {
        let places: Vec<_> =
            (0..1000).map(|i| Some((f64::from(i) * 0.01, if i == 503 { 90.0 } else { 1.0 }))).collect();
        let kept = thinned(&places);
        assert!(kept.len() < 90 && kept.contains(&Some((5.03, 90.0))));
        assert_eq!((kept.first(), kept.last()), (places.first(), places.last()));
    }
}
