//! Polar panels: the abscissa is an angle from the zenith, -90° to 90°, the ordinate a radius from 0.

use super::label;
use super::panel::{Mark, Panel, SMALL, TEXT};
use super::series::Area;
use maud::{Markup, html};

/// Room for labels between the rim and the edge of the area.
const RIM: f64 = 16.0;

/// Centre and radius of the half circle, standing on the lower edge.
fn circle(area: &Area) -> (f64, f64, f64) {
    let radius = (0.5 * area.width).min(area.height) - RIM;
    (0.5 * area.width, area.height, radius)
}

/// The point at `share` of the radius under `angle` degrees.
fn at(area: &Area, angle: f64, share: f64) -> (f64, f64) {
    let (x, y, radius) = circle(area);
    let angle = angle.to_radians();
    (x + share * radius * libm::sin(angle), y - share * radius * libm::cos(angle))
}

/// Place of a datum.
pub fn place(area: &Area, angle: f64, radius: f64) -> Option<(f64, f64)> {
    (angle.is_finite()).then_some(())?;
    Some(at(area, angle, area.y.position(radius)?.max(0.0)))
}

/// The panel; its area begins at (`x`, `y`).
pub fn draw(panel: &Panel, area: &Area, x: f64, y: f64) -> Markup {
    let (width, height) = (area.width, area.height);
    html! {
        g transform=(format!("translate({x:.2} {y:.2})")) {
            (rings(area))
            svg width=(format!("{width:.2}")) height=(format!("{height:.2}")) {
                @for mark in panel.marks.iter().filter(|mark| mark.y.is_none()) { (spoke(mark, area)) }
                @for series in &panel.series { (series.draw(area)) }
            }
            (names(panel, area))
        }
    }
}

/// Circles at the ticks of the radius, spokes at those of the angle.
fn rings(area: &Area) -> Markup {
    let (x, y, radius) = circle(area);
    let ticks = area.y.ticks((radius / 40.0) as usize);
    let shares = ticks.iter().filter_map(|tick| Some((area.y.position(tick.value)?, tick)));
    html! {
        @for tick in area.x.ticks(6) {
            @let (tip_x, tip_y) = at(area, tick.value, 1.0);
            @let (name_x, name_y) = at(area, tick.value, 1.0 + 9.0 / radius);
            path d=(format!("M{x:.2} {y:.2}L{tip_x:.2} {tip_y:.2}")) stroke="#e4e4e4" {}
            @if let Some(text) = &tick.label {
                text x=(format!("{name_x:.2}")) y=(format!("{:.2}", name_y + 4.0)) font-size=(SMALL)
                    text-anchor="middle" { (label::svg(text, SMALL)) }
            }
        }
        @for (share, tick) in shares.filter(|(share, _)| *share > 0.0) {
            @let r = share * radius;
            path d=(format!("M{:.2} {y:.2}a{r:.2} {r:.2} 0 0 1 {:.2} 0", x - r, 2.0 * r)) fill="none" stroke="#d4d4d4" {}
            @if let Some(text) = &tick.label {
                text x=(format!("{:.2}", x + r)) y=(format!("{:.2}", y + 13.0)) font-size=(SMALL)
                    text-anchor="middle" { (label::svg(text, SMALL)) }
                text x=(format!("{:.2}", x - r)) y=(format!("{:.2}", y + 13.0)) font-size=(SMALL)
                    text-anchor="middle" { (label::svg(text, SMALL)) }
            }
        }
        path d=(format!("M{:.2} {y:.2}a{radius:.2} {radius:.2} 0 0 1 {:.2} 0z", x - radius, 2.0 * radius)) fill="none"
            stroke="#333" {}
    }
}

fn spoke(mark: &Mark, area: &Area) -> Markup {
    let (x, y, _) = circle(area);
    let (tip_x, tip_y) = at(area, mark.x, 1.0);
    let (name_x, name_y) = at(area, mark.x, 0.93);
    html! {
        path d=(format!("M{x:.2} {y:.2}L{tip_x:.2} {tip_y:.2}")) stroke="#666" stroke-dasharray="2 3" {}
        text x=(format!("{:.2}", name_x + 4.0)) y=(format!("{:.2}", name_y - 3.0)) font-size=(TEXT) font-weight="bold"
            fill="#222" { (label::svg(&mark.label, TEXT)) }
    }
}

fn names(panel: &Panel, area: &Area) -> Markup {
    let (x, y, _) = circle(area);
    html! {
        @if !panel.title.is_empty() {
            text x="0" y="-8" font-size=(TEXT) font-weight="bold" { (label::svg(&panel.title, TEXT)) }
        }
        text class="axis" x="0" y="12" font-size=(SMALL) { (label::svg(&panel.x.label, SMALL)) }
        text class="axis" x=(format!("{x:.2}")) y=(format!("{:.2}", y + 30.0)) font-size=(TEXT) text-anchor="middle" {
            (label::svg(&panel.y.label, TEXT))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Scale;

    /// The zenith is above the centre, 90° to its right, radii are from 0.
    #[test]
    fn angles_count_from_the_zenith() {
        let area = Area { x: Scale::half_circle(), y: Scale::from_zero(2.0), width: 232.0, height: 116.0 };
        let near = |a: Option<(f64, f64)>, b: (f64, f64)| {
            let (x, y) = a.unwrap();
            assert!((x - b.0).abs() < 1e-9 && (y - b.1).abs() < 1e-9, "{x} {y}");
        };
        near(area.place(0.0, 2.0), (116.0, 16.0));
        near(area.place(90.0, 1.0), (166.0, 116.0));
        near(area.place(-90.0, 2.0), (16.0, 116.0));
        near(area.place(45.0, 0.0), (116.0, 116.0));
        assert_eq!(area.place(f64::NAN, 1.0), None);
    }
}
