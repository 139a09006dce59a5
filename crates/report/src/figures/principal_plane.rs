//! Reflectance per scattering order in the plane of the sun (figures 6 and 9 of the paper), polar and plain.

use crate::chart::{Axis, Figure, LegendEntry, Line, Mark, Panel, Point, Row, Scale, Series, Style, palette};
use stratiform_artifact::{PlaneOrder, PlaneSource, PrincipalPlaneRow};
use stratiform_quantities::Medium;

/// Colours of the orders from the first on; the last is that of the rest.
const COLOURS: [&str; 6] =
    [palette::BLUE, palette::ORANGE, palette::GREEN, palette::PURPLE, palette::VERMILION, palette::GREY];
const PHOTONS: Style = Style::line(palette::BLUE, Line::Solid);
const SOLVER: Style = Style::line(palette::BLACK, Line::Dotted);
const RADIANCE: Style = Style::line(palette::VERMILION, Line::Dashed);
const OTHER: Style = Style::line(palette::BLACK, Line::Dashed);

/// Where the fogbow is looked for, degrees from the glory.
const FOGBOW: std::ops::Range<f64> = 25.0..50.0;

/// Angle and thickness of a slab.
type Scene = (f64, f64);

/// The media of the first scene, and the model against photons in every scene.
pub fn figures(rows: &[PrincipalPlaneRow]) -> Vec<Figure> {
    let scenes = scenes(rows);
    let of = |scene: &Scene| Curves { rows, scene: *scene };
    let media = scenes.first().map(|scene| media(&of(scene)));
    let modelled: Vec<Curves> = scenes.iter().map(of).filter(|curves| !curves.model().is_empty()).collect();
    media.into_iter().chain((!modelled.is_empty()).then(|| model(&modelled))).collect()
}

/// Every scene once, in the order of the file.
fn scenes(rows: &[PrincipalPlaneRow]) -> Vec<Scene> {
    let mut scenes: Vec<Scene> = Vec::new();
    for scene in rows.iter().map(|row| (row.theta_l_deg, row.thickness_m)) {
        if !scenes.contains(&scene) {
            scenes.push(scene);
        }
    }
    scenes
}

fn name((theta, thickness): Scene) -> String {
    format!("H = {thickness} m, θ_{{l}} = {theta}°")
}

/// The curves of one scene.
#[derive(Clone, Copy)]
struct Curves<'a> {
    rows: &'a [PrincipalPlaneRow],
    scene: Scene,
}

impl Curves<'_> {
    /// One curve by angle.
    fn curve(&self, source: PlaneSource, medium: Medium, order: PlaneOrder) -> Vec<Point> {
        let wanted = self.rows.iter().filter(|row| {
            (row.theta_l_deg, row.thickness_m) == self.scene
                && (row.source, row.medium, row.order) == (source, medium, order)
        });
        let point = |row: &PrincipalPlaneRow| Point {
            x: row.theta_v_deg,
            y: row.value,
            error: row.std_error.unwrap_or(0.0),
        };
        let mut points: Vec<Point> = wanted.map(point).collect();
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        points
    }

    /// Single orders and the rest.
    fn orders(&self, source: PlaneSource, medium: Medium) -> Vec<(PlaneOrder, Vec<Point>)> {
        let mut orders: Vec<PlaneOrder> = Vec::new();
        for row in self.rows.iter().filter(|row| (row.source, row.medium) == (source, medium)) {
            if row.order != PlaneOrder::Total && !orders.contains(&row.order) {
                orders.push(row.order);
            }
        }
        orders.into_iter().map(|order| (order, self.curve(source, medium, order))).collect()
    }

    fn photons(&self, medium: Medium) -> Vec<(PlaneOrder, Vec<Point>)> {
        self.orders(PlaneSource::Mc, medium)
    }

    /// Empty where the model has no parameters.
    fn model(&self) -> Vec<Point> {
        self.curve(PlaneSource::Model, Medium::Modified, PlaneOrder::Total)
    }

    /// Empty where the config asks for no fitted radiance model.
    fn radiance(&self) -> Vec<Point> {
        self.curve(PlaneSource::Radiance, Medium::Full, PlaneOrder::Total)
    }

    /// All light: in the full medium, from photons.
    fn total(&self) -> Vec<Point> {
        self.curve(PlaneSource::Mc, Medium::Full, PlaneOrder::Total)
    }

    fn solver(&self) -> Series {
        let points = self.curve(PlaneSource::Solver, Medium::Full, PlaneOrder::Total);
        Series { style: SOLVER, points }
    }

    /// Glory, fogbow and pseudo-specular.
    fn marks(&self) -> Vec<Mark> {
        let glory = -self.scene.0;
        let once = self.curve(PlaneSource::Mc, Medium::Modified, PlaneOrder::Exactly(1));
        let bow = once.iter().filter(|p| FOGBOW.contains(&(p.x - glory))).max_by(|a, b| a.y.total_cmp(&b.y));
        let mark = |x: f64, label: &str| Mark { x, y: None, label: label.to_owned() };
        let fogbow = bow.map(|p| mark(p.x, "B"));
        [mark(glory, "A")].into_iter().chain(fogbow).chain([mark(-glory, "C")]).collect()
    }

    /// A little above the light at C: what grows beyond, towards the horizon, runs out of the frame.
    fn highest(&self) -> f64 {
        let solved = self.solver().points;
        let near = solved.iter().filter(|p| p.x <= self.scene.0);
        1.25 * near.fold(0.0, |most: f64, p| most.max(p.y))
    }

    /// Polar above, what a face sends out per solid angle; plain below, what an eye sees.
    fn panels(&self, title: &str, series: &[Series]) -> [Panel; 2] {
        let panel = |title: &str, x, label, y, series| Panel {
            title: title.to_owned(),
            x: Axis::new("view angle θ_{v} (degrees)", x),
            y: Axis::new(label, y),
            series,
            marks: self.marks(),
        };
        let sent: Vec<Series> = series.iter().map(projected).collect();
        let solved = projected(&self.solver()).points;
        let longest = 1.15 * solved.iter().fold(0.0, |most: f64, p| most.max(p.y));
        let circle = Scale::from_zero(longest);
        let plain = Scale::linear([-90.0, 90.0]).with_step(30.0);
        [
            panel(title, Scale::half_circle(), "μ_{v} πL/(μ_{l}F_{0}) (1)", circle, sent),
            panel("", plain, "πL/(μ_{l}F_{0}) (1)", Scale::from_zero(self.highest()), series.to_vec()),
        ]
    }
}

