//! A ray over one texel, where the thickness is bilinear.

use super::Run;

/// Height over the cloud's top along the ray, c0 + c1 s + c2 s² with s from `from` on.
pub(super) struct Patch {
    c: [f64; 3],
    from: f64,
    length: f64,
}

impl Patch {
    /// `corners` south-west, south-east, north-west, north-east; the ray is at `at` in the texel, moves by `speed` texels a metre, and
    /// has `height` over the base and its change.
    pub(super) fn new(
        [sw, se, nw, ne]: [f64; 4],
        [x, y]: [f64; 2],
        [u, v]: [f64; 2],
        [height, rise]: [f64; 2],
        [from, to]: [f64; 2],
    ) -> Self {
        let (east, north, twist) = (se - sw, nw - sw, ne - nw - se + sw);
        let top = sw + east * x + north * y + twist * x * y;
        let slope = east * u + north * v + twist * (x * v + y * u);
        Self { c: [height - top, rise - slope, -twist * u * v], from, length: to - from }
    }

    /// Runs the pieces below the top.
    pub(super) fn walk(&self, run: &mut Run) -> Option<f64> {
        let mut start = 0.0;
        for root in self.roots().into_iter().chain([self.length]) {
            let end = root.clamp(start, self.length);
            if end > start {
                if self.over(0.5 * (start + end)) < 0.0 {
                    let found = run.through(self.from + start, self.from + end);
                    if found.is_some() {
                        return found;
                    }
                }
                start = end;
            }
        }
        None
    }

    fn over(&self, s: f64) -> f64 {
        self.c[0] + s * (self.c[1] + s * self.c[2])
    }

    /// Roots in ascending order; infinity where there is none. Without cancellation (Numerical Recipes, 5.6).
    fn roots(&self) -> [f64; 2] {
        let [c, b, a] = self.c;
        let discriminant = b * b - 4.0 * a * c;
        if discriminant < 0.0 {
            return [f64::INFINITY; 2];
        }
        let q = -0.5 * (b + discriminant.sqrt().copysign(b));
        let finite = |x: f64| if x.is_finite() { x } else { f64::INFINITY };
        let (first, second) = (finite(q / a), finite(c / q));
        [first.min(second), first.max(second)]
    }
}
