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
    let scale = STRATIFORM_KAPPA_S * tau / sun / view;
    let shortest = STRATIFORM_KAPPA_S * tau / max(sun, view);
    // Nowhere 0: the mean over equal lengths is the limit of this one.
    let apart = max(abs(sun - view), 1e-9 * sun);
    let b = stratiform_brackets(scale * apart);
    let share = exp(-shortest) / apart;
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

// ---- self-test ---------------------------------------------------------------------------------------------------

// Where vector i looks.
struct StratiformSight {
    mu_l: f32,
    mu_v: f32,
    v: f32,
    tau: f32,
}

// Vector i; its shape is i % 3.
fn stratiform_radiance_test_sight(i: u32) -> StratiformSight {
    switch i {
@SIGHTS@
    }
}

// What the model gives for vector i in double precision at the lit face.
fn stratiform_radiance_test_top(i: u32) -> StratiformOrders {
    switch i {
@TOP@
    }
}

// At the other face.
fn stratiform_radiance_test_bottom(i: u32) -> StratiformOrders {
    switch i {
@BOTTOM@
    }
}

// 1 if value is off by more than 1e-4 (0.02 + |expected|), else 0.
fn stratiform_radiance_wrong(value: f32, expected: f32) -> u32 {
    return select(1u, 0u, abs(value - expected) <= 1e-4 * (0.02 + abs(expected)));
}

// How many of the orders are wrong.
fn stratiform_orders_wrong(found: StratiformOrders, expected: StratiformOrders) -> u32 {
    return stratiform_radiance_wrong(found.one, expected.one)
        + stratiform_radiance_wrong(found.two, expected.two)
        + stratiform_radiance_wrong(found.three_plus, expected.three_plus);
}

// How many of the self-test's values are wrong: 0 if this file and those that it needs work together.
fn stratiform_radiance_self_test() -> u32 {
    var wrong = 0u;
    for (var i = 0u; i < @COUNT@u; i += 1u) {
        let s = stratiform_radiance_test_sight(i);
        let top = stratiform_orders_top(s.mu_l, s.mu_v, s.v, s.tau, i % 3u);
        let bottom = stratiform_orders_bottom(s.mu_l, s.mu_v, s.v, s.tau, i % 3u);
        wrong += stratiform_orders_wrong(top, stratiform_radiance_test_top(i));
        wrong += stratiform_orders_wrong(bottom, stratiform_radiance_test_bottom(i));
    }
    return wrong;
}
