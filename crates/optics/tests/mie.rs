//! Spheres against published answers, to two units of the last printed digit.
#![expect(clippy::unwrap_used, reason = "a test may stop")]

use num_complex::Complex64;
use stratiform_optics::mie::{SphereScattering, scatter};

/// The rows of a table as they are printed.
fn table(source: &str, file: &str) -> Vec<Vec<String>> {
    stratiform_reference_data::rows(source, file).unwrap()
}

fn number(field: &str) -> f64 {
    field.parse().unwrap()
}

/// One unit of the last digit of a number as printed.
fn last_digit(field: &str) -> f64 {
    let (mantissa, exponent) = field.split_once(['e', 'E']).unwrap_or((field, "0"));
    // Du prints six or seven digits; `.0` after a whole number is the transcription's.
    let mantissa = mantissa.strip_suffix(".0").unwrap_or(mantissa);
    let decimals = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
    libm::pow(10.0, exponent.parse::<f64>().unwrap() - decimals as f64)
}

/// The printed number, unless `value` is within two units of its last digit (rounding of the sum included).
fn differs(value: f64, printed: &str) -> Option<String> {
    let unit = last_digit(printed);
    let off = (value - number(printed)) / unit;
    (off.abs() > 2.001).then(|| format!("{value:e} against {printed}: {off:.1} units"))
}

/// A value, what is printed, and what 40 digits give where the print is known to be off.
struct Check {
    name: String,
    value: f64,
    printed: String,
    exact: Option<f64>,
}

impl Check {
    fn new(name: String, value: f64, printed: &str) -> Self {
        Self { name, value, printed: printed.to_owned(), exact: None }
    }

    /// The print decides, unless the 40-digit sum is at hand and agrees to 1e-7.
    fn failure(&self) -> Option<String> {
        let difference = differs(self.value, &self.printed)?;
        let confirmed = self.exact.is_some_and(|exact| (self.value / exact - 1.0).abs() < 1e-7);
        (!confirmed).then(|| format!("{}: {difference}, exact {:?}", self.name, self.exact))
    }
}

fn failures(checks: impl IntoIterator<Item = Check>) -> Vec<String> {
    checks.into_iter().filter_map(|check| check.failure()).collect()
}

#[test]
fn the_comparison_sees_three_units() {
    assert_eq!(last_digit("2.004089E+00"), 1e-6);
    assert_eq!(last_digit("5.01022e7"), 100.0);
    assert!(differs(2.004091, "2.004089E+00").is_none());
    assert!(differs(2.004092, "2.004089E+00").is_some());
    assert!(differs(2.004086, "2.004089E+00").is_some());
}

/// MIEV0's m = n - ik and S are the complex conjugates of ours.
fn miev0(x: &str, m: [&str; 2], angles: &[f64]) -> SphereScattering {
    scatter(number(x), [number(m[0]), -number(m[1])], angles).unwrap()
}

/// Field `column` of the 40-digit table's row whose first fields are `key`.
fn exact(rows: &[Vec<String>], key: &[String], column: usize) -> Option<f64> {
    rows.iter().find(|row| row.starts_with(key)).map(|row| number(&row[column]))
}

