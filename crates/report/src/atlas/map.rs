//! One method: a row of small maps for each plane, a column for each quantity and precision.

use super::input::Inputs;
use super::tint::{MEANINGS, cell, place};
use maud::{Markup, html};
use stratiform_artifact::{AtlasMethod, AtlasPlane, AtlasRow};

/// Quantities drawn together, the heading, and the precision.
const COLUMNS: [(&[&str], &str, &str); 6] = [
    (&["radiance_top"], "radiance above", "f64"),
    (&["radiance_top"], "radiance above", "f32"),
    (&["radiance_bottom"], "radiance below", "f64"),
    (&["radiance_bottom"], "radiance below", "f32"),
    (&["reflectance", "transmittance"], "fluxes", "f64"),
    (&["reflectance", "transmittance"], "fluxes", "f32"),
];

const LEFT: f64 = 96.0;
const WIDTH: f64 = 128.0;
const HEIGHT: f64 = 112.0;
const GAP: f64 = 10.0;
const BELOW: f64 = 42.0;
const TOP: f64 = 104.0;
const SMALL: f64 = 10.5;

/// A method's rows.
pub struct Map<'a> {
    method: &'a AtlasMethod,
    planes: &'a [AtlasPlane],
    rows: Vec<&'a AtlasRow>,
}

impl<'a> Map<'a> {
    /// The part of an atlas that is one method's.
    pub fn new(method: &'a AtlasMethod, inputs: &'a Inputs) -> Self {
        let rows = inputs.rows.iter().filter(|row| row.method == method.name).collect();
        Self { method, planes: &inputs.document.planes, rows }
    }

    /// File name without `.svg`.
    pub fn file(&self) -> String {
        self.method.name.replace(':', "-")
    }

    /// The method's name.
    pub fn name(&self) -> &str {
        &self.method.name
    }

    fn columns(&self) -> Vec<&'static (&'static [&'static str], &'static str, &'static str)> {
        let has = |(quantities, _, precision): &(&[&str], &str, &str)| {
            self.rows
                .iter()
                .any(|row| quantities.contains(&row.quantity.as_str()) && row.precision == *precision)
        };
        COLUMNS.iter().filter(|column| has(column)).collect()
    }

    /// The `svg` element.
    pub fn draw(&self) -> Markup {
        let columns = self.columns();
        let width = (LEFT + columns.len() as f64 * (WIDTH + GAP)).max(720.0);
        let height = TOP + self.planes.len() as f64 * (HEIGHT + BELOW);
        html! {
            svg xmlns="http://www.w3.org/2000/svg" width=(width) height=(height) role="img"
                viewBox=(format!("0 0 {width} {height}")) aria-label=(format!("Atlas of {}", self.method.name))
                font-family="Helvetica, Arial, 'DejaVu Sans', sans-serif" font-size=(SMALL) fill="#111" {
                rect width=(width) height=(height) fill="#fff" {}
                text x="8" y="19" font-size="15" font-weight="bold" { (self.method.name) ": " (self.method.title) }
                (legend())
                @for (i, column) in columns.iter().enumerate() {
                    text x=(LEFT + i as f64 * (WIDTH + GAP) + 0.5 * WIDTH) y=(TOP - 8.0) text-anchor="middle" font-size="12" {
                        (column.1) ", " (column.2)
                    }
                }
                @for (j, plane) in self.planes.iter().enumerate() {
                    @let y = TOP + j as f64 * (HEIGHT + BELOW);
                    @for (i, column) in columns.iter().enumerate() {
                        (self.panel(plane, column, LEFT + i as f64 * (WIDTH + GAP), y, i == 0))
                    }
                }
            }
        }
    }

