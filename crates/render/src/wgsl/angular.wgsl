// The orders of the paper, corrected: one and two events at `near`, three and more at `far`. Radiance per irradiance of the sun.
struct Orders {
    one: vec3<f32>,
    two: vec3<f32>,
    more: vec3<f32>,
}

fn sun_orders(near: Sight, far: Sight, tau: f32) -> Orders {
    let events = events_of(near, tau);
    var more = 0.0;
    if (far.same_side) {
        more = stratiform_orders_top(far.mu_l, far.mu_v, far.v, tau, view.emission_top).three_plus;
    } else {
        more = stratiform_orders_bottom(far.mu_l, far.mu_v, far.v, tau, view.emission_bottom).three_plus;
    }
    return Orders(events.once, events.twice, vec3<f32>(stratiform_radiance_from_factor(more, far.mu_l)));
}