/// The same times μ_v.
fn projected(series: &Series) -> Series {
    let point = |p: &Point| {
        let mu = libm::cos(p.x.to_radians());
        Point { y: mu * p.y, error: mu * p.error, ..*p }
    };
    Series { points: series.points.iter().map(point).collect(), ..series.clone() }
}

fn colour(order: PlaneOrder) -> &'static str {
    match order {
        PlaneOrder::Exactly(n) if (1..=5).contains(&n) => COLOURS[n as usize - 1],
        _ => COLOURS[5],
    }
}

/// Orders one on the other, as areas.
fn stacked(orders: &[(PlaneOrder, Vec<Point>)]) -> Vec<Series> {
    let mut floor: Vec<Point> = Vec::new();
    let mut areas = Vec::new();
    for (order, points) in orders {
        let ceiling = added(&floor, points);
        let below: Vec<Point> =
            if floor.is_empty() { points.iter().map(|p| Point::new(p.x, 0.0)).collect() } else { floor };
        let round = ceiling.iter().chain(below.iter().rev()).map(|p| Point::new(p.x, p.y)).collect();
        areas.push(Series { style: Style::filled(colour(*order)), points: round });
        floor = ceiling;
    }
    areas
}

/// Two curves over the same angles added up; an empty one adds nothing.
fn added(a: &[Point], b: &[Point]) -> Vec<Point> {
    if a.is_empty() {
        return b.iter().map(|p| Point::new(p.x, p.y)).collect();
    }
    a.iter().zip(b).map(|(a, b)| Point::new(a.x, a.y + b.y)).collect()
}

/// The sum of the first `count` orders.
fn first(orders: &[(PlaneOrder, Vec<Point>)], count: u32) -> Vec<Point> {
    let low = orders.iter().filter(|(order, _)| matches!(order, PlaneOrder::Exactly(n) if *n <= count));
    low.fold(Vec::new(), |sum, (_, points)| added(&sum, points))
}

/// One standard error to either side.
fn band(points: &[Point], style: Style) -> Series {
    let upper = points.iter().map(|p| Point::new(p.x, p.y + p.error));
    let lower = points.iter().rev().map(|p| Point::new(p.x, (p.y - p.error).max(0.0)));
    Series { style: Style::filled(style.colour), points: upper.chain(lower).collect() }
}

fn entries(orders: &[(PlaneOrder, Vec<Point>)]) -> Vec<LegendEntry> {
    let entry = |(order, _): &(PlaneOrder, Vec<Point>)| {
        LegendEntry::new(format!("order {order}"), Style::filled(colour(*order)))
    };
    orders.iter().map(entry).collect()
}

fn rows(columns: Vec<[Panel; 2]>) -> Vec<Row> {
    let (polar, plain) = columns.into_iter().map(|[polar, plain]| (polar, plain)).unzip();
    vec![Row { height: 240.0, panels: polar }, Row { height: 270.0, panels: plain }]
}

const WHERE: &str = "θ_{v} > 0: leaving light keeps the sun's azimuth; θ_{v} < 0: the sun's side. A: glory (θ_{v} = −θ_{l}). B: fogbow. C: \
                     pseudo-specular (θ_{v} = θ_{l}). Polar: times μ_{v}, the light sent out per solid angle. Plain: the reflectance factor, π times the BRDF; its rise \
                     towards the horizon runs out of the frame.";

