//! Error of the size average against the radii used and against time.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::QuadratureRow;

/// A quantity, how its error is read, and how it is drawn.
type Curve = (&'static str, fn(&QuadratureRow) -> f64, &'static str, Marker, Line);

const CURVES: [Curve; 5] = [
    ("g (absolute)", |row| row.asymmetry, palette::BLACK, Marker::Circle, Line::Solid),
    ("P_f (absolute)", |row| row.forward_fraction, palette::BLUE, Marker::Square, Line::Dashed),
    ("moments (absolute)", |row| row.moments, palette::PURPLE, Marker::Cross, Line::Dotted),
    ("P below 60° (relative)", |row| row.phase_below_60_deg, palette::GREEN, Marker::Triangle, Line::DashDot),
    ("P beyond 60° (relative)", |row| row.phase_beyond_60_deg, palette::VERMILION, Marker::Ring, Line::Solid),
];

pub fn figure(rows: &[QuadratureRow]) -> Figure {
    let looks = CURVES.iter().map(|(name, _, colour, marker, line)| {
        LegendEntry::new(*name, Style::line(colour, *line).with_marker(*marker))
    });
    let panels = vec![
        panel("Against radii", "droplet radii (number)", rows, |row| row.radii as f64),
        panel("Against time", "wall time (s)", rows, |row| row.seconds),
    ];
    Figure {
        name: "quadrature".to_owned(),
        title: "Convergence of the average over droplet sizes".to_owned(),
        caption: "Error that each doubling of the radii estimates for itself, largest over angles or moments. Resonances \
                  of single droplets are narrower than any step here: P at large angles pays for them with a slow fall."
            .to_owned(),
        legend: looks.collect(),
        rows: vec![Row { height: 340.0, panels }],
    }
}

fn panel(title: &str, label: &str, rows: &[QuadratureRow], effort: fn(&QuadratureRow) -> f64) -> Panel {
    let curve = |(_, error, colour, marker, line): &Curve| Series {
        style: Style::line(colour, *line).with_marker(*marker),
        points: rows
            .iter()
            .filter(|row| error(row) > 0.0)
            .map(|row| Point::new(effort(row), error(row)))
            .collect(),
    };
    let series: Vec<_> = CURVES.iter().map(curve).collect();
    let all = || series.iter().flat_map(|s| &s.points);
    Panel {
        title: title.to_owned(),
        x: Axis::new(label, Scale::logarithmic(all().map(|p| p.x))),
        y: Axis::new("estimated error (absolute or relative)", Scale::logarithmic(all().map(|p| p.y))),
        series,
        marks: Vec::new(),
    }
}
