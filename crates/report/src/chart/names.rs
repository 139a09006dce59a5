//! Names beside points, none over another: above or below its point, right or left of it, or left out where no place is free.

use super::label;
use super::panel::{Mark, SMALL};
use super::series::Area;
use maud::{Markup, html};

/// Distance of a name from its point.
const GAP: f64 = 5.0;
/// What a line of text reaches above its base line.
const ASCENT: f64 = 0.8 * SMALL;

/// A name at the left end of its base line.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    x: f64,
    y: f64,
    width: f64,
    text: String,
}

impl Name {
    pub fn draw(&self) -> Markup {
        let (x, y) = (format!("{:.2}", self.x), format!("{:.2}", self.y));
        html! {
            text x=(x) y=(y) font-size=(SMALL) fill="#222" text-anchor="start" { (label::svg(&self.text, SMALL)) }
        }
    }

    fn overlaps(&self, other: &Self) -> bool {
        let apart = self.x >= other.x + other.width || other.x >= self.x + self.width;
        !apart && (self.y - other.y).abs() < SMALL
    }

    fn is_in(&self, area: &Area) -> bool {
        self.x >= 0.0 && self.x + self.width <= area.width && self.y >= ASCENT && self.y <= area.height
    }
}

/// The names of those marks that are points, as far as there is room.
pub fn names(marks: &[Mark], area: &Area) -> Vec<Name> {
    let mut placed: Vec<Name> = Vec::new();
    for (mark, (x, y)) in marks.iter().filter_map(|mark| Some((mark, area.place(mark.x, mark.y?)?))) {
        let width = label::width(&mark.label, SMALL);
        let [right, left] = [x + GAP, x - GAP - width];
        let [above, below] = [y - GAP, y + GAP + ASCENT];
        let places = [(right, above), (right, below), (left, below), (left, above)];
        let mut free = places.into_iter().map(|(x, y)| Name { x, y, width, text: mark.label.clone() });
        let free = free.find(|name| name.is_in(area) && !placed.iter().any(|other| other.overlaps(name)));
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
        let marks: Vec<Mark> = (0..9).map(|k| mark(50.0 + f64::from(k), 50.0)).collect();
        let names = names(&marks, &area());
        assert!(names.len() >= 2 && names.len() < marks.len(), "{}", names.len());
        for (i, name) in names.iter().enumerate() {
            assert!(name.is_in(&area()) && !names[..i].iter().any(|other| other.overlaps(name)));
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
