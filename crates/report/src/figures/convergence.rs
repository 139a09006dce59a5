//! Error of tracers and solver against time, photons and streams; the slope -1/2 that independent samples give.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Mark, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::ConvergenceRow;

/// The runs of one estimator with one number of photons or streams.
struct Group {
    photons: f64,
    /// Mean over the rows.
    seconds: f64,
    /// Root mean square over the rows.
    error: f64,
    /// Root mean square over the rows.
    std_error: f64,
}

/// An estimator's points and its place among the looks.
struct Curve<'a> {
    name: &'a str,
    groups: Vec<Group>,
    look: (&'static str, Marker, Line),
}

/// The estimator whose `photons` are streams.
const SOLVER: &str = "solver";

const LOOKS: [(&str, Marker, Line); 4] = [
    (palette::VERMILION, Marker::Square, Line::Dashed),
    (palette::BLUE, Marker::Ring, Line::Dotted),
    (palette::GREEN, Marker::Triangle, Line::Solid),
    (palette::PURPLE, Marker::Cross, Line::Solid),
];
const SLOPE: Style = Style::line(palette::GREY, Line::DashDot).with_width(1.2);

pub fn figure(rows: &[ConvergenceRow]) -> Figure {
    let mut names: Vec<&str> = rows.iter().map(|row| row.estimator.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let curves: Vec<Curve> = names
        .iter()
        .zip(LOOKS.into_iter().cycle())
        .map(|(name, look)| Curve { name, groups: groups(rows, name), look })
        .collect();
    let mut legend = Vec::new();
    for Curve { name, look: (colour, marker, line), .. } in &curves {
        let claimed = if *name == SOLVER { "change from fewer streams" } else { "standard error" };
        legend.push(LegendEntry::new(format!("{name}: error"), Style::points(colour, *marker)));
        legend.push(LegendEntry::new(format!("{name}: {claimed}"), Style::line(colour, *line)));
    }
    legend.push(LegendEntry::new("slope −1/2", SLOPE));
    let (solver, tracers): (Vec<&Curve>, Vec<&Curve>) = curves.iter().partition(|curve| curve.name == SOLVER);
    let all: Vec<&Curve> = curves.iter().collect();
    let time = panel("Against time", "wall time (s)", &all, |group| group.seconds);
    let named = Panel { marks: curves.iter().flat_map(names_of_points).collect(), ..time };
    let photons = panel("Against photons", "photons traced (histories)", &tracers, |group| group.photons);
    let streams = panel("Against streams", "streams per hemisphere (number)", &solver, |group| group.photons);
    Figure {
        name: "convergence".to_owned(),
        title: "Accuracy of tracers and solver against time".to_owned(),
        caption: "Root mean square, over the angles, thicknesses and orders of convergence.csv, of the error of the \
                  reflectance (difference from the solver with 96 streams per hemisphere), and of the error that the \
                  runs show themselves. Numbers beside points: photons traced, or streams per hemisphere. Time to \
                  prepare the medium is not counted for any. The thicknesses of one half-space run share their photons, \
                  so its points scatter together."
            .to_owned(),
        legend,
        rows: vec![
            Row { height: 420.0, panels: vec![named] },
            Row { height: 300.0, panels: vec![photons, streams] },
        ],
    }
}

/// Photons or streams, at every point of the curve against time.
fn names_of_points(curve: &Curve) -> Vec<Mark> {
    let name = |group: &Group| {
        if curve.name == SOLVER { format!("{}", group.photons) } else { power(group.photons) }
    };
    let mut marks: Vec<Mark> = Vec::new();
    for group in &curve.groups {
        match marks.last_mut() {
            // Names of points that took about as long would lie over each other.
            Some(last) if (group.seconds / last.x - 1.0).abs() < 0.2 => {
                last.label = format!("{}, {}", last.label, name(group));
            }
            _ => marks.push(Mark { x: group.seconds, y: Some(group.error), label: name(group) }),
        }
    }
    marks
}

/// 30000 as 3·10⁴.
fn power(count: f64) -> String {
    let exponent = libm::floor(libm::log10(count.max(1.0)) + 1e-9);
    let factor = libm::round(10.0 * count / libm::pow(10.0, exponent)) / 10.0;
    if factor == 1.0 { format!("10^{{{exponent}}}") } else { format!("{factor}·10^{{{exponent}}}") }
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

fn panel(title: &str, label: &str, curves: &[&Curve], effort: fn(&Group) -> f64) -> Panel {
    let mut series = Vec::new();
    for Curve { name, groups, look: (colour, marker, line) } in curves {
        let points = |of: fn(&Group) -> f64| groups.iter().map(|g| Point::new(effort(g), of(g))).collect();
        series.extend(slope(groups, effort).filter(|_| *name != SOLVER));
        series.push(Series { style: Style::line(colour, *line), points: points(|g| g.std_error) });
        series.push(Series { style: Style::points(colour, *marker), points: points(|g| g.error) });
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
