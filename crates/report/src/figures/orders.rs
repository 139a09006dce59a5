//! Transmittance and reflectance per scattering order over the thickness (figure 8 of the paper).

use crate::chart::{
    Axis, Figure, LegendEntry, Line, Marker, Panel, Point, Row, Scale, Series, Style, palette,
};
use crate::input::Inputs;
use stratiform_artifact::{CurveModel, CurveQuantity, CurvesRow, OrdersRow};
use stratiform_quantities::Medium;

const TRANSMITTED: [CurveQuantity; 5] =
    [CurveQuantity::TMs, CurveQuantity::T0, CurveQuantity::T1, CurveQuantity::T2, CurveQuantity::T3Plus];
const REFLECTED: [CurveQuantity; 4] =
    [CurveQuantity::RMs, CurveQuantity::R1, CurveQuantity::R2, CurveQuantity::R3Plus];

/// The angles shown, where the table has them.
const WANTED_DEG: [f64; 4] = [0.0, 40.0, 70.0, 80.0];

/// The wanted angles that the table has; the first four it has, if it has none of these.
pub fn chosen_angles(orders: &[OrdersRow]) -> Vec<f64> {
    let mut present: Vec<f64> = orders.iter().filter_map(|row| row.theta_l_deg.parse().ok()).collect();
    present.sort_by(f64::total_cmp);
    present.dedup();
    let wanted: Vec<f64> = WANTED_DEG.into_iter().filter(|w| present.contains(w)).collect();
    if wanted.is_empty() { present.into_iter().take(4).collect() } else { wanted }
}

pub fn figure(inputs: &Inputs, theta_deg: f64) -> Figure {
    let orders: Vec<&OrdersRow> =
        inputs.orders.iter().filter(|row| row.theta_l_deg.parse() == Ok(theta_deg)).collect();
    let curves: Vec<&CurvesRow> =
        inputs.curves.iter().flatten().filter(|row| row.theta_l_deg == theta_deg).collect();
    let transmitted = panel("Transmitted", "transmittance T", &TRANSMITTED, &orders, &curves);
    let reflected = panel("Reflected", "reflectance R", &REFLECTED, &orders, &curves);
    Figure {
        name: format!("orders-theta-{theta_deg}"),
        title: format!("Scattering orders at θ_{{l}} = {theta_deg}°"),
        caption: format!(
            "Flux per incident flux at θ_{{l}} = {theta_deg}° over the slab's thickness H, split by the number \
             of wide scattering events. The totals (ms) belong to the full medium, the orders to the modified \
             one."
        ),
        legend: legend(&curves, inputs.parameters.provenance.is_random()),
        rows: vec![Row { height: 360.0, panels: vec![transmitted, reflected] }],
    }
}

/// Colour, marker and name of the order that `quantity` counts.
fn look(quantity: CurveQuantity) -> (&'static str, Marker, &'static str) {
    match quantity {
        CurveQuantity::TMs | CurveQuantity::RMs => (palette::BLACK, Marker::Circle, "all orders (ms)"),
        CurveQuantity::T0 => (palette::BLUE, Marker::Square, "order 0"),
        CurveQuantity::T1 | CurveQuantity::R1 => (palette::ORANGE, Marker::Triangle, "order 1"),
        CurveQuantity::T2 | CurveQuantity::R2 => (palette::GREEN, Marker::Diamond, "order 2"),
        CurveQuantity::T3Plus | CurveQuantity::R3Plus => (palette::PURPLE, Marker::Cross, "3 and more (3+)"),
    }
}

fn line(model: CurveModel) -> (Line, &'static str) {
    match model {
        CurveModel::Fitted => (Line::Solid, "model, fitted"),
        CurveModel::Published => (Line::Dashed, "model, published parameters"),
    }
}

fn legend(curves: &[&CurvesRow], random: bool) -> Vec<LegendEntry> {
    let orders = TRANSMITTED.map(|quantity| {
        let (colour, marker, name) = look(quantity);
        LegendEntry::new(name, Style::points(colour, marker))
    });
    let models = [CurveModel::Fitted, CurveModel::Published].into_iter().filter_map(|model| {
        let (line, name) = line(model);
        let present = curves.iter().any(|row| row.model == model);
        present.then(|| LegendEntry::new(name, Style::line(palette::GREY, line)))
    });
    let reference = if random { "Monte Carlo ± 1 standard error" } else { "solver" };
    let dots = LegendEntry::new(reference, Style::points(palette::GREY, Marker::Circle));
    orders.into_iter().chain([dots]).chain(models).collect()
}