/// Figure 6.
fn media(curves: &Curves) -> Figure {
    let [full, modified] = [Medium::Full, Medium::Modified].map(|medium| curves.photons(medium));
    let panel = |title: &str, own: &[(PlaneOrder, Vec<Point>)], other: Vec<Point>| {
        let mut series = stacked(own);
        series.push(Series { style: OTHER, points: other });
        series.push(curves.solver());
        curves.panels(title, &series)
    };
    let mut legend = entries(&modified);
    legend.push(LegendEntry::new("full 1–5 (left), modified 1+2 (right)", OTHER));
    legend.push(LegendEntry::new("solver, full medium", SOLVER));
    Figure {
        name: "plane-media".to_owned(),
        title: format!("Reflectance in the plane of the sun: {}", name(curves.scene)),
        caption: format!(
            "Photons in the modified and in the full medium by order of scattering, one on the other (figure 6 of the paper). \
             Dashed: orders 1 and 2 of the modified medium do the work of the first five of the full one. {WHERE} \
             In the full medium, orders from 2 on are means over bins of 4° by about 12°, which flatten the glory; the dotted line \
             has no bins."
        ),
        legend,
        rows: rows(vec![
            panel("Modified medium", &modified, first(&full, 5)),
            panel("Full medium", &full, first(&modified, 2)),
        ]),
    }
}

/// Figure 9.
fn model(scenes: &[Curves]) -> Figure {
    let panel = |curves: &Curves| {
        let mut series = stacked(&curves.orders(PlaneSource::Model, Medium::Modified));
        let total = curves.total();
        series.push(band(&total, PHOTONS));
        series.push(Series { style: PHOTONS, points: total.iter().map(|p| Point::new(p.x, p.y)).collect() });
        series.push(curves.solver());
        series.push(Series { style: RADIANCE, points: curves.radiance() });
        curves.panels(&name(curves.scene), &series)
    };
    let orders = scenes.first().map(|c| c.orders(PlaneSource::Model, Medium::Modified)).unwrap_or_default();
    let mut legend: Vec<LegendEntry> = entries(&orders)
        .into_iter()
        .map(|entry| LegendEntry::new(format!("model, {}", entry.label), entry.style))
        .collect();
    legend.push(LegendEntry::new("photons ± 1 standard error", PHOTONS));
    legend.push(LegendEntry::new("solver", SOLVER));
    if scenes.iter().any(|curves| !curves.radiance().is_empty()) {
        legend.push(LegendEntry::new("fitted radiance", RADIANCE));
    }
    Figure {
        name: "plane-model".to_owned(),
        title: "The angular model against photons, in the plane of the sun".to_owned(),
        caption: format!(
            "Areas: orders of the corrected model with the fitted parameters, one on the other; I_{{3+}} is spread isotropically, \
             as in the paper (figure 9). Line: all scattered light of the full medium, from photons. Dashed: the fitted radiance model. {WHERE}"
        ),
        legend,
        rows: rows(scenes.iter().map(panel).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(theta_v_deg: f64, order: PlaneOrder, value: f64) -> PrincipalPlaneRow {
        let (theta_l_deg, thickness_m) = (70.0, 100.0);
        let (medium, source, std_error) = (Medium::Modified, PlaneSource::Mc, Some(0.1));
        PrincipalPlaneRow { medium, theta_l_deg, thickness_m, theta_v_deg, order, value, std_error, source }
    }

    #[test]
    fn orders_stand_one_on_the_other() {
        let rows: Vec<_> = [-1.0, 1.0]
            .into_iter()
            .flat_map(|x| [row(x, PlaneOrder::Exactly(1), 1.0), row(x, PlaneOrder::From(2), 2.0)])
            .collect();
        let curves = Curves { rows: &rows, scene: (70.0, 100.0) };
        let orders = curves.photons(Medium::Modified);
        let heights = |s: &Series| s.points.iter().map(|p| p.y).collect::<Vec<_>>();
        let areas = stacked(&orders);
        assert_eq!(
            areas.iter().map(heights).collect::<Vec<_>>(),
            [[1.0, 1.0, 0.0, 0.0], [3.0, 3.0, 1.0, 1.0]]
        );
        assert_eq!(first(&orders, 2).len(), 2);
    }

    #[test]
    fn the_fogbow_is_the_peak_beside_the_glory() {
        let rows: Vec<_> = (-45..=0)
            .map(|k| 2.0 * f64::from(k))
            .map(|x| {
                row(x, PlaneOrder::Exactly(1), 9.0 - (x + 32.0).abs() + if x < -66.0 { 100.0 } else { 0.0 })
            })
            .collect();
        let marks = Curves { rows: &rows, scene: (70.0, 100.0) }.marks();
        assert_eq!(marks.iter().map(|m| m.x).collect::<Vec<_>>(), [-70.0, -32.0, 70.0]);
    }
}
