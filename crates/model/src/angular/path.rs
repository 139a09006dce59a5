//! Light's way in and out of a slab, averaged over the depth of the turn.
//!
//! At depth uH the way has optical length s(u) = u(p + q) for light that turns back and s(u) = pu + q(1-u) for light
//! that goes through, p = x/μ_l, q = x/μ_v. Both weights are x/(μ_l μ_v) times a mean over u:
//!
//! ```text
//! once  = x/(μ_l μ_v) ∫ e^-s du          twice = x/(μ_l μ_v) ∫ s e^-s du
//! ```
//!
//! (twice: the first of two scatterings may sit anywhere on the way, the paper's "weight constant over ψ" with the
//! path counted). In closed form, without 0·∞ at grazing light because x/(μ_l μ_v d) = 1/|μ_l-μ_v|.

use super::Sight;
use crate::Real;
use crate::brackets::{mean_decay, mean_decay_weighted, once_each, rise};
use stratiform_quantities::Side;

/// Beyond this optical path every exponential is 0 in both precisions: an infinite path counts as this one.
const DARK: f64 = 1e4;

/// x/μ, finite at μ = 0.
pub(super) fn slant<F: Real>(x: F, mu: F) -> F {
    let (path, dark) = (x / mu, F::of(DARK));
    if path < dark { path } else { dark }
}

/// Weights of one and of two scatterings on the way, for x > 0.
pub(super) fn weights<F: Real>(x: F, sight: &Sight<F>) -> (F, F) {
    let (p, q) = (slant(x, sight.mu_l), slant(x, sight.mu_v));
    match sight.side {
        Side::Top => {
            let sum = sight.mu_l + sight.mu_v;
            (rise(p + q) / sum, once_each(p + q) / sum)
        }
        Side::Bottom => through(x, sight, if p < q { p } else { q }),
    }
}

/// `nearest` is the shorter of p and q.
fn through<F: Real>(x: F, sight: &Sight<F>, nearest: F) -> (F, F) {
    let apart = if sight.mu_l < sight.mu_v { sight.mu_v - sight.mu_l } else { sight.mu_l - sight.mu_v };
    // From the difference of the cosines, which is exact where they are close.
    let d = x * apart / sight.mu_l / sight.mu_v;
    let decay = (-nearest).exp();
    if d < F::of(1.0) {
        let scale = x * decay / sight.mu_l / sight.mu_v;
        let mean = mean_decay(d);
        (scale * mean, scale * (nearest * mean + mean_decay_weighted(d)))
    } else {
        let d = if d < F::of(DARK) { d } else { F::of(DARK) };
        let (scale, rise) = (decay / apart, rise(d));
        (scale * rise, scale * (nearest * rise + once_each(d)))
    }
}
