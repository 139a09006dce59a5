//! The phase functions (figure 4 of the paper), with the forward peak and the glory enlarged.

use crate::chart::{Axis, Figure, LegendEntry, Line, Mark, Panel, Point, Row, Scale, Series, Style, palette};
use crate::input::{Inputs, PhaseRow};

/// A phase function with its name and style.
struct Curve<'a> {
    label: String,
    style: Style,
    rows: &'a [PhaseRow],
}

pub fn figure(inputs: &Inputs) -> Figure {
    let curves = curves(inputs);
    let medium = &inputs.parameters.medium;
    let theta_f =
        Mark { x: medium.theta_f_deg, y: None, label: format!("θ_{{f}} = {}°", medium.theta_f_deg) };
    let whole = panel(&curves, "All scattering angles", 0.0, 180.0, vec![theta_f.clone()]);
    let forward = panel(&curves, "Forward peak", 0.0, 10.0, vec![theta_f]);
    let backward = panel(&curves, "Cloudbow and glory", 135.0, 180.0, Vec::new());
    Figure {
        name: "phase-functions".to_owned(),
        title: "Phase functions".to_owned(),
        caption: "Phase function P of the droplet distribution at each wavelength (mean 1 over the sphere; \
                  Θ = 0 is forward). Light scattered by less than θ_{f} counts as unscattered in the modified \
                  medium."
            .to_owned()
            + if inputs.sphere.is_some() {
                " Grey: one droplet of 20 µm radius, whose ripples the distribution averages out."
            } else {
                ""
            },
        legend: curves.iter().map(|c| LegendEntry::new(c.label.clone(), c.style)).collect(),
        rows: vec![
            Row { height: 330.0, panels: vec![whole] },
            Row { height: 280.0, panels: vec![forward, backward] },
        ],
    }
}

/// The single droplet first, so that the others are drawn over it; then from red to blue.
fn curves(inputs: &Inputs) -> Vec<Curve<'_>> {
    let grey = Style::line(palette::GREY, Line::Solid).with_width(0.7);
    let sphere = inputs.sphere.iter().map(|rows| Curve {
        label: "one droplet of 20 µm".to_owned(),
        style: grey,
        rows,
    });
    let mut wavelengths: Vec<_> = inputs.optics.wavelengths.iter().zip(&inputs.phases).collect();
    wavelengths.sort_by(|(a, _), (b, _)| b.wavelength_um.total_cmp(&a.wavelength_um));
    let styles = [
        (palette::VERMILION, Line::Solid),
        (palette::GREEN, Line::Dashed),
        (palette::BLUE, Line::DashDot),
        (palette::BLACK, Line::Dotted),
    ];
    let coloured =
        wavelengths.into_iter().zip(styles.into_iter().cycle()).map(|((w, rows), (colour, line))| Curve {
            label: format!("{} µm", w.wavelength_um),
            style: Style::line(colour, line),
            rows,
        });
    sphere.chain(coloured).collect()
}

fn panel(curves: &[Curve], title: &str, from_deg: f64, to_deg: f64, marks: Vec<Mark>) -> Panel {
    let series: Vec<Series> = curves.iter().map(|c| cut(c, from_deg, to_deg)).collect();
    let values = series.iter().flat_map(|s| &s.points).map(|p| p.y);
    Panel {
        title: title.to_owned(),
        x: Axis::new("scattering angle Θ (degrees)", Scale::linear([from_deg, to_deg])),
        y: Axis::new("phase function P (mean 1)", Scale::logarithmic(values)),
        series,
        marks,
    }
}

fn cut(curve: &Curve, from_deg: f64, to_deg: f64) -> Series {
    let inside = |row: &&PhaseRow| (from_deg..=to_deg).contains(&row.theta_deg);
    let points = curve.rows.iter().filter(inside).map(|row| Point::new(row.theta_deg, row.p)).collect();
    Series { style: curve.style, points }
}
