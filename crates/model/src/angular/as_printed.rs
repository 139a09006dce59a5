//! Section 4 of the paper as it is printed, slips included.
//!
//! ```text
//! I1 = κ   P   μ_l/(μ_v+μ_l) (1 - τ(H_l+H_v))   or   κ   P   μ_l/(μ_v-μ_l) (τ(H_v)-τ(H_l))       (4.3)
//! I2 = κ²  P²  the same two                                                                     (4.4)
//! I3+ = R_3+ μ_l/(4πμ_v)                        or   T_3+ μ_l/(4πμ_v)                            (4.5)
//! I = I^r if V·L ≥ 0, otherwise I^t                                                             (4)
//! P_S = P/(1-P_f) if θ < θ_f, otherwise 0                                                       (4.1)
//! ```
//!
//! κ is κ_S in 1/m, so that I1 and I2 have a dimension and change with the unit of length; 1/4π is missing. The paper
//! convolves P with itself in the plane; [`PhaseLookup::wide_squared`] on the sphere stands in for that.
//! All values are reflectance factors πL/(μ_l F0), as the corrected ones are.

use super::{Angular, Orders, PhaseLookup, Sight};
use crate::{Fluxes, Real};
use stratiform_quantities::Side;

/// The face that the printed test takes the light to leave: the lit one if V·L = v - 1 ≥ 0.
pub fn side<F: Real>(sight: &Sight<F>) -> Side {
    if sight.v >= F::of(1.0) { Side::Top } else { Side::Bottom }
}

/// P_S by the printed inequality, which keeps the peak and drops the rest. `v_f` = 1 - cosθ_f.
pub fn wide<F: Real>(full: F, forward_fraction: F, v: F, v_f: F) -> F {
    if v < v_f { full / (F::of(1.0) - forward_fraction) } else { F::of(0.0) }
}

/// Reflectance factor of I3+ per unit of flux: 1/(4μ_v).
pub fn emission<F: Real>(mu_v: F) -> F {
    F::of(0.25) / mu_v
}

/// I1, I2 and I3+ on the face that [`side`] names, whatever the face of `slab` is. `kappa_s` is κ_S in 1/m.
pub fn orders<F: Real>(
    slab: &Angular<F>,
    kappa_s: F,
    phase: &impl PhaseLookup<F>,
    fluxes: &Fluxes<F>,
) -> Orders<F> {
    let sight = Sight { side: side(&slab.sight), ..slab.sight };
    let slab = Angular::unchecked(slab.depth, sight);
    let sphere = F::of(4.0 * std::f64::consts::PI);
    let flux = if sight.side == Side::Top { fluxes.r_3_plus } else { fluxes.t_3_plus };
    Orders {
        one: sphere * kappa_s * slab.one(phase),
        two: sphere * kappa_s * kappa_s * two_per_unit(&slab, phase),
        three_plus: flux * emission(sight.mu_v),
    }
}

/// The printed I2 with κ² dropped and 1/4π restored: P_S²/4 with the weight of one scattering. On the face of `slab`.
pub fn two_per_unit<F: Real>(slab: &Angular<F>, phase: &impl PhaseLookup<F>) -> F {
    F::of(0.25) * phase.wide_squared(slab.sight.v) * slab.weights().0
}
