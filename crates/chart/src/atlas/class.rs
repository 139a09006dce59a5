//! What one value is worth.

use stratiform_artifact::AtlasRow;
use stratiform_methods::Promise;
use stratiform_stats::Estimate;

/// In f32 a value has lost its digits if it differs from f64 by more than this share. Shader code reads phase functions from 1024
/// texels, which are within 2 %.
pub const F32_SHARE: f64 = 0.05;

/// Below this f32 has no digits to lose.
const F32_FLOOR: f64 = 1e-30;

/// A flux may exceed 1 by rounding.
const ROUNDING: f64 = 1e-5;

/// From best to worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// The promise holds.
    Ok,
    /// Finite and not negative, and nothing more is promised there, or the truth is not known.
    NoPromise,
    /// Outside the declared domain, and refused.
    Refused,
    /// Far from the same in f64.
    LosesDigits,
    /// Further from the truth than promised.
    OverBound,
    /// A flux above 1.
    AboveOne,
    /// Below 0.
    Negative,
    /// NaN or infinite.
    NotFinite,
    /// Outside the declared domain, and answered.
    NotRefused,
}

impl Class {
    /// All, from best to worst.
    pub const ALL: [Self; 9] = [
        Self::Ok,
        Self::NoPromise,
        Self::Refused,
        Self::LosesDigits,
        Self::OverBound,
        Self::AboveOne,
        Self::Negative,
        Self::NotFinite,
        Self::NotRefused,
    ];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        AtlasRow::CLASSES[self as usize]
    }

    /// Whether a method that is in order may have it.
    pub fn is_allowed(self) -> bool {
        self <= Self::LosesDigits
    }
}

/// All that is known of a value when it is judged.
#[derive(Clone, Copy, Debug, Default)]
pub struct Case<'a> {
    /// What the method said; `None` is a refusal.
    pub value: Option<Estimate>,
    /// Whether the declared domain includes the point.
    pub inside: bool,
    /// Whether it is a share of the incident flux.
    pub flux: bool,
    /// The same in f64, if this is f32.
    pub double: Option<f64>,
    /// The promise that covers the point.
    pub promise: Option<&'a Promise>,
    /// What is true.
    pub truth: Option<Estimate>,
}

impl Case<'_> {
    /// The worst of the classes that apply.
    pub fn class(&self) -> Class {
        let Some(value) = self.value else { return Class::Refused };
        let lost = |double: f64| {
            let off = (value.value - double).abs();
            off > F32_SHARE * double.abs() + F32_FLOOR
        };
        let kept = self.promise.zip(self.truth).map(|(promise, truth)| promise.is_kept(value, truth));
        match value.value {
            _ if !self.inside => Class::NotRefused,
            number if !number.is_finite() => Class::NotFinite,
            number if number < 0.0 => Class::Negative,
            number if self.flux && number > 1.0 + ROUNDING + 5.0 * value.std_error => Class::AboveOne,
            _ if kept == Some(false) => Class::OverBound,
            _ if self.double.is_some_and(lost) => Class::LosesDigits,
            _ if kept == Some(true) => Class::Ok,
            _ => Class::NoPromise,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_methods::Domain;

    fn exact(value: f64) -> Estimate {
        Estimate { value, std_error: 0.0 }
    }

    #[test]
    fn every_class_is_reached() {
        let promise = Promise::relative(0.1, Domain::EVERYWHERE);
        let sound = Case {
            value: Some(exact(0.5)),
            inside: true,
            flux: true,
            double: Some(0.5),
            promise: Some(&promise),
            truth: Some(exact(0.51)),
        };
        let of = |value| Case { value: Some(exact(value)), double: None, ..sound };
        let found = [
            sound,
            Case { truth: None, ..sound },
            Case { value: None, ..sound },
            Case { double: Some(0.6), ..sound },
            of(0.6),
            of(1.1),
            of(-1e-300),
            of(f64::NAN),
            Case { inside: false, ..sound },
        ]
        .map(|case| case.class());
        assert_eq!(found, Class::ALL);
        assert_eq!(Case { flux: false, promise: None, ..of(1.1) }.class(), Class::NoPromise);
        assert_eq!(of(f64::INFINITY).class(), Class::NotFinite);
    }

    #[test]
    fn underflow_in_single_precision_is_no_loss() {
        let case = Case { value: Some(exact(0.0)), inside: true, double: Some(1e-40), ..Case::default() };
        assert_eq!(case.class(), Class::NoPromise);
    }
}
