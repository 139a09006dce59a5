//! One figure for each knob: error and cost as it turns.

use super::scene::{QUANTITIES, logarithmic};
use crate::chart::{Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Series, Style, palette};
use stratiform_artifact::KnobRow;

const STYLES: [(&str, Line, Marker); 4] = [
    (palette::BLUE, Line::Solid, Marker::Circle),
    (palette::ORANGE, Line::Dashed, Marker::Triangle),
    (palette::GREEN, Line::DashDot, Marker::Diamond),
    (palette::VERMILION, Line::Dotted, Marker::Square),
];

/// A figure for each method and knob.
pub fn figures(rows: &[KnobRow]) -> Vec<Figure> {
    let mut seen: Vec<(&str, &str)> = Vec::new();
    for row in rows {
        if !seen.contains(&(&row.method, &row.knob)) {
            seen.push((&row.method, &row.knob));
        }
    }
    seen.into_iter().map(|(method, knob)| figure(method, knob, rows)).collect()
}

fn figure(method: &str, knob: &str, rows: &[KnobRow]) -> Figure {
    let rows: Vec<&KnobRow> = rows.iter().filter(|row| row.method == method && row.knob == knob).collect();
    let drawn: Vec<_> = QUANTITIES
        .iter()
        .zip(STYLES)
        .filter(|((quantity, _), _)| rows.iter().any(|row| row.quantity == *quantity))
        .map(|((quantity, title), (colour, line, marker))| {
            (*quantity, *title, Style::line(colour, line).with_marker(marker))
        })
        .collect();
    let panel = |title: &str, label: &str, value: fn(&KnobRow) -> Option<f64>| {
        let series: Vec<Series> = drawn
            .iter()
            .map(|(quantity, _, style)| Series {
                style: *style,
                points: rows
                    .iter()
                    .filter(|row| row.quantity == *quantity)
                    .filter_map(|row| Some(Point::new(row.setting, value(row)?)))
                    .collect(),
            })
            .collect();
        let all = || series.iter().flat_map(|s| &s.points);
        Panel {
            title: title.to_owned(),
            x: Axis::new(knob, logarithmic(all().map(|p| p.x))),
            y: Axis::new(label, logarithmic(all().map(|p| p.y))),
            series,
            marks: Vec::new(),
        }
    };
    let panels = vec![
        panel("Error", "median relative error (1)", |row| row.median),
        panel("Cost", "time of one evaluation (ns)", |row| row.ns_per_evaluation),
    ];
    Figure {
        name: format!("knob-{method}-{}", knob.replace(' ', "-")),
        title: format!("{method}: {knob}"),
        caption: format!("The curves of {method} as its knob turns, in one scene's main cloud."),
        legend: drawn.iter().map(|(_, title, style)| LegendEntry::new(*title, *style)).collect(),
        rows: vec![Row { height: 300.0, panels }],
    }
}
