//! Model minus reference per angle: root mean square and maximum over the thickness grid.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use crate::input::Inputs;
use stratiform_artifact::Misfit;

const FITTED_RMS: Style = Style::line(palette::BLUE, Line::Solid).with_marker(Marker::Circle);
const FITTED_MAX: Style = Style::line(palette::BLUE, Line::Dotted).with_marker(Marker::Triangle);
const PUBLISHED_RMS: Style = Style::line(palette::VERMILION, Line::Solid).with_marker(Marker::Square);
const PUBLISHED_MAX: Style = Style::line(palette::VERMILION, Line::Dotted).with_marker(Marker::Diamond);

/// An angle and its misfits.
type Angle<'a> = (f64, &'a [Misfit]);

pub fn figure(inputs: &Inputs) -> Figure {
    let rows = inputs.parameters.metres.rows.iter();
    let fitted: Vec<Angle> =
        rows.filter_map(|row| Some((row.theta_l_deg.degrees()?, row.misfit.as_slice()))).collect();
    let notes = inputs.notes.iter().flat_map(|notes| &notes.published_misfit);
    let published: Vec<Angle> = notes.map(|row| (row.theta_l_deg, row.misfit.as_slice())).collect();
    let mut legend =
        vec![LegendEntry::new("fitted, rms", FITTED_RMS), LegendEntry::new("fitted, maximum", FITTED_MAX)];
    if !published.is_empty() {
        legend.push(LegendEntry::new("published, rms", PUBLISHED_RMS));
        legend.push(LegendEntry::new("published, maximum", PUBLISHED_MAX));
    }
    let panels = vec![
        panel("Total transmittance T_{ms}", &fitted, &published, |quantity| quantity == "t_ms"),
        panel("Orders T_{1}, T_{2}, R_{1}, R_{2}", &fitted, &published, |quantity| quantity != "t_ms"),
    ];
    Figure {
        name: "misfit".to_owned(),
        title: "Misfit of the one-dimensional model".to_owned(),
        caption:
            "Model minus reference over the thickness grid, in units of the incident flux. Right: rms over, \
                  and maximum of, the four orders."
                .to_owned(),
        legend,
        rows: vec![Row { height: 320.0, panels }],
    }
}

fn panel(title: &str, fitted: &[Angle], published: &[Angle], wanted: fn(&str) -> bool) -> Panel {
    let series = vec![
        Series { style: PUBLISHED_MAX, points: points(published, wanted, largest) },
        Series { style: PUBLISHED_RMS, points: points(published, wanted, root_mean_square) },
        Series { style: FITTED_MAX, points: points(fitted, wanted, largest) },
        Series { style: FITTED_RMS, points: points(fitted, wanted, root_mean_square) },
    ];
    let all = || series.iter().flat_map(|s| &s.points);
    Panel {
        title: title.to_owned(),
        x: Axis::new("θ_{l} (degrees)", Scale::linear(all().map(|p| p.x).chain([0.0, 90.0])).with_step(30.0)),
        y: Axis::new("misfit (per incident flux)", Scale::logarithmic(all().map(|p| p.y))),
        series,
        marks: Vec::new(),
    }
}

fn points(angles: &[Angle], wanted: fn(&str) -> bool, reduce: fn(&[&Misfit]) -> f64) -> Vec<Point> {
    let of = |misfits: &[Misfit]| {
        let chosen: Vec<&Misfit> = misfits.iter().filter(|m| wanted(&m.quantity)).collect();
        (!chosen.is_empty()).then(|| reduce(&chosen))
    };
    angles.iter().filter_map(|(x, misfits)| Some(Point::new(*x, of(misfits)?))).collect()
}

fn root_mean_square(misfits: &[&Misfit]) -> f64 {
    (misfits.iter().fold(0.0, |sum, m| sum + m.rms * m.rms) / misfits.len() as f64).sqrt()
}

fn largest(misfits: &[&Misfit]) -> f64 {
    misfits.iter().fold(0.0, |largest, m| m.max.abs().max(largest))
}
