//! The droplet size distribution (figure 3 of the paper).

use crate::chart::{Axis, Figure, Line, Mark, Panel, Point, Row, Scale, Series, Style, palette};
use stratiform_artifact::OpticsDocument;

/// Densities below this share of the largest one are not shown.
const VISIBLE: f64 = 1e-3;

pub fn figure(optics: &OpticsDocument) -> Figure {
    let density = &optics.size_density;
    let largest = density.number_per_cm3_um.iter().copied().fold(0.0, f64::max);
    let all = || density.radius_um.iter().zip(&density.number_per_cm3_um).map(|(r, n)| Point::new(*r, *n));
    let last_visible = all().filter(|p| p.y >= VISIBLE * largest).map(|p| p.x).fold(0.0, f64::max);
    let points: Vec<Point> = all().filter(|p| p.x <= last_visible).collect();
    let radii = points.iter().map(|p| p.x).chain([0.0, optics.effective_radius_um]);
    let panel = Panel {
        title: String::new(),
        x: Axis::new("droplet radius r (µm)", Scale::linear(radii)),
        y: Axis::new(
            "number density N(r) (cm^{−3} µm^{−1})",
            Scale::linear(points.iter().map(|p| p.y).chain([0.0])),
        ),
        series: vec![Series { style: Style::line(palette::BLUE, Line::Solid).with_width(2.0), points }],
        marks: vec![Mark {
            y: None,
            x: optics.effective_radius_um,
            label: format!("r_{{e}} = {} µm", optics.effective_radius_um),
        }],
    };
    Figure {
        name: "droplet-sizes".to_owned(),
        title: "Droplet size distribution".to_owned(),
        caption: format!(
            "Number of droplets per cubic centimetre and micrometre of radius: {}; {} droplets per cm^{{3}} in \
             all. The dotted line is the effective radius r_{{e}}.",
            optics.droplets, optics.number_density_per_cm3
        ),
        legend: Vec::new(),
        rows: vec![Row { height: 300.0, panels: vec![panel] }],
    }
}
