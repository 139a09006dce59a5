//! One scene: error against cost, a panel for each quantity, the front drawn.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Mark, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::{ChartRow, ChartScene};

/// Class in files, in the legend, style.
pub const CLASSES: [(&str, &str, &str, Marker); 7] = [
    ("single-scattering", "single scattering", palette::ORANGE, Marker::Triangle),
    ("diffusion", "diffusion", palette::GREEN, Marker::Diamond),
    ("path-tracing", "path tracing", palette::GREY, Marker::Square),
    ("path-integration", "path integration", palette::PURPLE, Marker::Square),
    ("mixed", "mixed", palette::BLUE, Marker::Circle),
    ("heuristic", "heuristic", palette::VERMILION, Marker::Cross),
    ("deterministic", "deterministic", palette::BLACK, Marker::Ring),
];

/// Quantity in files, heading.
pub const QUANTITIES: [(&str, &str); 4] = [
    ("radiance_top", "Radiance above"),
    ("radiance_bottom", "Radiance below"),
    ("reflectance", "Reflectance"),
    ("transmittance", "Transmittance"),
];

/// Below this, errors are drawn at it: a log axis has no zero.
const SMALLEST: f64 = 1e-7;

/// The figure of a scene.
pub fn figure(scene: &ChartScene, rows: &[ChartRow]) -> Figure {
    let rows: Vec<&ChartRow> = rows.iter().filter(|row| row.scene == scene.name).collect();
    let panels: Vec<(bool, Panel)> = QUANTITIES
        .iter()
        .filter_map(|(quantity, title)| {
            let there: Vec<&ChartRow> =
                rows.iter().copied().filter(|row| row.quantity == *quantity).collect();
            (!there.is_empty()).then(|| (quantity.starts_with("radiance"), panel(title, &there)))
        })
        .collect();
    let classes = CLASSES.iter().filter(|class| rows.iter().any(|row| row.class == class.0));
    let mut legend: Vec<LegendEntry> = classes
        .map(|(_, title, colour, marker)| LegendEntry::new(*title, Style::points(colour, *marker)))
        .collect();
    legend.push(LegendEntry::new("front", FRONT));
    Figure {
        name: format!("chart-{}", scene.name),
        title: format!("{}: error against cost", scene.title),
        caption: "Median of the relative error against the solver, and time of one evaluation on one thread."
            .to_owned(),
        legend,
        rows: layout(panels),
    }
}

/// The radiances of shader code alone, with room for names.
pub fn shaders(scene: &ChartScene, rows: &[ChartRow]) -> Option<Figure> {
    let shaders: Vec<ChartRow> = rows
        .iter()
        .filter(|row| row.cost == "f32" && row.quantity.starts_with("radiance"))
        .cloned()
        .collect();
    let drawn = figure(scene, &shaders);
    (!drawn.rows.is_empty()).then(|| Figure {
        name: format!("shaders-{}", scene.name),
        title: format!("{}: methods for shaders", scene.title),
        ..drawn
    })
}

/// Radiances, which most methods give, have a row each; fluxes share one.
fn layout(panels: Vec<(bool, Panel)>) -> Vec<Row> {
    let (radiances, fluxes): (Vec<_>, Vec<_>) = panels.into_iter().partition(|(radiance, _)| *radiance);
    let mut rows: Vec<Row> =
        radiances.into_iter().map(|(_, panel)| Row { height: 400.0, panels: vec![panel] }).collect();
    if !fluxes.is_empty() {
        rows.push(Row { height: 320.0, panels: fluxes.into_iter().map(|(_, panel)| panel).collect() });
    }
    rows
}

/// A logarithmic axis over at least a factor of four, so that it has a label.
pub fn logarithmic(values: impl Iterator<Item = f64> + Clone) -> Scale {
    let most = values.clone().fold(0.0, f64::max);
    let least = values.clone().filter(|value| *value > 0.0).fold(most, f64::min);
    let wider = if most < 4.0 * least { vec![0.5 * least, 2.0 * most] } else { Vec::new() };
    Scale::logarithmic(values.chain(wider))
}

const FRONT: Style = Style::line(palette::BLACK, Line::Dotted);

fn panel(title: &str, rows: &[&ChartRow]) -> Panel {
    let placed: Vec<(&ChartRow, f64, f64)> = rows
        .iter()
        .filter_map(|row| Some((*row, row.ns_per_evaluation?, row.median?.max(SMALLEST))))
        .collect();
    let mut line: Vec<Point> =
        placed.iter().filter(|(row, ..)| row.pareto).map(|(_, ns, error)| Point::new(*ns, *error)).collect();
    line.sort_by(|a, b| a.x.total_cmp(&b.x));
    let mut series = vec![Series { style: FRONT, points: line }];
    for (class, _, colour, marker) in CLASSES {
        let points = placed.iter().filter(|(row, ..)| row.class == class);
        let points = points.map(|(_, ns, error)| Point::new(*ns, *error)).collect();
        series.push(Series { style: Style::points(colour, marker), points });
    }
    let (front, others): (Vec<_>, Vec<_>) = placed.iter().partition(|(row, ..)| row.pareto);
    let mark = |(row, ns, error): &(&ChartRow, f64, f64)| {
        let refusals = if row.refused > 0 { "*" } else { "" };
        Mark { x: *ns, y: Some(*error), label: format!("{}{refusals}", row.method) }
    };
    Panel {
        title: title.to_owned(),
        x: Axis::new("time of one evaluation (ns)", logarithmic(placed.iter().map(|p| p.1))),
        y: Axis::new("median relative error (1)", logarithmic(placed.iter().map(|p| p.2))),
        // Names on the front get the best places.
        marks: front.into_iter().chain(others).map(mark).collect(),
        series,
    }
}
