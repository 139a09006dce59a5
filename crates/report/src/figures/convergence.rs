//! Monte Carlo error against photons and against time, with the slope -1/2 that independent samples give.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::ConvergenceRow;

/// The runs of one estimator with one number of photons.
struct Group {
    photons: f64,
    /// Mean over the rows.
    seconds: f64,
    /// Root mean square over the rows.
    error: f64,
    /// Root mean square over the rows.
    std_error: f64,
}

const LOOKS: [(&str, Marker, Line); 4] = [
    (palette::VERMILION, Marker::Square, Line::Dashed),
    (palette::BLUE, Marker::Ring, Line::Dotted),
    (palette::GREEN, Marker::Triangle, Line::Solid),
    (palette::PURPLE, Marker::Cross, Line::Solid),
];
const SLOPE: Style = Style::line(palette::GREY, Line::DashDot).with_width(1.2);

pub fn figure(rows: &[ConvergenceRow]) -> Figure {
    let mut names: Vec<&str> = rows.iter().map(|row| row.estimator.as_str()).collect();
    names.sort_unstable_by(|a, b| b.cmp(a));
    names.dedup();
    let estimators: Vec<_> = names.iter().map(|name| groups(rows, name)).collect();
    let mut legend = Vec::new();
    for (name, (colour, marker, line)) in names.iter().zip(LOOKS.into_iter().cycle()) {
        legend.push(LegendEntry::new(format!("{name}: error"), Style::points(colour, marker)));
        legend.push(LegendEntry::new(format!("{name}: standard error"), Style::line(colour, line)));
    }
    legend.push(LegendEntry::new("slope −1/2", SLOPE));
    let panels = vec![
        panel("Against photons", "photons traced (histories)", &estimators, |group| group.photons),
        panel("Against time", "wall time (s)", &estimators, |group| group.seconds),
    ];
    Figure {
        name: "convergence".to_owned(),
        title: "Convergence of the photon tracer".to_owned(),
        caption: "Root mean square, over the angles, thicknesses and orders of convergence.csv, of the error of the \
                  reflectance (difference from a run of many more photons) and of the standard error that the runs \
                  claim for themselves. The thicknesses of one half-space run share their photons, so its points \
                  scatter together."
            .to_owned(),
        legend,
        rows: vec![Row { height: 340.0, panels }],
    }
}

fn groups(rows: &[ConvergenceRow], estimator: &str) -> Vec<Group> {
    let mut rows: Vec<_> = rows.iter().filter(|row| row.estimator == estimator).collect();
    rows.sort_by_key(|row| row.photons);
    let mean = |group: &[&ConvergenceRow], of: fn(&ConvergenceRow) -> f64| {
        group.iter().fold(0.0, |sum, row| sum + of(row)) / group.len() as f64
    };
    rows.chunk_by(|a, b| a.photons == b.photons)
        .map(|group| Group {
            photons: group[0].photons as f64,
            seconds: mean(group, |row| row.seconds),
            error: mean(group, |row| row.error * row.error).sqrt(),
            std_error: mean(group, |row| row.std_error * row.std_error).sqrt(),
        })
        .collect()
}

fn panel(title: &str, label: &str, estimators: &[Vec<Group>], effort: fn(&Group) -> f64) -> Panel {
    let mut series = Vec::new();
    for (groups, (colour, marker, line)) in estimators.iter().zip(LOOKS.into_iter().cycle()) {
        let points = |of: fn(&Group) -> f64| groups.iter().map(|g| Point::new(effort(g), of(g))).collect();
        series.extend(slope(groups, effort));
        series.push(Series { style: Style::line(colour, line), points: points(|g| g.std_error) });
        series.push(Series { style: Style::points(colour, marker), points: points(|g| g.error) });
    }
    let all = || series.iter().flat_map(|s| &s.points);
    Panel {
        title: title.to_owned(),
        x: Axis::new(label, Scale::logarithmic(all().map(|p| p.x))),
        y: Axis::new("error of the reflectance (rms)", Scale::logarithmic(all().map(|p| p.y))),
        series,
        marks: Vec::new(),
    }
}

/// The line of slope -1/2 through the geometric mean of the errors, over the same range of effort.
fn slope(groups: &[Group], effort: fn(&Group) -> f64) -> Option<Series> {
    let logs: Vec<(f64, f64)> = groups
        .iter()
        .filter(|g| effort(g) > 0.0 && g.error > 0.0)
        .map(|g| (libm::log(effort(g)), libm::log(g.error)))
        .collect();
    let n = logs.len() as f64;
    let (x, y) = logs.iter().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let place = |at: f64| Point::new(libm::exp(at), libm::exp(y - 0.5 * (at - x)));
    let (first, last) = (logs.first()?.0, logs.last()?.0);
    (logs.len() > 1).then(|| Series { style: SLOPE, points: vec![place(first), place(last)] })
}
