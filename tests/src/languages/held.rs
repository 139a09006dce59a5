//! What emitted text must do in every way of one language: keep within the bounds, and be caught when it does not.

use super::library::Run;
use super::ways::ways;

/// Largest error in units of what is allowed, of values that should be `[exact, bound]`; infinite where one is missing or no
/// number.
pub fn share(values: &[f32], expected: impl IntoIterator<Item = [f64; 2]>) -> f64 {
    let errors = expected.into_iter().enumerate().map(|(i, [exact, bound])| {
        let value = values.get(i).map_or(f64::NAN, |value| f64::from(*value));
        let error = (value - exact).abs() / bound;
        if error.is_nan() { f64::INFINITY } else { error }
    });
    errors.fold(0.0, f64::max)
}

/// Executes `text` in every way of `ending`: `share` of its values is below 1 and its own test finds nothing; `planted` is
/// seen by both.
///
/// # Panics
/// If one of these does not hold.
#[expect(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a test says what it measured, and may stop where it fails"
)]
pub fn hold(ending: &str, run: &Run, [text, planted]: [&str; 2], share: impl Fn(&[f32]) -> f64) {
    assert_ne!(text, planted);
    for way in ways(ending) {
        let Some(output) = way.execute(run, text) else { continue };
        let error = share(&output.values);
        println!("{:<24} {error:.2} of what is allowed", way.name);
        assert!(error < 1.0, "{}: {error}", way.name);
        assert_eq!(output.wrong, 0, "{}: the embedded self-test", way.name);
        let output = way.execute(run, planted).unwrap();
        assert!(share(&output.values) > 1.0 && output.wrong > 0, "{}: planted", way.name);
    }
}

/// One test per language, each calling the function named with the ending of its files.
#[macro_export]
macro_rules! in_every_language {
    ($reproduces:ident) => {
        #[test]
        fn c_and_cpp_reproduce_the_model() {
            $reproduces("h");
        }

        #[test]
        fn rust_reproduces_the_model() {
            $reproduces("rs");
        }

        #[test]
        fn metal_reproduces_the_model() {
            $reproduces("metal");
        }

        #[test]
        fn glsl_reproduces_the_model() {
            $reproduces("450.glsl");
        }

        #[test]
        fn hlsl_reproduces_the_model() {
            $reproduces("hlsl");
        }

        #[test]
        fn wgsl_reproduces_the_model() {
            $reproduces("wgsl");
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equals_pass_and_a_planted_or_missing_value_does_not() {
        let expected = [[1.0, 0.1], [2.0, 0.1]];
        assert_eq!(share(&[1.0, 2.0], expected), 0.0);
        assert!(share(&[1.0, 2.11], expected) > 1.0 && share(&[1.0, 2.09], expected) < 1.0);
        assert_eq!(share(&[1.0], expected), f64::INFINITY);
        assert_eq!(share(&[f32::NAN, 2.0], expected), f64::INFINITY);
    }
}
