//! Parameters from solver and from photons: their differences in standard errors.

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use stratiform_artifact::{AgreementDocument, AgreementRow};

const LOOKS: [(&str, &str, &str, Marker); 5] = [
    ("b", "b", palette::BLUE, Marker::Circle),
    ("c", "c", palette::ORANGE, Marker::Square),
    ("kappa_c", "κ_{c}", palette::GREEN, Marker::Triangle),
    ("t", "t", palette::PURPLE, Marker::Diamond),
    ("r", "r", palette::VERMILION, Marker::Ring),
];
const LIMIT: Style = Style::line(palette::GREY, Line::Dashed);

pub fn figure(document: &AgreementDocument, rows: &[AgreementRow]) -> Figure {
    let mut legend: Vec<_> = LOOKS
        .iter()
        .map(|(_, name, colour, marker)| LegendEntry::new(*name, Style::points(colour, *marker)))
        .collect();
    legend.push(LegendEntry::new("threshold", LIMIT));
    let mut series: Vec<_> = [-1.0, 1.0]
        .map(|sign| {
            let ends = [-5.0, 95.0].map(|x| Point::new(x, sign * document.threshold));
            Series { style: LIMIT, points: ends.to_vec() }
        })
        .to_vec();
    series.extend(LOOKS.iter().map(|(parameter, _, colour, marker)| {
        let of = rows.iter().filter(|row| row.parameter == *parameter);
        let point = |row: &AgreementRow| Some(Point::new(row.theta_l_deg.parse().ok()?, row.z?));
        Series { style: Style::points(colour, *marker), points: of.filter_map(point).collect() }
    }));
    let sizes = series.iter().flat_map(|s| &s.points).map(|p| p.y.clamp(-20.0, 20.0));
    let y = Axis::new("difference (standard errors)", Scale::linear(sizes.collect::<Vec<_>>()));
    let panel = Panel {
        title: String::new(),
        x: Axis::new("θ_{l} (degrees)", Scale::linear([0.0, 90.0]).with_step(10.0)),
        y,
        series,
        marks: Vec::new(),
    };
    Figure {
        name: "agreement".to_owned(),
        title: "Solver and photons: the fitted parameters".to_owned(),
        caption: "Parameter fitted to solved fluxes minus the same fitted to photons, in errors of the difference. β and \
                  the row of diffuse light are in the table."
            .to_owned(),
        legend,
        rows: vec![Row { height: 280.0, panels: vec![panel] }],
    }
}
