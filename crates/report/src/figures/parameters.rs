//! The fitted parameters over the angle of incidence, beside the published ones.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use crate::input::Inputs;
use stratiform_artifact::{FittedParameter, ParameterRow, PublishedRow};

type Fitted = fn(&ParameterRow) -> &FittedParameter;
type Published = fn(&PublishedRow) -> f64;

const FITTED: Style = Style::line(palette::BLUE, Line::Solid).with_marker(Marker::Circle);
const EMITTED: Style = Style::points(palette::BLUE, Marker::Ring);
const PUBLISHED: Style = Style::line(palette::VERMILION, Line::Dashed).with_marker(Marker::Square);

pub fn figure(inputs: &Inputs) -> Figure {
    let panel = |label: &str, fitted: Fitted, published: Published| panel(inputs, label, fitted, published);
    let dimensionless = vec![
        panel("b (no unit)", |row| &row.b, |row| row.b),
        panel("t (no unit)", |row| &row.t, |row| row.t),
        panel("r (no unit)", |row| &row.r, |row| row.r),
    ];
    let per_metre = vec![
        panel("c (1/m)", |row| &row.c, |row| row.c_per_m),
        panel("κ_{c} (1/m)", |row| &row.kappa_c, |row| row.kappa_c_per_m),
    ];
    let mut legend = vec![LegendEntry::new("fitted ± 1 standard error", FITTED)];
    if inputs.parameters.metres.rows.iter().any(|row| parameters(row).iter().any(|p| p.value.is_none())) {
        legend.push(LegendEntry::new("not determined by the data: value emitted", EMITTED));
    }
    if inputs.published.is_some() {
        legend.push(LegendEntry::new("published", PUBLISHED));
    }
    Figure {
        name: "parameters".to_owned(),
        title: "Parameters of the one-dimensional model".to_owned(),
        caption:
            "Parameters over the angle of incidence θ_{l}. Error bars are propagated from the reference's \
                  covariance; most are smaller than the dots."
                .to_owned(),
        legend,
        rows: vec![Row { height: 250.0, panels: dimensionless }, Row { height: 250.0, panels: per_metre }],
    }
}

fn parameters(row: &ParameterRow) -> [&FittedParameter; 5] {
    [&row.b, &row.c, &row.kappa_c, &row.t, &row.r]
}

fn panel(inputs: &Inputs, label: &str, fitted: Fitted, published: Published) -> Panel {
    let rows = || {
        let rows = inputs.parameters.metres.rows.iter();
        rows.filter_map(|row| Some((row.theta_l_deg.degrees()?, fitted(row))))
    };
    let determined = rows().filter_map(|(x, parameter)| {
        Some(Point { x, y: parameter.value?, error: parameter.std_error.unwrap_or(0.0) })
    });
    let emitted = rows().filter(|(_, p)| p.value.is_none()).map(|(x, p)| Point::new(x, p.emitted));
    let known = inputs.published.iter().flatten().map(|row| Point::new(row.theta_l_deg, published(row)));
    let series = vec![
        Series { style: PUBLISHED, points: known.collect() },
        Series { style: FITTED, points: determined.collect() },
        Series { style: EMITTED, points: emitted.collect() },
    ];
    let points = || series.iter().flat_map(|s| &s.points);
    // Parameters per metre span decades.
    let tops = points().map(|p| p.y + p.error.min(p.y.abs()));
    let spans_decades = label.ends_with("(1/m)") && points().all(|p| p.y > 0.0);
    let scale = if spans_decades {
        Scale::logarithmic(tops.chain(points().map(|p| p.y)))
    } else {
        Scale::linear(tops.chain([0.0]))
    };
    Panel {
        title: String::new(),
        x: Axis::new(
            "θ_{l} (degrees)",
            Scale::linear(points().map(|p| p.x).chain([0.0, 90.0])).with_step(30.0),
        ),
        y: Axis::new(label, scale),
        series,
        marks: Vec::new(),
    }
}
