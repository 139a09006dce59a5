//! Error of estimators against photons and against seconds, a row of panels for each quantity; the slope -1/2 that
//! independent histories give.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::EstimatorErrorRow;

const STYLES: [(&str, Line, Marker); 6] = [
    (palette::BLACK, Line::Solid, Marker::Circle),
    (palette::BLUE, Line::Solid, Marker::Ring),
    (palette::VERMILION, Line::Dashed, Marker::Square),
    (palette::GREEN, Line::Dotted, Marker::Triangle),
    (palette::PURPLE, Line::DashDot, Marker::Diamond),
    (palette::ORANGE, Line::Dashed, Marker::Cross),
];
const SLOPE: Style = Style::line(palette::GREY, Line::Solid).with_width(1.0);

/// Draws `rows` in the order in which estimators and quantities first stand in them: file name and SVG.
pub fn draw(rows: &[EstimatorErrorRow]) -> (String, String) {
    let figure = figure(rows);
    (format!("{}.svg", figure.name), figure.to_svg())
}

fn figure(rows: &[EstimatorErrorRow]) -> Figure {
    let names = distinct(rows.iter().map(|row| row.estimator.as_str()));
    let styles: Vec<(&str, Style)> = names
        .into_iter()
        .zip(STYLES.into_iter().cycle())
        .map(|(name, (colour, line, marker))| (name, Style::line(colour, line).with_marker(marker)))
        .collect();
    let quantities = distinct(rows.iter().map(|row| (row.quantity.as_str(), row.tau, row.mu0)));
    let panels = quantities.into_iter().map(|(quantity, tau, mu0)| {
        let of = |row: &&EstimatorErrorRow| (row.quantity.as_str(), row.tau, row.mu0) == (quantity, tau, mu0);
        let rows: Vec<&EstimatorErrorRow> = rows.iter().filter(of).collect();
        let title = format!("{}, τ = {tau}, μ_{{0}} = {mu0}", subscript(quantity));
        Row {
            height: 330.0,
            panels: vec![
                panel(&title, "photons", &rows, &styles, |row| row.photons as f64),
                panel("the same against time", "seconds of a run", &rows, &styles, |row| row.seconds),
            ],
        }
    });
    let slope = LegendEntry::new("slope −1/2", SLOPE);
    Figure {
        name: "estimators".to_owned(),
        title: "Error of estimators against photons and against time".to_owned(),
        caption: "Root mean square over runs of the difference from the solver.".to_owned(),
        rows: panels.collect(),
        legend: styles.iter().map(|(name, style)| LegendEntry::new(*name, *style)).chain([slope]).collect(),
    }
}

fn distinct<T: PartialEq>(all: impl Iterator<Item = T>) -> Vec<T> {
    all.fold(Vec::new(), |mut seen, one| {
        if !seen.contains(&one) {
            seen.push(one);
        }
        seen
    })
}

/// R1 as R with a lowered 1.
fn subscript(quantity: &str) -> String {
    match quantity.char_indices().nth(1) {
        Some((at, _)) => format!("{}_{{{}}}", &quantity[..at], &quantity[at..]),
        None => quantity.to_owned(),
    }
}

fn panel(
    title: &str,
    label: &str,
    rows: &[&EstimatorErrorRow],
    styles: &[(&str, Style)],
    effort: fn(&EstimatorErrorRow) -> f64,
) -> Panel {
    let curves = styles.iter().map(|(name, style)| {
        let points = rows.iter().filter(|row| row.estimator == *name);
        Series { style: *style, points: points.map(|row| Point::new(effort(row), row.error)).collect() }
    });
    let curves: Vec<Series> = curves.collect();
    let series: Vec<Series> =
        curves.first().and_then(slope).into_iter().chain(curves.iter().cloned()).collect();
    let all = || series.iter().flat_map(|series| &series.points);
    let (x, y) = (Scale::logarithmic(all().map(|p| p.x)), Scale::logarithmic(all().map(|p| p.y)));
    Panel {
        title: title.to_owned(),
        x: Axis::new(label, x),
        y: Axis::new("rms error of the reflectance", y),
        series,
        marks: Vec::new(),
    }
}

/// Slope -1/2 from a curve's first point to the effort of its last, beside the data, at 2.5 times the error.
fn slope(curve: &Series) -> Option<Series> {
    let (first, last) = (curve.points.first()?, curve.points.last()?);
    let fall = (first.x / last.x).sqrt();
    let points = vec![Point::new(first.x, 2.5 * first.y), Point::new(last.x, 2.5 * first.y * fall)];
    Some(Series { style: SLOPE, points })
}
