// How light that was scattered three times or more leaves a face: evenly in direction as from a thin slab, evenly in
// radiance, or as from a thick slab.
const STRATIFORM_ISOTROPIC: u32 = 0u;
const STRATIFORM_LAMBERTIAN: u32 = 1u;
const STRATIFORM_ESCAPE: u32 = 2u;

// Reflectance factors pi L / (mu_l F0) of light that was scattered once, twice, and more often.
struct StratiformOrders {
    one: f32,
    two: f32,
    three_plus: f32,
}

// ---- orders ----------------------------------------------------------------------------------------------------

// Reflectance factor per flux of light that leaves with one of the three shapes.
fn stratiform_emission(shape: u32, mu_v: f32) -> f32 {
    if (shape == STRATIFORM_ISOTROPIC) {
        return 0.5 / stratiform_leaning(mu_v);
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
    let f = stratiform_turned(stratiform_parameters(mu_l), tau);
    let flux = f.r_ms - f.r_one - f.r_two;
    return StratiformOrders(
        0.25 * wide * w.once,
        0.125 * squared * w.twice,
        flux * stratiform_emission(shape, mu_v),
    );
}

// The orders of light that leaves the other face at mu_v, v = 1 - cosTheta.
fn stratiform_orders_bottom(mu_l: f32, mu_v: f32, v: f32, tau: f32, shape: u32) -> StratiformOrders {
    let depth = STRATIFORM_KAPPA_S * tau;
    let w = stratiform_through(mu_l, mu_v, depth);
    let place = stratiform_phase_place(v);
    let wide = stratiform_phase_modified_at(place, v);
    let squared = stratiform_phase_squared_at(place);
    let f = stratiform_turned(stratiform_parameters(mu_l), tau);
    var scattered = f.t_ms - w.straight;
    if (f.r_ms < 0.5) {
        scattered = stratiform_rise(depth / stratiform_leaning(mu_l)) - f.r_ms;
    }
    let flux = scattered - f.t_one - f.t_two;
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

// ---- self-test ---------------------------------------------------------------------------------------------------

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
