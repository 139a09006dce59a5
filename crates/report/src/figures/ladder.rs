//! The ladder of approximations: what each step from the solver to the emitted shader loses, one mark per rung and flux.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::LadderRow;

/// A rung's name in the file, and on the axis.
pub const RUNGS: [&str; 7] = ["solver", "monte-carlo", "model", "f32", "interpolation", "shader", "together"];

/// A flux, its name in the legend, and how it is drawn.
type Look = (&'static str, &'static str, &'static str, Marker);

const LOOKS: [Look; 8] = [
    ("t_ms", "T_{ms}", palette::BLACK, Marker::Circle),
    ("t_0", "T_{0}", palette::BLUE, Marker::Square),
    ("t_1", "T_{1}", palette::ORANGE, Marker::Triangle),
    ("t_2", "T_{2}", palette::GREEN, Marker::Diamond),
    ("t_3_plus", "T_{3+}", palette::PURPLE, Marker::Cross),
    ("r_1", "R_{1}", palette::ORANGE, Marker::Ring),
    ("r_2", "R_{2}", palette::GREEN, Marker::Ring),
    ("r_3_plus", "R_{3+}", palette::PURPLE, Marker::Ring),
];
const CHANCE: Style = Style::line(palette::GREY, Line::Solid).with_width(3.0);

/// Largest and smallest loss drawn: what is smaller is arithmetic that agrees to the last digit.
const SMALLEST: f64 = 1e-12;

pub fn figure(rows: &[LadderRow]) -> Figure {
    let mut legend: Vec<_> = LOOKS
        .iter()
        .map(|(_, name, colour, marker)| LegendEntry::new(*name, Style::points(colour, *marker)))
        .collect();
    legend.push(LegendEntry::new("rms that chance explains", CHANCE));
    let panels = [
        ("Root mean square, angles up to 80°", LadderRow::TO_80, Size::Rms),
        ("Worst, angles up to 80°", LadderRow::TO_80, Size::Worst),
        ("Worst, all angles and diffuse light", LadderRow::ALL, Size::Worst),
    ];
    Figure {
        name: "ladder".to_owned(),
        title: "What each approximation loses".to_owned(),
        caption: "Each rung against the one before at points where nothing else differs, except the solver (its own \
                  estimated error) and “together” (all steps at once, against the solver). Losses below 10^{−12} are not \
                  drawn."
            .to_owned(),
        legend,
        rows: panels
            .map(|(title, angles, size)| Row { height: 250.0, panels: vec![panel(rows, title, angles, size)] })
            .to_vec(),
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Size {
    Rms,
    Worst,
}

fn panel(rows: &[LadderRow], title: &str, angles: &str, size: Size) -> Panel {
    let here = || rows.iter().filter(|row| row.angles == angles);
    let mut series = Vec::new();
    for (i, (quantity, _, colour, marker)) in LOOKS.iter().enumerate() {
        let place = |row: &LadderRow| {
            let rung = RUNGS.iter().position(|rung| *rung == row.rung)?;
            // Side by side, so that no mark hides another.
            Some(rung as f64 + 0.09 * (i as f64 - 3.5))
        };
        for row in here().filter(|row| row.quantity == *quantity && size == Size::Rms) {
            if let (Some(x), Some(expected)) = (place(row), row.expected_rms) {
                let points = vec![Point::new(x - 0.045, expected), Point::new(x + 0.045, expected)];
                series.push(Series { style: CHANCE, points });
            }
        }
        let point = |row: &LadderRow| {
            let loss = if size == Size::Rms { row.rms? } else { row.worst? };
            (loss >= SMALLEST).then_some(Point::new(place(row)?, loss))
        };
        let points = here().filter(|row| row.quantity == *quantity).filter_map(point).collect();
        series.push(Series { style: Style::points(colour, *marker), points });
    }
    let losses = || series.iter().flat_map(|s| &s.points).map(|p| p.y);
    Panel {
        title: title.to_owned(),
        x: Axis::new("rung", Scale::named(&RUNGS)),
        y: Axis::new("loss (per incident flux)", Scale::logarithmic(losses())),
        series,
        marks: Vec::new(),
    }
}
