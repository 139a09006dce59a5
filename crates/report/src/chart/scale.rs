//! Axis scales and their ticks.

/// A tick; without a label it is a minor one.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where.
    pub value: f64,
    /// Label in the markup of [`super::label`].
    pub label: Option<String>,
}

/// A map from values to 0…1 along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    logarithmic: bool,
    /// Ends of the axis: the value, or its decimal logarithm.
    low: f64,
    high: f64,
    /// Distance of the ticks of a linear axis, where it is not left to the program.
    step: Option<f64>,
    /// Names of the places 0, 1, …, instead of numbers.
    names: Option<&'static [&'static str]>,
    /// Whether it goes round the upper half of a circle.
    round: bool,
}

/// Free space beyond the data at either end, as a share of the axis.
const MARGIN: f64 = 0.03;
/// Axis lengths beyond which nothing is drawn.
const FAR: f64 = 1e3;

impl Scale {
    /// A linear axis that covers the finite values and some space beside them; 0…1 if there are none.
    pub fn linear(values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = extent(values).unwrap_or((0.0, 1.0));
        Self::with_margin(false, low, high)
    }

    /// A logarithmic axis that covers the finite positive values and some space beside them; 1…10 if there
    /// are none.
    pub fn logarithmic(values: impl IntoIterator<Item = f64>) -> Self {
        let logs = values.into_iter().filter(|v| *v > 0.0).map(libm::log10);
        let (low, high) = extent(logs).unwrap_or((0.0, 1.0));
        Self::with_margin(true, low, high)
    }

    fn with_margin(logarithmic: bool, low: f64, high: f64) -> Self {
        // A single value still needs an axis of some length; one decade, or the value's own size.
        let size = if logarithmic { 1.0 } else { low.abs().max(high.abs()).max(1e-9) };
        let span = if high - low > 1e-9 * size { high - low } else { size };
        Self {
            logarithmic,
            low: low - MARGIN * span,
            high: low + (1.0 + MARGIN) * span,
            step: None,
            names: None,
            round: false,
        }
    }

    /// An axis with named places at 0, 1, ….
    pub fn named(names: &'static [&'static str]) -> Self {
        let last = names.len().saturating_sub(1) as f64;
        Self { logarithmic: false, low: -0.5, high: last + 0.5, step: None, names: Some(names), round: false }
    }

    /// A linear axis from 0 to `high` exactly; to 1 unless that is finite and positive.
    pub fn from_zero(high: f64) -> Self {
        let high = if high.is_finite() && high > 0.0 { high } else { 1.0 };
        Self { logarithmic: false, low: 0.0, high, step: None, names: None, round: false }
    }

    /// Zenith angles from -90° to 90° round a half circle, 0 at its top: the panel's ordinate is the radius.
    pub fn half_circle() -> Self {
        Self { logarithmic: false, low: -90.0, high: 90.0, step: Some(30.0), names: None, round: true }
    }

    /// Whether it goes round a half circle.
    pub fn is_round(&self) -> bool {
        self.round
    }

    /// The same with ticks at multiples of `step` (linear axes).
    pub fn with_step(self, step: f64) -> Self {
        Self { step: Some(step), ..self }
    }

    /// Place along the axis, 0 at its start and 1 at its end; `None` if the axis cannot show `value`, or if
    /// that is hundreds of axis lengths away.
    pub fn position(&self, value: f64) -> Option<f64> {
        if !value.is_finite() || (self.logarithmic && value <= 0.0) {
            return None;
        }
        let v = if self.logarithmic { libm::log10(value) } else { value };
        Some((v - self.low) / (self.high - self.low)).filter(|place| place.abs() < FAR)
    }

    /// About `target` labelled ticks, and minor ones between.
    pub fn ticks(&self, target: usize) -> Vec<Tick> {
        if let Some(names) = self.names {
            let tick = |(i, name): (usize, &&str)| Tick { value: i as f64, label: Some((*name).to_owned()) };
            return names.iter().enumerate().map(tick).collect();
        }
        if self.logarithmic { self.log_ticks(target) } else { self.linear_ticks(target) }
    }

    fn linear_ticks(&self, target: usize) -> Vec<Tick> {
        let rough = (self.high - self.low) / target.max(1) as f64;
        let step = self.step.unwrap_or_else(|| nice_step(rough));
        let decimals = (-libm::floor(libm::log10(step) + 1e-9)).clamp(0.0, 12.0) as usize;
        let (first, last) = (libm::ceil(self.low / step), libm::floor(self.high / step));
        (0..=(last - first).max(0.0) as usize)
            .map(|i| {
                let n = first + i as f64;
                // Adding zero turns -0 into 0, which prints without a sign.
                let value = n * step + 0.0;
                Tick { value, label: Some(format!("{value:.decimals$}").replace('-', "−")) }
            })
            .collect()
    }

    fn log_ticks(&self, target: usize) -> Vec<Tick> {
        let (first, last) = (libm::floor(self.low) as i32, libm::ceil(self.high) as i32);
        let decades = self.high - self.low;
        // Powers of ten are read at a glance, so they may stand closer than other labels.
        let target = 1.5 * target.max(1) as f64;
        let every = libm::ceil(decades / target).max(1.0) as i32;
        let plain = first >= -3 && last <= 4;
        let inside = |v: f64| self.position(v).is_some_and(|p| (0.0..=1.0).contains(&p));
        (first..=last)
            .flat_map(|exponent| (1..10).map(move |digit| (exponent, digit)))
            .map(|(exponent, digit)| {
                let labelled = match digit {
                    1 => exponent.rem_euclid(every) == 0,
                    2 | 5 => 3.0 * decades <= target,
                    _ => false,
                };
                let value = f64::from(digit) * libm::pow(10.0, f64::from(exponent));
                (value, exponent, digit, labelled)
            })
            .filter(|(value, _, digit, _)| inside(*value) && (decades < 9.0 || *digit == 1))
            .map(|(value, exponent, digit, labelled)| Tick {
                value,
                label: labelled.then(|| log_label(exponent, digit, plain)),
            })
            .collect()
    }
}

