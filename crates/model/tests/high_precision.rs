//! Both precisions against 60-digit values over optical thickness 1e-8 to 1e4.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use stratiform_model::{Form, Parameters, Real, Thickness, Values, exponential_integral_e3};
use stratiform_quantities::Incidence;

fn table(name: &str) -> Vec<Vec<String>> {
    stratiform_reference_data::rows("high-precision-1d", name).unwrap()
}

fn numbers(fields: &[String]) -> Vec<f64> {
    fields.iter().map(|field| field.parse().unwrap()).collect()
}

struct Case {
    values: Values<f64>,
    light: Incidence,
    thickness: f64,
    /// The nine fluxes, then T_2 and T_3+ as printed.
    exact: Vec<f64>,
}

fn cases() -> Vec<Case> {
    let case = |row: Vec<String>| {
        let [beta, b, c, kappa_c, t, r, kappa_s] = numbers(&row[..7])[..] else { panic!("{row:?}") };
        Case {
            values: Values { beta, b, c, kappa_c, t, r, kappa_s },
            light: row[7].parse().unwrap(),
            thickness: row[8].parse().unwrap(),
            exact: numbers(&row[9..]),
        }
    };
    table("fluxes.csv").into_iter().map(case).collect()
}

impl Case {
    /// What a flux may be off by, in units of ε: rounding of κH and of exp's argument, times the scale of the flux.
    fn allowance(&self, exact: f64) -> f64 {
        let mu = match self.light {
            Incidence::Beam(mu) if mu.get() > 0.0 => mu.get(),
            _ => 1.0,
        };
        let depth = self.values.kappa_s.max(self.values.kappa_c) * self.thickness * (3.0 + 1.0 / mu);
        (6.0 + depth) * exact.abs()
    }

    /// The fluxes of `form`.
    fn exact(&self, form: Form) -> Vec<f64> {
        let mut exact = self.exact.clone();
        if form == Form::AsPrinted {
            exact.swap(4, 9);
            exact.swap(5, 10);
        }
        exact
    }

    /// What the flux's error is relative to: itself, or the largest term of a difference.
    fn scale(&self, e: &[f64], quantity: usize) -> f64 {
        match quantity {
            5 => e[3].max(e[4]).max(e[1].max(1.0 - e[2]).min(e[0].max(e[2]))),
            8 => e[1].max(e[6]).max(e[7]),
            // R_ms is a difference too where b > 1.
            1 => e[1].max((1.0 - self.values.b).abs() * (self.values.c * self.thickness).min(1.0)),
            _ => e[quantity].abs(),
        }
    }

    /// Fluxes of `form`, the model's and the exact ones.
    fn compare<F: Real>(&self, form: Form) -> Vec<(&'static str, f64, f64, f64)> {
        let parameters = Parameters::<F>::new(&self.values, self.light).unwrap();
        let fluxes = parameters.fluxes(form, Thickness::new(F::of(self.thickness)).unwrap());
        let exact = self.exact(form);
        let row = |(i, (name, value)): (usize, (_, F))| {
            (name, value.to_f64(), exact[i], self.allowance(self.scale(&exact, i)))
        };
        fluxes.named().into_iter().enumerate().map(row).collect()
    }
}

fn check<F: Real>(epsilon: f64, tiny: f64) {
    let mut worst = 0.0_f64;
    for case in cases() {
        for form in [Form::Corrected, Form::AsPrinted] {
            for (name, value, exact, allowance) in case.compare::<F>(form) {
                let error = (value - exact).abs();
                let bound = epsilon * allowance + tiny;
                worst = worst.max(error / bound);
                assert!(
                    error <= bound,
                    "{name} {form:?} H = {} {:?} {}: {value:e} against {exact:e}, error {error:e}, bound {bound:e}",
                    case.thickness,
                    case.values,
                    case.light,
                );
            }
        }
    }
    println!("largest error over bound: {worst:.2}");
}