fn panel(
    title: &str,
    y_label: &str,
    quantities: &[CurveQuantity],
    orders: &[&OrdersRow],
    curves: &[&CurvesRow],
) -> Panel {
    let lines = quantities.iter().flat_map(|quantity| model_curves(*quantity, curves));
    let dots = quantities.iter().map(|quantity| {
        let (colour, marker, _) = look(*quantity);
        Series { style: Style::points(colour, marker), points: reference(*quantity, orders) }
    });
    let series: Vec<Series> = lines.chain(dots).collect();
    let points = || series.iter().flat_map(|s| &s.points);
    // A model far outside the physical range runs out of the frame instead of flattening the rest.
    let values = points().map(|p| p.y.clamp(-0.1, 1.1)).chain([0.0, 1.0]);
    Panel {
        title: title.to_owned(),
        x: Axis::new("thickness H (m)", Scale::logarithmic(points().map(|p| p.x))),
        y: Axis::new(&format!("{y_label} (per incident flux)"), Scale::linear(values)),
        series,
        marks: Vec::new(),
    }
}

fn model_curves(quantity: CurveQuantity, curves: &[&CurvesRow]) -> Vec<Series> {
    [CurveModel::Published, CurveModel::Fitted]
        .into_iter()
        .map(|model| {
            let wanted = |row: &&&CurvesRow| row.quantity == quantity && row.model == model;
            let points = curves.iter().filter(wanted).map(|row| Point::new(row.thickness_m, row.value));
            Series { style: Style::line(look(quantity).0, line(model).0), points: by_x(points.collect()) }
        })
        .collect()
}

fn by_x(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    points
}

/// The reference values of `quantity`. Orders from the third on are added up, their errors in quadrature.
fn reference(quantity: CurveQuantity, orders: &[&OrdersRow]) -> Vec<Point> {
    let (medium, order) = match quantity {
        CurveQuantity::TMs | CurveQuantity::RMs => (Medium::Full, "total"),
        CurveQuantity::T0 => (Medium::Modified, "0"),
        CurveQuantity::T1 | CurveQuantity::R1 => (Medium::Modified, "1"),
        CurveQuantity::T2 | CurveQuantity::R2 => (Medium::Modified, "2"),
        CurveQuantity::T3Plus | CurveQuantity::R3Plus => return three_and_more(quantity, orders),
    };
    let rows = orders.iter().filter(|row| row.medium == medium && row.order == order);
    by_x(rows.map(|row| point(quantity, row)).collect())
}

fn three_and_more(quantity: CurveQuantity, orders: &[&OrdersRow]) -> Vec<Point> {
    let modified = || orders.iter().filter(|row| row.medium == Medium::Modified);
    // Without order 2 of its own, the tail holds more than the orders wanted.
    let complete = modified().filter(|row| row.order == "2");
    let later = |row: &&&OrdersRow| row.order == "tail" || row.order.parse().is_ok_and(|n: u32| n > 2);
    by_x(
        complete
            .map(|second| {
                let parts = modified().filter(later).filter(|row| row.thickness_m == second.thickness_m);
                let (y, square) = parts
                    .map(|row| point(quantity, row))
                    .fold((0.0, 0.0), |(y, square), p| (y + p.y, square + p.error * p.error));
                Point { x: second.thickness_m, y, error: square.sqrt() }
            })
            .collect(),
    )
}

fn point(quantity: CurveQuantity, row: &OrdersRow) -> Point {
    let (y, error) = if REFLECTED.contains(&quantity) {
        (row.reflectance, row.reflectance_std_error)
    } else {
        (row.transmittance, row.transmittance_std_error)
    };
    Point { x: row.thickness_m, y, error }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(theta: &str, order: &str, value: f64) -> OrdersRow {
        OrdersRow {
            theta_l_deg: theta.to_owned(),
            thickness_m: 10.0,
            medium: Medium::Modified,
            order: order.to_owned(),
            reflectance: value,
            reflectance_std_error: 3e-4,
            transmittance: 0.5 * value,
            transmittance_std_error: 4e-4,
        }
    }

    #[test]
    fn later_orders_are_added_up() {
        let rows = ["0", "1", "2", "3", "tail", "total"].map(|order| row("0", order, 0.1));
        let points = reference(CurveQuantity::R3Plus, &rows.iter().collect::<Vec<_>>());
        assert_eq!(points.len(), 1);
        assert!((points[0].y - 0.2).abs() < 1e-15 && (points[0].error - 3e-4 * 2f64.sqrt()).abs() < 1e-15);
        let rows = ["0", "1", "tail"].map(|order| row("0", order, 0.1));
        assert!(reference(CurveQuantity::T3Plus, &rows.iter().collect::<Vec<_>>()).is_empty());
    }

    #[test]
    fn angles_are_the_wanted_ones_or_the_first() {
        let table = |angles: &[&str]| angles.iter().map(|a| row(a, "0", 0.1)).collect::<Vec<_>>();
        assert_eq!(chosen_angles(&table(&["diffuse", "80", "0", "10", "70"])), [0.0, 70.0, 80.0]);
        assert_eq!(chosen_angles(&table(&["15", "5"])), [5.0, 15.0]);
        assert!(chosen_angles(&table(&["diffuse"])).is_empty());
    }
}
