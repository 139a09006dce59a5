//! Whether two fits of the same medium agree within their standard errors.
//!
//! Every parameter of the table in optical thickness gives z = (a - b)/√(σ_a² + σ_b²). All N of them are
//! judged together: the largest |z| may exceed the threshold with probability α, and no more whatever their
//! correlations (to O(α²)), if the fits are independent of each other and their errors normal; see
//! [`family_threshold`]. Not compared are c, and with it b, of a row where one of the fits has no c, and what sits on the
//! same bound in both.

use crate::FitError;
use stratiform_artifact::{FittedParameter, ParameterRow, ParametersDocument};
use stratiform_quantities::Range;
use stratiform_stats::{Estimate, family_threshold, z_score};

/// One parameter of two fits.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// Row (`0`…`90`, `diffuse`; `all` for β).
    pub theta_l_deg: String,
    /// `beta`, `b`, `c`, `kappa_c`, `t` or `r`.
    pub parameter: &'static str,
    /// Values of the two fits.
    pub values: [f64; 2],
    /// Difference in its standard errors; infinite where unequal values claim no error, as on bounds.
    pub z: f64,
}

/// All parameters of two fits.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// One entry per parameter.
    pub deviations: Vec<Deviation>,
    /// |z| beyond which a parameter differs.
    pub threshold: f64,
}

impl Comparison {
    /// The parameters that differ.
    pub fn differing(&self) -> impl Iterator<Item = &Deviation> {
        self.deviations.iter().filter(|d| d.z.is_nan() || d.z.abs() > self.threshold)
    }

    /// Whether none differs.
    pub fn agrees(&self) -> bool {
        self.differing().next().is_none()
    }
}

/// Compares two fits; `false_alarm_rate` is the probability that agreeing ones are said to differ.
///
/// # Errors
/// [`FitError`] for a rate outside (0, 1) or tables whose rows differ.
pub fn compare(
    a: &ParametersDocument,
    b: &ParametersDocument,
    false_alarm_rate: f64,
) -> Result<Comparison, FitError> {
    Range::open(0.0, 1.0).check("false_alarm_rate", false_alarm_rate)?;
    let angles = |d: &ParametersDocument| -> Vec<String> {
        d.optical.rows.iter().map(|row| row.theta_l_deg.to_string()).collect()
    };
    if angles(a) != angles(b) {
        let message = format!("the tables have the rows {:?} and {:?}", angles(a), angles(b));
        return Err(FitError::Inconsistent(message));
    }
    let beta = |d: &ParametersDocument| (d.optical.beta.value, Some(d.optical.beta.std_error));
    let mut deviations = vec![deviation("all", "beta", beta(a), beta(b))];
    for (a, b) in a.optical.rows.iter().zip(&b.optical.rows) {
        deviations.extend(of_row(a, b));
    }
    let threshold = family_threshold(false_alarm_rate, deviations.len());
    Ok(Comparison { deviations, threshold: threshold.unwrap_or(f64::INFINITY) })
}

fn of_row(a: &ParameterRow, b: &ParameterRow) -> Vec<Deviation> {
    let parameters: [(&'static str, &FittedParameter, &FittedParameter); 5] = [
        ("b", &a.b, &b.b),
        ("c", &a.c, &b.c),
        ("kappa_c", &a.kappa_c, &b.kappa_c),
        ("t", &a.t, &b.t),
        ("r", &a.r, &b.r),
    ];
    let without_c = a.c.value.is_none() || b.c.value.is_none();
    let angle = a.theta_l_deg.to_string();
    let mut out = Vec::new();
    for (name, a, b) in parameters {
        if let (Some(x), Some(y)) = (a.value, b.value)
            && !(without_c && name == "b")
            && !(x == y && a.std_error.is_none() && b.std_error.is_none())
        {
            out.push(deviation(&angle, name, (x, a.std_error), (y, b.std_error)));
        }
    }
    out
}

fn deviation(
    theta_l_deg: &str,
    parameter: &'static str,
    a: (f64, Option<f64>),
    b: (f64, Option<f64>),
) -> Deviation {
    // What sits on a bound has no error of its own.
    let estimate = |(value, error): (f64, Option<f64>)| Estimate { value, std_error: error.unwrap_or(0.0) };
    let z = z_score(estimate(a), estimate(b));
    Deviation { theta_l_deg: theta_l_deg.to_owned(), parameter, values: [a.0, b.0], z }
}