    fn panel(
        &self,
        plane: &AtlasPlane,
        (quantities, _, precision): &(&[&str], &str, &str),
        left: f64,
        top: f64,
        first: bool,
    ) -> Markup {
        let of = |row: &&&AtlasRow| {
            row.plane == plane.name
                && row.precision == *precision
                && quantities.contains(&row.quantity.as_str())
        };
        let rows: Vec<&AtlasRow> = self.rows.iter().filter(of).copied().collect();
        let (xs, ys) = (sorted(rows.iter().map(|row| row.x)), sorted(rows.iter().map(|row| row.y)));
        if rows.is_empty() {
            return html! {};
        }
        let (w, h) = (WIDTH / xs.len() as f64, HEIGHT / ys.len() as f64);
        let worst = |x: f64, y: f64| {
            let here = rows.iter().filter(|row| row.x == x && row.y == y);
            here.map(|row| place(&row.class)).max()
        };
        html! {
            @for (j, y) in ys.iter().enumerate() {
                @for (i, x) in xs.iter().enumerate() {
                    @if let Some(place) = worst(*x, *y) {
                        (cell(place, [left + i as f64 * w, top + HEIGHT - (j + 1) as f64 * h, w, h]))
                    }
                }
            }
            rect x=(left) y=(top) width=(WIDTH) height=(HEIGHT) fill="none" stroke="#333" {}
            (across(&xs, left, top + HEIGHT, &plane.x_name))
            @if first { (up(&ys, left, top, &plane.y_name)) }
        }
    }

    /// The map as a file of its own.
    pub fn to_svg(&self) -> String {
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n", self.draw().into_string())
    }
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// Names of inputs for people.
fn symbol(name: &str) -> &str {
    match name {
        "tau" => "κH",
        "mu_l" => "μ_l",
        "mu_v" => "μ_v",
        "mu_v/mu_l-1" => "μ_v/μ_l − 1",
        "phi_deg" => "φ (°)",
        "r_eff_um" => "r_e (µm)",
        "theta_f_deg" => "θ_f (°)",
        "omega" => "ω",
        other => other,
    }
}

/// Every number that has room.
fn shown(count: usize, room: f64, each: f64) -> impl Iterator<Item = usize> {
    let every = (each * count as f64 / room).max(1.0) as usize;
    let every = if every as f64 * room / count as f64 >= each - 1e-9 { every } else { every + 1 };
    (0..count).filter(move |i| (count - 1 - i).is_multiple_of(every))
}

fn number(value: f64) -> String {
    let size = value.abs();
    let text = if size != 0.0 && !(1e-3..1e4).contains(&size) && (1.0 - size).abs() > 1e-3 {
        format!("{value:e}")
    } else {
        format!("{value}")
    };
    text.replace('-', "−")
}

fn across(values: &[f64], left: f64, bottom: f64, name: &str) -> Markup {
    let step = WIDTH / values.len() as f64;
    html! {
        @for i in shown(values.len(), WIDTH, 36.0) {
            text x=(format!("{:.1}", left + (i as f64 + 0.5) * step)) y=(bottom + 13.0) text-anchor="middle" { (number(values[i])) }
        }
        text x=(left + 0.5 * WIDTH) y=(bottom + 27.0) text-anchor="middle" font-size="12" { (symbol(name)) }
    }
}

fn up(values: &[f64], left: f64, top: f64, name: &str) -> Markup {
    let step = HEIGHT / values.len() as f64;
    html! {
        @for j in shown(values.len(), HEIGHT, 13.0) {
            text x=(left - 5.0) y=(format!("{:.1}", top + HEIGHT - (j as f64 + 0.5) * step + 3.8)) text-anchor="end" { (number(values[j])) }
        }
        text transform=(format!("translate({} {}) rotate(-90)", left - 66.0, top + 0.5 * HEIGHT)) text-anchor="middle" font-size="12" {
            (symbol(name))
        }
    }
}

/// All classes, in three columns.
fn legend() -> Markup {
    html! {
        @for (i, meaning) in MEANINGS.iter().enumerate() {
            @let (x, y) = (10.0 + 236.0 * (i % 3) as f64, 30.0 + 19.0 * (i / 3) as f64);
            (cell(i, [x, y, 24.0, 13.0]))
            rect x=(x) y=(y) width="24" height="13" fill="none" stroke="#333" stroke-width="0.5" {}
            text x=(x + 30.0) y=(y + 10.5) font-size="12" { (meaning) }
        }
    }
}
