//! The data sets as least-squares problems.

use std::collections::BTreeMap;
use stratiform_fit::least_squares::{LeastSquares, numerical_jacobian};
use stratiform_fit::{FitError, Matrix};

pub struct Dataset {
    pub name: String,
    pub level: String,
    pub starts: [Vec<f64>; 2],
    pub certified: Vec<f64>,
    pub certified_errors: Vec<f64>,
    y: Vec<f64>,
    x: Vec<[f64; 2]>,
}

fn rows(file: &str) -> Vec<Vec<String>> {
    stratiform_reference_data::rows("nist-strd", file).unwrap()
}

pub fn all() -> Vec<Dataset> {
    let mut sets: BTreeMap<String, Dataset> = BTreeMap::new();
    for row in rows("meta.csv") {
        let set = Dataset {
            name: row[0].clone(),
            level: row[1].clone(),
            starts: [vec![], vec![]],
            certified: vec![],
            certified_errors: vec![],
            y: vec![],
            x: vec![],
        };
        sets.insert(row[0].clone(), set);
    }
    let number = |text: &String| text.parse::<f64>().unwrap();
    for row in rows("certified.csv") {
        let set = sets.get_mut(&row[0]).unwrap();
        set.starts[0].push(number(&row[2]));
        set.starts[1].push(number(&row[3]));
        set.certified.push(number(&row[4]));
        set.certified_errors.push(number(&row[5]));
    }
    for row in rows("data.csv") {
        let set = sets.get_mut(&row[0]).unwrap();
        let y = number(&row[1]);
        set.y.push(if set.name == "Nelson" { libm::log(y) } else { y });
        set.x.push([number(&row[2]), if row[3].is_empty() { 0.0 } else { number(&row[3]) }]);
    }
    sets.into_values().collect()
}

/// Model minus observation.
pub struct Fit<'a>(pub &'a Dataset);

impl LeastSquares for Fit<'_> {
    fn residual_count(&self) -> usize {
        self.0.y.len()
    }

    fn residuals(&self, p: &[f64], out: &mut [f64]) -> Result<(), FitError> {
        let model = model(&self.0.name);
        for ((r, x), y) in out.iter_mut().zip(&self.0.x).zip(&self.0.y) {
            *r = model(p, *x) - y;
        }
        Ok(())
    }

    fn jacobian(&self, p: &[f64], out: &mut Matrix) -> Result<(), FitError> {
        numerical_jacobian(self, p, 0.0, out)
    }
}

fn exp_sum(b: &[f64], x: f64) -> f64 {
    b.chunks(2).map(|pair| pair[0] * libm::exp(-pair[1] * x)).sum()
}

fn gauss(b: &[f64], x: f64) -> f64 {
    let peak = |b: &[f64]| b[0] * libm::exp(-((x - b[1]) / b[2]) * ((x - b[1]) / b[2]));
    b[0] * libm::exp(-b[1] * x) + peak(&b[2..5]) + peak(&b[5..8])
}

fn cubic_ratio(b: &[f64], x: f64) -> f64 {
    (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1.0 + x * (b[4] + x * (b[5] + x * b[6])))
}

fn enso(b: &[f64], x: f64) -> f64 {
    use std::f64::consts::TAU;
    let wave =
        |period: f64, c: f64, s: f64| c * libm::cos(TAU * x / period) + s * libm::sin(TAU * x / period);
    b[0] + wave(12.0, b[1], b[2]) + wave(b[3], b[4], b[5]) + wave(b[6], b[7], b[8])
}

fn eckerle(b: &[f64], x: f64) -> f64 {
    let z = (x - b[2]) / b[1];
    b[0] / b[1] * libm::exp(-0.5 * z * z)
}

type Model = fn(&[f64], [f64; 2]) -> f64;

fn model(name: &str) -> Model {
    match name {
        "Bennett5" => |b, [x, _]| b[0] * libm::pow(b[1] + x, -1.0 / b[2]),
        "BoxBOD" | "Misra1a" => |b, [x, _]| -b[0] * libm::expm1(-b[1] * x),
        "Chwirut1" | "Chwirut2" => |b, [x, _]| libm::exp(-b[0] * x) / (b[1] + b[2] * x),
        "DanWood" => |b, [x, _]| b[0] * libm::pow(x, b[1]),
        "ENSO" => |b, [x, _]| enso(b, x),
        "Eckerle4" => |b, [x, _]| eckerle(b, x),
        "Gauss1" | "Gauss2" | "Gauss3" => |b, [x, _]| gauss(b, x),
        "Hahn1" | "Thurber" => |b, [x, _]| cubic_ratio(b, x),
        "Kirby2" => |b, [x, _]| (b[0] + x * (b[1] + x * b[2])) / (1.0 + x * (b[3] + x * b[4])),
        "Lanczos1" | "Lanczos2" | "Lanczos3" => |b, [x, _]| exp_sum(b, x),
        "MGH09" => |b, [x, _]| b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]),
        "MGH10" => |b, [x, _]| b[0] * libm::exp(b[1] / (x + b[2])),
        "MGH17" => |b, [x, _]| b[0] + b[1] * libm::exp(-x * b[3]) + b[2] * libm::exp(-x * b[4]),
        "Misra1b" => |b, [x, _]| b[0] * (1.0 - libm::pow(1.0 + b[1] * x / 2.0, -2.0)),
        "Misra1c" => |b, [x, _]| b[0] * (1.0 - libm::pow(1.0 + 2.0 * b[1] * x, -0.5)),
        "Misra1d" => |b, [x, _]| b[0] * b[1] * x / (1.0 + b[1] * x),
        "Nelson" => |b, [x1, x2]| b[0] - b[1] * x1 * libm::exp(-b[2] * x2),
        "Rat42" => |b, [x, _]| b[0] / (1.0 + libm::exp(b[1] - b[2] * x)),
        "Rat43" => |b, [x, _]| b[0] / libm::pow(1.0 + libm::exp(b[1] - b[2] * x), 1.0 / b[3]),
        "Roszman1" => |b, [x, _]| b[0] - b[1] * x - libm::atan(b[2] / (x - b[3])) / std::f64::consts::PI,
        other => unreachable!("no model for {other}"),
    }
}
