// One event exactly at `near`, all others as the fitted exponential at `far`; two events are among the latter. Radiance per irradiance of the
// sun.
struct Orders {
    one: vec3<f32>,
    two: vec3<f32>,
    more: vec3<f32>,
}

fn sun_orders(near: Sight, far: Sight, tau: f32) -> Orders {
    let events = events_of(near, tau);
    let scaled = STRATIFORM_SIMILARITY * tau;
    var more = 0.0;
    if (far.same_side) {
        more = stratiform_shade_more_top(stratiform_shade_of_top(scaled), far.mu_l, far.mu_v, far.v, scaled);
    } else {
        more = stratiform_shade_more_bottom(stratiform_shade_of_bottom(scaled), far.mu_l, far.mu_v, far.v, scaled);
    }
    return Orders(events.once, vec3<f32>(0.0), vec3<f32>(stratiform_radiance_from_factor(more, far.mu_l)));
}
