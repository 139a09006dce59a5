// One and two wide events of the sun's light: the generated weights with the phase functions of three channels, rows 2 to 4 (P) and
// 5 to 7 (P_S convolved with itself) of the phase table. Radiance per irradiance of the sun normal to its beam.

// A face and the line along which it is seen: cosines of sun and viewer to its normal, v = 1 - cosTheta, and whether both are on its
// same side.
struct Sight {
    mu_l: f32,
    mu_v: f32,
    v: f32,
    same_side: bool,
}

struct Events {
    once: vec3<f32>,
    twice: vec3<f32>,
}

fn weights_of(sight: Sight, depth: f32) -> StratiformWeights {
    if (sight.same_side) {
        return stratiform_returned(sight.mu_l, sight.mu_v, depth);
    }
    let through = stratiform_through(sight.mu_l, sight.mu_v, depth);
    return StratiformWeights(through.once, through.twice);
}

fn phase_rows(first: u32, place: StratiformPlace) -> vec3<f32> {
    return vec3<f32>(
        stratiform_phase_row(first, place),
        stratiform_phase_row(first + 1u, place),
        stratiform_phase_row(first + 2u, place),
    );
}

// Each channel in its own modified medium: P_S = P / (1 - P_f) from theta_f on, over the depth (1 - P_f) tau.
fn events_of(sight: Sight, tau: f32) -> Events {
    let place = stratiform_phase_place(sight.v);
    let wide = select(vec3<f32>(0.0), phase_rows(2u, place) / view.kept, sight.v >= STRATIFORM_WIDE_EDGE);
    let squared = phase_rows(5u, place);
    let r = weights_of(sight, view.kept.x * tau);
    let g = weights_of(sight, view.kept.y * tau);
    let b = weights_of(sight, view.kept.z * tau);
    let unit = stratiform_radiance_from_factor(1.0, sight.mu_l);
    return Events(
        0.25 * unit * wide * vec3<f32>(r.once, g.once, b.once),
        0.125 * unit * squared * vec3<f32>(r.twice, g.twice, b.twice),
    );
}