fn log_label(exponent: i32, digit: i32, plain: bool) -> String {
    let power = format!("10^{{{exponent}}}").replace('-', "−");
    match (plain, digit) {
        (true, _) if exponent >= 0 => format!("{digit}{}", "0".repeat(exponent as usize)),
        (true, _) => format!("0.{}{digit}", "0".repeat((-exponent - 1) as usize)),
        (false, 1) => power,
        (false, _) => format!("{digit}·{power}"),
    }
}

/// 1, 2 or 5 times a power of ten, near `rough`.
fn nice_step(rough: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10(rough)));
    let factor = match rough / power {
        ..1.5 => 1.0,
        ..3.5 => 2.0,
        ..7.5 => 5.0,
        _ => 10.0,
    };
    factor * power
}

/// Smallest and largest value. Values so large that their difference could overflow do not count.
fn extent(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    values.into_iter().filter(|v| v.abs() < 1e100).fold(None, |range, v| {
        let (low, high) = range.unwrap_or((v, v));
        Some((v.min(low), v.max(high)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, target: usize) -> Vec<String> {
        scale.ticks(target).into_iter().filter_map(|t| t.label).collect()
    }

    #[test]
    fn linear_ticks_are_round() {
        assert_eq!(labels(Scale::linear([0.0, 1.0]), 5), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(Scale::linear([0.0, 90.0]), 5), ["0", "20", "40", "60", "80"]);
        assert_eq!(labels(Scale::linear([-0.05, 0.05]), 3), ["−0.05", "0.00", "0.05"]);
    }

    #[test]
    fn logarithmic_ticks_are_powers_of_ten() {
        assert_eq!(labels(Scale::logarithmic([1.0, 1000.0]), 4), ["1", "10", "100", "1000"]);
        assert_eq!(labels(Scale::logarithmic([2e-6, 3e-4]), 3), ["10^{−5}", "10^{−4}"]);
        assert_eq!(labels(Scale::logarithmic([0.03, 0.6]), 5), ["0.05", "0.1", "0.2", "0.5"]);
    }

    #[test]
    fn named_places_are_all_labelled() {
        let scale = Scale::named(&["a", "b"]);
        assert_eq!(labels(scale, 1), ["a", "b"]);
        assert_eq!(scale.position(0.5), Some(0.5));
    }

    #[test]
    fn nothing_to_show_still_gives_an_axis() {
        for scale in [Scale::linear([]), Scale::logarithmic([-1.0, f64::NAN]), Scale::linear([3.0])] {
            assert!(!scale.ticks(5).is_empty());
            assert!(scale.ticks(5).iter().all(|t| t.value.is_finite()));
        }
        assert_eq!(Scale::logarithmic([1.0, 10.0]).position(0.0), None);
        assert_eq!(Scale::linear([1.0, 10.0]).position(f64::NAN), None);
    }
}
