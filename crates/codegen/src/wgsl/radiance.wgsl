// Cosines below this are taken for it: the limit of grazing light.
const STRATIFORM_GRAZING: f32 = 1e-12;
// How light that was scattered three times or more leaves a face: evenly in direction as from a thin slab, evenly in
// radiance, or as from a thick slab.
const STRATIFORM_ISOTROPIC: u32 = 0u;
const STRATIFORM_LAMBERTIAN: u32 = 1u;
const STRATIFORM_ESCAPE: u32 = 2u;

// What a phase function's value is multiplied by: P_S / 4 by once, P_S convolved with itself / 8 by twice.
struct StratiformWeights {
    once: f32,
    twice: f32,
}

// Reflectance factors pi L / (mu_l F0) of light that was scattered once, twice, and more often.
struct StratiformOrders {
    one: f32,
    two: f32,
    three_plus: f32,
}

// ---- weights of one and two scatterings ------------------------------------------------------------------------

// Light that leaves the lit face, after a way of optical length depth / mu_l + depth / mu_v at most.
fn stratiform_weights_top(mu_l: f32, mu_v: f32, tau: f32) -> StratiformWeights {
    let sun = max(mu_l, STRATIFORM_GRAZING);
    let view = max(mu_v, STRATIFORM_GRAZING);
    let depth = STRATIFORM_KAPPA_S * tau;
    let b = stratiform_brackets(depth / sun + depth / view);
    let share = 1.0 / (sun + view);
    return StratiformWeights(share * b.rise, share * b.once_each);
}

// Light that leaves the other face: ways between the lengths depth / mu_l and depth / mu_v.
fn stratiform_weights_bottom(mu_l: f32, mu_v: f32, tau: f32) -> StratiformWeights {
    let sun = max(mu_l, STRATIFORM_GRAZING);
    let view = max(mu_v, STRATIFORM_GRAZING);
    let depth = STRATIFORM_KAPPA_S * tau;
    let shortest = depth / max(sun, view);
    // Nowhere 0, so that the mean over equal lengths is their limit.
    let spread = max(abs(depth / sun - depth / view), 1e-12);
    let b = stratiform_brackets(spread);
    let share = depth / (sun * view) * exp(-shortest) / spread;
    return StratiformWeights(share * b.rise, share * (shortest * b.rise + b.once_each));
}

// ---- orders ----------------------------------------------------------------------------------------------------

// Reflectance factor per flux of light that leaves with one of the three shapes.
fn stratiform_emission(shape: u32, mu_v: f32) -> f32 {
    if (shape == STRATIFORM_ISOTROPIC) {
        return 0.5 / max(mu_v, STRATIFORM_GRAZING);
    }
    if (shape == STRATIFORM_LAMBERTIAN) {
        return 1.0;
    }
    return 0.42857143 + 0.85714286 * mu_v;
}

// The orders of light that leaves the lit face at mu_v, v = 1 - cosTheta.
fn stratiform_orders_top(mu_l: f32, mu_v: f32, v: f32, tau: f32, shape: u32) -> StratiformOrders {
    let w = stratiform_weights_top(mu_l, mu_v, tau);
    let place = stratiform_phase_place(v);
    let wide = stratiform_phase_modified_at(place, v);
    let squared = stratiform_phase_squared_at(place);
    let flux = stratiform_r_three_plus(mu_l, tau);
    return StratiformOrders(
        0.25 * wide * w.once,
        0.125 * squared * w.twice,
        flux * stratiform_emission(shape, mu_v),
    );
}

// The orders of light that leaves the other face at mu_v, v = 1 - cosTheta.
fn stratiform_orders_bottom(mu_l: f32, mu_v: f32, v: f32, tau: f32, shape: u32) -> StratiformOrders {
    let w = stratiform_weights_bottom(mu_l, mu_v, tau);
    let place = stratiform_phase_place(v);
    let wide = stratiform_phase_modified_at(place, v);
    let squared = stratiform_phase_squared_at(place);
    let flux = stratiform_t_three_plus(mu_l, tau);
    return StratiformOrders(
        0.25 * wide * w.once,
        0.125 * squared * w.twice,
        flux * stratiform_emission(shape, mu_v),
    );
}

// ---- radiance --------------------------------------------------------------------------------------------------

// Reflectance factor of all light scattered by more than theta_f that leaves the lit face.
fn stratiform_radiance_top(mu_l: f32, mu_v: f32, v: f32, tau: f32, shape: u32) -> f32 {
    let o = stratiform_orders_top(mu_l, mu_v, v, tau, shape);
    return o.one + o.two + o.three_plus;
}

// Reflectance factor of all light scattered by more than theta_f that leaves the other face. The sun's disc (the
// transparency) and the halo around it, at angles near and below theta_f, are not in it.
fn stratiform_radiance_bottom(mu_l: f32, mu_v: f32, v: f32, tau: f32, shape: u32) -> f32 {
    let o = stratiform_orders_bottom(mu_l, mu_v, v, tau, shape);
    return o.one + o.two + o.three_plus;
}

// Share of the light from behind that crosses the slab towards mu_v without an event.
fn stratiform_transparency(mu_v: f32, tau: f32) -> f32 {
    return exp(-(tau / max(mu_v, STRATIFORM_GRAZING)));
}

// L / F0 in 1/sr of a reflectance factor: times the sun's irradiance normal to its beam it is a radiance.
fn stratiform_radiance_from_factor(factor: f32, mu_l: f32) -> f32 {
    return 0.31830989 * mu_l * factor;
}

