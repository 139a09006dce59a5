//! What the deterministic solver costs with streams, thickness, and number of thicknesses.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::SolverCostRow;

/// Name in the file, name in the legend, style.
const TASKS: [(&str, &str, &str, Marker, Line); 3] = [
    ("first", "total, first of the medium", palette::BLUE, Marker::Circle, Line::Solid),
    ("further", "total, modes known", palette::GREEN, Marker::Triangle, Line::Dashed),
    ("orders", "orders 0 to 2 and total", palette::VERMILION, Marker::Square, Line::Dotted),
];

fn style((_, _, colour, marker, line): &(&str, &str, &'static str, Marker, Line)) -> Style {
    Style::line(colour, *line).with_marker(*marker)
}

pub fn figure(rows: &[SolverCostRow]) -> Figure {
    let panel = |title: &str, against: &str, label: &str, x: fn(&SolverCostRow) -> f64| {
        let rows: Vec<_> = rows.iter().filter(|row| row.against == against).collect();
        panel(title, label, &rows, x)
    };
    let by_streams = panel("One slab, streams given", "streams", "streams per hemisphere (number)", |row| {
        row.streams as f64
    });
    let by_tau = panel("One slab, to 10^{−5}", "tau", "optical thickness τ (1)", |row| row.tau);
    let by_count =
        panel("Several slabs at once, to 10^{−5}", "thicknesses", "thicknesses (number)", |row| {
            row.thicknesses as f64
        });
    Figure {
        name: "solver-cost".to_owned(),
        title: "Cost of the deterministic solver".to_owned(),
        caption: "Wall time of one call for one angle; the phase function is prepared (its moments, and their projection on \
                  the streams). The modes of a medium \
                  serve every thickness and angle. Where a tolerance is given, the search for the streams is included: \
                  steps are steps of its ladder. Orders use all cores, totals one."
            .to_owned(),
        legend: TASKS.iter().map(|task| LegendEntry::new(task.1, style(task))).collect(),
        rows: vec![
            Row { height: 300.0, panels: vec![by_streams, by_tau] },
            Row { height: 300.0, panels: vec![by_count] },
        ],
    }
}

fn panel(title: &str, label: &str, rows: &[&SolverCostRow], x: fn(&SolverCostRow) -> f64) -> Panel {
    let curve = |task: &(&str, &str, &'static str, Marker, Line)| Series {
        style: style(task),
        points: rows
            .iter()
            .filter(|row| row.task == task.0)
            .map(|row| Point::new(x(row), row.seconds))
            .collect(),
    };
    let series: Vec<_> = TASKS.iter().map(curve).collect();
    let all = || series.iter().flat_map(|s| &s.points);
    Panel {
        title: title.to_owned(),
        x: Axis::new(label, Scale::logarithmic(all().map(|p| p.x))),
        y: Axis::new("wall time (s)", Scale::logarithmic(all().map(|p| p.y))),
        series,
        marks: Vec::new(),
    }
}