#[test]
fn efficiencies_are_those_of_miev0() {
    let exactly = table("mie-multiprecision", "efficiencies.csv");
    let mut wrong = Vec::new();
    for row in table("mie-miev0", "efficiencies.csv") {
        let q = miev0(&row[4], [&row[2], &row[3]], &[]).efficiencies;
        let mut checks = [(5, q.q_ext), (6, q.q_sca), (7, q.g * q.q_sca)].map(|(column, value)| {
            Check::new(format!("case {} column {column}", row[0]), value, &row[column])
        });
        checks[2].exact = exact(&exactly, &row[..1], 1);
        // Case 6's Qext and Qsca are 4 units high by Du's eight digits, which `spheres_are_those_of_du` holds.
        wrong.extend(failures(checks.into_iter().skip(if row[0] == "6" { 2 } else { 0 })));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn amplitudes_are_those_of_miev0() {
    let spheres = table("mie-miev0", "efficiencies.csv");
    let exactly = table("mie-multiprecision", "amplitudes.csv");
    let (mut wrong, mut confirmed) = (Vec::new(), 0);
    for row in table("mie-miev0", "amplitudes.csv") {
        let case = spheres.iter().find(|sphere| sphere[0] == row[0]).unwrap();
        let s = miev0(&case[4], [&case[2], &case[3]], &[number(&row[1])]).amplitudes[0];
        for (column, value, sign) in
            [(2, s.s1.re, 1.0), (3, s.s1.im, -1.0), (4, s.s2.re, 1.0), (5, s.s2.im, -1.0)]
        {
            let mut check = Check::new(
                format!("case {} at {} column {column}", row[0], row[1]),
                sign * value,
                &row[column],
            );
            check.exact = exact(&exactly, &row[..2], column).map(|exact| sign * exact);
            confirmed += usize::from(differs(check.value, &check.printed).is_some());
            wrong.extend(check.failure());
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(confirmed <= 24, "{confirmed} of 420 printed numbers are off by more than two units");
}

#[test]
fn spheres_are_those_of_du() {
    let exactly = table("mie-multiprecision", "amplitudes.csv");
    let mut wrong = Vec::new();
    for row in table("mie-du-2004", "spheres.csv").into_iter().filter(|row| number(&row[1]) <= 1e5) {
        let sphere = scatter(number(&row[1]), [number(&row[2]), number(&row[3])], &[0.0, 180.0]).unwrap();
        let (q, s) = (sphere.efficiencies, &sphere.amplitudes);
        let values = [q.q_ext, q.q_sca, s[0].s1.re, s[0].s1.im, s[1].s1.re, s[1].s1.im];
        let checks =
            (0..6).map(|i| Check::new(format!("case {} column {}", row[0], i + 4), values[i], &row[i + 4]));
        // The backscattering of case f, which others cannot reproduce either; 40 digits decide.
        let backward = exact(&exactly, &["11".to_owned(), "180".to_owned()], 2).zip(exact(
            &exactly,
            &["11".to_owned(), "180".to_owned()],
            3,
        ));
        wrong.extend(failures(checks.map(|mut check| {
            check.exact = match check.name.as_str() {
                "case f column 8" => backward.map(|(re, _)| re),
                "case f column 9" => backward.map(|(_, im)| im),
                _ => None,
            };
            check
        })));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// S11, -S12/S11, S33/S11, S34/S11 (Bohren & Huffman 1983, eqs. 4.77).
fn matrix(s1: Complex64, s2: Complex64) -> [f64; 4] {
    let s11 = 0.5 * (s2.norm_sqr() + s1.norm_sqr());
    let s12 = 0.5 * (s2.norm_sqr() - s1.norm_sqr());
    let (s33, s34) = ((s2.conj() * s1).re, (s2 * s1.conj()).im);
    [s11, -s12 / s11, s33 / s11, s34 / s11]
}

#[test]
fn the_matrix_is_that_of_bohren_and_huffman() {
    let mut wrong = Vec::new();
    let x = 2.0 * std::f64::consts::PI * 0.525 / 0.6328;
    for row in table("mie-bohren-huffman-1983", "scattering_matrix.csv") {
        let sphere = scatter(x, [1.55, 0.0], &[number(&row[0]), 0.0]).unwrap();
        let [at, forward] = [0, 1].map(|i| matrix(sphere.amplitudes[i].s1, sphere.amplitudes[i].s2));
        let values = [at[0] / forward[0], at[1], at[2], at[3]];
        let checks =
            (0..4).map(|i| Check::new(format!("{} column {}", row[0], i + 1), values[i], &row[i + 1]));
        wrong.extend(failures(checks));
    }
    for row in table("mie-bohren-huffman-1983", "efficiencies.csv") {
        let sphere = scatter(x, [number(&row[0]), number(&row[1])], &[180.0]).unwrap();
        let q = sphere.efficiencies;
        let q_back = 4.0 * sphere.amplitudes[0].s1.norm_sqr() / (x * x);
        let checks = [q.q_ext, q.q_sca, q_back, q.g].into_iter().enumerate();
        wrong.extend(failures(
            checks.map(|(i, value)| Check::new(format!("column {}", i + 2), value, &row[i + 2])),
        ));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