#[test]
fn double_precision_loses_nothing() {
    check::<f64>(f64::EPSILON, f64::MIN_POSITIVE);
}

#[test]
fn single_precision_loses_nothing() {
    check::<f32>(f64::from(f32::EPSILON), f64::from(f32::MIN_POSITIVE));
}

#[test]
fn thin_slabs_keep_relative_accuracy() {
    // The bound as a plain number where every optical path is below 1: 1e-13 and 2e-6 stand for any hidden factor.
    for case in cases().iter().filter(|case| case.values.kappa_c * case.thickness < 1.0) {
        for (name, value, exact, _) in case.compare::<f64>(Form::Corrected) {
            let dark = matches!(case.light, Incidence::Beam(mu) if mu.get() < 0.1);
            if !(name.ends_with("plus") || dark) {
                assert!((value - exact).abs() <= 1e-13 * exact.abs(), "{name}: {value:e} against {exact:e}");
            }
        }
        for (name, value, exact, _) in case.compare::<f32>(Form::Corrected) {
            if matches!(name, "t_1" | "t_2" | "r_1" | "r_2") {
                assert!(
                    (value - exact).abs() <= 1e-6 * exact.abs() + 1e-37,
                    "{name}: {value:e} against {exact:e}"
                );
            }
        }
    }
}

#[test]
fn the_exponential_integral_is_exact_to_rounding() {
    for row in table("e3.csv") {
        let [x, exact, _] = numbers(&row)[..] else { panic!("{row:?}") };
        let double = exponential_integral_e3(x);
        assert!((double - exact).abs() <= f64::EPSILON * (4.0 + x) * exact + f64::MIN_POSITIVE, "E_3({x})");
        let single = f64::from(exponential_integral_e3(x as f32));
        let epsilon = f64::from(f32::EPSILON);
        assert!((single - exact).abs() <= epsilon * (4.0 + x) * exact + 1e-38, "E_3({x}) in f32");
    }
}

/// The bound is sharp enough to see what it is about: the brackets evaluated as printed, in single precision.
#[test]
fn cancellation_would_be_seen() {
    let case = cases().into_iter().find(|case| (1e-3..0.1).contains(&(case.values.kappa_c * case.thickness)));
    let case = case.unwrap();
    let (x, [t, r]) = ((case.values.kappa_c * case.thickness) as f32, [case.values.t, case.values.r]);
    let naive = f64::from(1.0 - (1.0 + 2.0 * x) * libm::expf(-2.0 * x)) * 0.5 * r * t;
    let exact = case.exact[7];
    let bound = f64::from(f32::EPSILON) * case.allowance(case.scale(&case.exact, 7));
    assert!((naive - exact).abs() > 10.0 * bound, "{naive} {exact} {bound}");
}

/// The paper's double integrals decide between the printed and the corrected form.
#[test]
fn only_the_corrected_form_is_the_papers_integral() {
    let of = |x: f64, form| {
        let values = Values { beta: 1.0, b: 1.0, c: 0.0, kappa_c: 1.0, t: 1.0, r: 1.0, kappa_s: 1.0 };
        let parameters = Parameters::<f64>::new(&values, Incidence::Diffuse).unwrap();
        parameters.fluxes(form, Thickness::new(x).unwrap())
    };
    for row in table("orders-by-quadrature.csv") {
        let [x, t_1, r_1, t_2a, t_2b, r_2] = numbers(&row)[..] else { panic!("{row:?}") };
        let (corrected, printed) = (of(x, Form::Corrected), of(x, Form::AsPrinted));
        let exact = [t_1, r_1, t_2a + t_2b, r_2];
        for (value, exact) in [corrected.t_1, corrected.r_1, corrected.t_2, corrected.r_2].iter().zip(exact) {
            assert!((value / exact - 1.0).abs() < 1e-14, "x = {x}: {value} against {exact}");
        }
        assert!((printed.t_2 / exact[2] - 1.0).abs() > 0.01, "x = {x}");
    }
}
