//! ∫ (a + s(Θ-Θ0)) sinΘ dΘ over a cell [Θ0, Θ0 + t], in closed form and without cancellation in tiny cells.
//!
//! With h = t/2 and M = Θ0 + h the integral is a·I_0 + s·I_1, where I_0 = cosΘ0 - cos(Θ0+t) = 2 sinM sin h and
//! I_1 = ∫ u sin(Θ0+u) du = 2 cosM (sin h - h cos h) + 2h sinM sin h.

/// A piece of a phase function linear in Θ: P = `value` + `slope`·(Θ - `start`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cell {
    pub(super) start: f64,
    pub(super) value: f64,
    pub(super) slope: f64,
}

impl Cell {
    /// ∫ P sinΘ dΘ over the cell's first `t` radians.
    pub(super) fn integral(&self, t: f64) -> f64 {
        let half = Half::new(0.5 * t);
        self.integral_about(&half, libm::sincos(self.start + half.h))
    }

    /// The same, sine and cosine of the middle given.
    fn integral_about(&self, half: &Half, (sin_m, cos_m): (f64, f64)) -> f64 {
        let flat = 2.0 * sin_m * half.sine;
        let rising = 2.0 * cos_m * half.sine_minus_h_cosine + half.h * flat;
        self.value * flat + self.slope * rising
    }

    /// ∫ P cosΘ sinΘ dΘ over the cell's first `t` radians: the same integral of ½ sin 2Θ.
    pub(super) fn cosine_integral(&self, t: f64) -> f64 {
        let doubled = Cell { start: 2.0 * self.start, value: self.value, slope: 0.5 * self.slope };
        0.25 * doubled.integral(2.0 * t)
    }

    /// The t ∈ \[0, `width`\] at which [`integral`](Self::integral) equals `target`: Newton's method, kept inside a
    /// bracket that each step shrinks. It doubles the digits, so that a step of 1e-8 of the way to either end is the last.
    pub(super) fn invert(&self, target: f64, width: f64) -> f64 {
        let start = libm::sincos(self.start);
        let (mut low, mut high) = (0.0, width);
        let mut t = self.first_guess(target, width, start).clamp(low, high);
        for _ in 0..60 {
            let half = Half::new(0.5 * t);
            let middle = half.after(start);
            let excess = self.integral_about(&half, middle) - target;
            if excess > 0.0 {
                high = t;
            } else {
                low = t;
            }
            let newton = t - excess / self.density(t, half.after(middle));
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            let step = (next - t).abs();
            let short = next == newton && step <= 1e-8 * next.min(width - next);
            if short || step <= f64::EPSILON * (self.start + t) {
                return next;
            }
            t = next;
        }
        t
    }

    /// P sinΘ, sine and cosine of Θ given.
    fn density(&self, t: f64, (sine, _): (f64, f64)) -> f64 {
        (self.value + self.slope * t) * sine
    }

    /// The t at which a density that is linear between the cell's ends has the integral `target`.
    fn first_guess(&self, target: f64, width: f64, start: (f64, f64)) -> f64 {
        let first = self.density(0.0, start);
        let rise = (self.density(width, Half::new(width).after(start)) - first) / width;
        let t = 2.0 * target / (first + (first * first + 2.0 * target * rise).max(0.0).sqrt());
        if t.is_finite() { t } else { 0.0 }
    }
}

/// Half a width, its sine and cosine, and sin h - h cos h.
struct Half {
    h: f64,
    sine: f64,
    cosine: f64,
    sine_minus_h_cosine: f64,
}

/// Up to here series leave less than rounding.
const NARROW: f64 = 0.1;

impl Half {
    fn new(h: f64) -> Self {
        let (sine, cosine) = if h.abs() > NARROW { libm::sincos(h) } else { narrow(h) };
        Self { h, sine, cosine, sine_minus_h_cosine: sin_minus_h_cos(h, sine, cosine) }
    }

    /// Sine and cosine of an angle and h together.
    fn after(&self, (sine, cosine): (f64, f64)) -> (f64, f64) {
        (sine * self.cosine + cosine * self.sine, cosine * self.cosine - sine * self.sine)
    }
}

/// Sine and cosine of |h| ≤ [`NARROW`] by their series.
fn narrow(h: f64) -> (f64, f64) {
    let x = h * h;
    let sine = 1.0 - x * (1.0 / 6.0 - x * (1.0 / 120.0 - x * (1.0 / 5040.0 - x * (1.0 / 362_880.0))));
    let cosine =
        x * (0.5 - x * (1.0 / 24.0 - x * (1.0 / 720.0 - x * (1.0 / 40_320.0 - x * (1.0 / 3_628_800.0)))));
    (h * sine, 1.0 - cosine)
}

/// sin h - h cos h, by its series h³/3 - h⁵/30 + … where the difference would cancel.
fn sin_minus_h_cos(h: f64, sin_h: f64, cos_h: f64) -> f64 {
    if h.abs() > 0.3 {
        return sin_h - h * cos_h;
    }
    let x = h * h;
    h * x * (1.0 / 3.0 - x * (1.0 / 30.0 - x * (1.0 / 840.0 - x * (1.0 / 45360.0 - x * (1.0 / 3_991_680.0)))))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Simpson's rule with 64 panels against the closed form, cells from 1e-9 to 3 rad.
    #[test]
    fn the_closed_form_is_the_integral() {
        for start in [0.0, 1e-6, 0.01, 0.5, 1.5] {
            for width in [1e-9, 1e-5, 0.01, 0.3, 0.7, 1.5] {
                let cell = Cell { start, value: 2.0, slope: -0.5 };
                let h = width / 64.0;
                let f = |t: f64| (2.0 - 0.5 * t) * libm::sin(start + t);
                let simpson = (0..64).fold(0.0, |sum, i| {
                    let t = h * f64::from(i);
                    sum + h / 6.0 * (f(t) + 4.0 * f(t + 0.5 * h) + f(t + h))
                });
                let ratio = cell.integral(width) / simpson;
                assert!((ratio - 1.0).abs() < 1e-9, "{start} {width}: {ratio}");
                let g = |t: f64| f(t) * libm::cos(start + t);
                let simpson = (0..64).fold(0.0, |sum, i| {
                    let t = h * f64::from(i);
                    sum + h / 6.0 * (g(t) + 4.0 * g(t + 0.5 * h) + g(t + h))
                });
                assert!((cell.cosine_integral(width) - simpson).abs() < 1e-8 * width, "{start} {width}");
            }
        }
    }

    #[test]
    fn series_are_sine_and_cosine() {
        for i in 0..=1000 {
            let h = NARROW * f64::from(i) / 1000.0;
            let ((sine, cosine), expected) = (narrow(h), libm::sincos(h));
            assert!(
                (sine - expected.0).abs() <= f64::EPSILON * sine && (cosine - expected.1).abs() <= 2e-16,
                "{h}"
            );
        }
    }

    #[test]
    fn both_forms_of_the_bracket_meet() {
        let h = 0.3;
        let series = sin_minus_h_cos(h, libm::sin(h), libm::cos(h));
        assert!((series / (libm::sin(h) - h * libm::cos(h)) - 1.0).abs() < 1e-13);
    }
}
