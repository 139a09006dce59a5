//! Names beside points, none over another or over a point: next to its point, or some lines away and led there by a line, or left out
//! where no place is free.

use super::label;
use super::panel::{Mark, SMALL};
use super::series::{Area, MARKER};
use maud::{Markup, html};

/// Distance of a name from its point.
const GAP: f64 = 5.0;
/// What a line of text reaches above its base line.
const ASCENT: f64 = 0.8 * SMALL;
/// How many lines a name may stand away from where it stands best.
const AWAY: u8 = 4;

/// A name at the left end of its base line.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    x: f64,
    y: f64,
    width: f64,
    text: String,
    /// Whether its right end is what is placed.
    ends: bool,
    /// The point, if a line leads there.
    led_to: Option<(f64, f64)>,
}

impl Name {
    pub fn draw(&self) -> Markup {
        let (at, anchor) = if self.ends { (self.x + self.width, "end") } else { (self.x, "start") };
        let (x, y) = (format!("{at:.2}"), format!("{:.2}", self.y));
        html! {
            @if let Some((to_x, to_y)) = self.led_to {
                @let from_x = if to_x < self.x { self.x - 1.0 } else { self.x + self.width + 1.0 };
                @let from_y = self.y - 0.5 * ASCENT;
                path d=(format!("M{from_x:.2} {from_y:.2}L{to_x:.2} {to_y:.2}")) stroke="#999" stroke-width="0.7" {}
            }
            text x=(x) y=(y) font-size=(SMALL) fill="#222" text-anchor=(anchor) { (label::svg(&self.text, SMALL)) }
        }
    }

    fn overlaps(&self, other: &Self) -> bool {
        let apart = self.x >= other.x + other.width || other.x >= self.x + self.width;
        !apart && (self.y - other.y).abs() < SMALL
    }

    fn covers(&self, (x, y): (f64, f64)) -> bool {
        let across = x > self.x - MARKER && x < self.x + self.width + MARKER;
        across && y > self.y - ASCENT - MARKER && y < self.y + MARKER
    }

    fn is_in(&self, area: &Area) -> bool {
        self.x >= 0.0 && self.x + self.width <= area.width && self.y >= ASCENT && self.y <= area.height
    }
}

/// Where the name of the point at (x, y) may stand, the best place first.
fn places((x, y): (f64, f64), text: &str) -> Vec<Name> {
    let width = label::width(text, SMALL);
    let [right, left] = [x + GAP, x - GAP - width];
    let mut places = Vec::new();
    for line in 0..=AWAY {
        let away = f64::from(line) * (SMALL + 1.0);
        let (outwards, led_to) = (if line == 0 { 0.0 } else { 2.0 * GAP }, (line > 0).then_some((x, y)));
        let [above, below] = [y - GAP - away, y + GAP + ASCENT + away];
        let [right, left] = [right + outwards, left - outwards];
        let name = |(at, y)| Name { x: at, y, width, text: text.to_owned(), ends: at < x, led_to };
        places.extend([(right, above), (right, below), (left, below), (left, above)].map(name));
    }
    places
}

/// The names of those marks that are points, as far as there is room.
pub fn names(marks: &[Mark], area: &Area) -> Vec<Name> {
    let points = marks.iter().filter_map(|mark| Some((mark, area.place(mark.x, mark.y?)?)));
    let points: Vec<(&Mark, (f64, f64))> = points.collect();
    let mut placed: Vec<Name> = Vec::new();
    for (mark, point) in &points {
        let free = places(*point, &mark.label).into_iter().find(|name| {
            let hidden = points.iter().any(|(_, other)| name.covers(*other));
            name.is_in(area) && !hidden && !placed.iter().any(|other| other.overlaps(name))
        });
        placed.extend(free);
    }
    placed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Scale;

    fn area() -> Area {
        Area { x: Scale::linear([0.0, 100.0]), y: Scale::linear([0.0, 100.0]), width: 100.0, height: 100.0 }
    }

    fn mark(x: f64, y: f64) -> Mark {
        Mark { x, y: Some(y), label: "10^{4}".to_owned() }
    }

    #[test]
    fn close_points_have_names_apart_and_crowded_ones_none() {
        let marks: Vec<Mark> = (0..40).map(|k| mark(50.0 + 0.2 * f64::from(k), 50.0)).collect();
        let names = names(&marks, &area());
        assert!(names.len() >= 2 && names.len() < marks.len(), "{}", names.len());
        for (i, name) in names.iter().enumerate() {
            assert!(name.is_in(&area()) && !names[..i].iter().any(|other| other.overlaps(name)));
            assert!(marks.iter().all(|mark| !name.covers((mark.x, 50.0))));
        }
        // Without the rule they would overlap.
        let first = names[0].clone();
        assert!(Name { x: first.x + 1.0, ..first.clone() }.overlaps(&first));
    }

    #[test]
    fn a_name_stays_inside() {
        let corner = [mark(99.0, 99.0)];
        let names = names(&corner, &area());
        assert!(names.len() == 1 && names[0].x < 99.0 && names[0].is_in(&area()), "{names:?}");
    }
}
