// What a phase function's value is multiplied by: P_S / 4 by once, P_S convolved with itself / 8 by twice.
struct StratiformWeights {
    once: f32,
    twice: f32,
}

// The same of light that goes through a slab, and exp(-depth / mu_l), the share that comes straight through.
struct StratiformThrough {
    once: f32,
    twice: f32,
    straight: f32,
}

// ---- weights of one and two scatterings ------------------------------------------------------------------------

// Light that leaves the lit face of a slab of this optical thickness, after ways up to the length depth / mu_l + depth / mu_v.
fn stratiform_returned(mu_l: f32, mu_v: f32, depth: f32) -> StratiformWeights {
    let sun = stratiform_leaning(mu_l);
    let view = stratiform_leaning(mu_v);
    let b = stratiform_brackets(depth / sun + depth / view);
    let share = 1.0 / (sun + view);
    return StratiformWeights(share * b.rise, share * b.once_each);
}

// The same of this cloud.
fn stratiform_weights_top(mu_l: f32, mu_v: f32, tau: f32) -> StratiformWeights {
    return stratiform_returned(mu_l, mu_v, STRATIFORM_KAPPA_S * tau);
}

// Light that goes through a slab of this optical thickness: ways between the lengths depth / mu_l and depth / mu_v.
fn stratiform_through(mu_l: f32, mu_v: f32, depth: f32) -> StratiformThrough {
    let sun = stratiform_leaning(mu_l);
    let view = stratiform_leaning(mu_v);
    let shortest = depth / select(view, sun, sun > view);
    // Nowhere 0: the mean over equal lengths is the limit of this one.
    let apart = abs(sun - view) + 1e-9 * sun;
    let b = stratiform_brackets(shortest * (apart / select(sun, view, sun > view)));
    let decay = exp(-shortest);
    let share = decay / apart;
    let straight = select(decay * b.decay, decay, sun > view);
    return StratiformThrough(share * b.rise, share * (shortest * b.rise + b.once_each), straight);
}

// The same of this cloud: light that leaves the other face.
fn stratiform_weights_bottom(mu_l: f32, mu_v: f32, tau: f32) -> StratiformWeights {
    let w = stratiform_through(mu_l, mu_v, STRATIFORM_KAPPA_S * tau);
    return StratiformWeights(w.once, w.twice);
}

// ---- no scattering, and units ---------------------------------------------------------------------------------

// Share of the light from behind that crosses the slab towards mu_v without an event.
fn stratiform_transparency(mu_v: f32, tau: f32) -> f32 {
    return exp(-(tau / stratiform_leaning(mu_v)));
}

// L / F0 in 1/sr of a reflectance factor: times the sun's irradiance normal to its beam it is a radiance.
fn stratiform_radiance_from_factor(factor: f32, mu_l: f32) -> f32 {
    return 0.31830989 * mu_l * factor;
}

// ---- of self-tests --------------------------------------------------------------------------------------------

// Where a vector of a self-test looks.
struct StratiformSight {
    mu_l: f32,
    mu_v: f32,
    v: f32,
    tau: f32,
}

// 1 if value is off by more than 1e-4 (0.02 + |expected|), else 0.
fn stratiform_radiance_wrong(value: f32, expected: f32) -> u32 {
    return select(1u, 0u, abs(value - expected) <= 1e-4 * (0.02 + abs(expected)));
}
