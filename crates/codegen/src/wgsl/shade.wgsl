// (1 - g) of this cloud: tau times this is tau'. STRATIFORM_KAPPA_S is its 1 - P_f.
const STRATIFORM_SIMILARITY: f32 = @SIMILARITY@;

// The factors c_k of one face at one thickness, each named by what it multiplies: products of s = mu_l + mu_v,
// p = mu_l mu_v and c = cosTheta.
struct StratiformShadeFactors {
    one: f32,
    s: f32,
    p: f32,
    c: f32,
    ss: f32,
    sp: f32,
    pp: f32,
    sc: f32,
    pc: f32,
    cc: f32,
    ccc: f32,
    cccc: f32,
    sss: f32,
    ssc: f32,
    scc: f32,
    pcc: f32,
}

// ---- the rest: light that was scattered twice or more, over scaled = tau' = (1 - g) tau ------------------------------

// Of light that leaves the lit face. Depends on the thickness alone: where many sights share it, compute it once.
fn stratiform_shade_of_top(scaled: f32) -> StratiformShadeFactors {
    let x = scaled / (1.0 + scaled) - 0.5;
    return StratiformShadeFactors(
@TOP@
    );
}

// Of light that leaves the other face.
fn stratiform_shade_of_bottom(scaled: f32) -> StratiformShadeFactors {
    let x = scaled / (1.0 + scaled) - 0.5;
    return StratiformShadeFactors(
@BOTTOM@
    );
}

// The fitted factor: exp(sum of c_k B_k).
fn stratiform_shade_factor(k: StratiformShadeFactors, mu_l: f32, mu_v: f32, v: f32) -> f32 {
    let s = mu_l + mu_v;
    let p = mu_l * mu_v;
    let c = 1.0 - v;
    let even = k.one + s * (k.s + s * (k.ss + s * k.sss)) + p * (k.p + k.sp * s + k.pp * p);
    let once = k.c + s * (k.sc + k.ssc * s) + k.pc * p;
    let twice = k.cc + k.scc * s + k.pcc * p + c * (k.ccc + k.cccc * c);
    return exp(even + c * (once + c * twice));
}

// What it multiplies at the lit face: single precision holds the limits of thin, thick and grazing.
fn stratiform_shade_envelope(mu_l: f32, mu_v: f32, scaled: f32) -> f32 {
    let sun = stratiform_leaning(mu_l);
    let view = stratiform_leaning(mu_v);
    let rise = 1.3333333 * scaled * (sun + view);
    let share = rise / (sun * view + rise);
    return share * share / (sun + view);
}

// Reflectance factor of light that was scattered twice or more by more than theta_f and leaves the lit face.
fn stratiform_shade_more_top(k: StratiformShadeFactors, mu_l: f32, mu_v: f32, v: f32, scaled: f32) -> f32 {
    return stratiform_shade_envelope(mu_l, mu_v, scaled) * stratiform_shade_factor(k, mu_l, mu_v, v);
}

// The same at the other face.
fn stratiform_shade_more_bottom(k: StratiformShadeFactors, mu_l: f32, mu_v: f32, v: f32, scaled: f32) -> f32 {
    let envelope = stratiform_shade_envelope(mu_l, mu_v, scaled) / (1.0 + 0.7 * scaled);
    return envelope * stratiform_shade_factor(k, mu_l, mu_v, v);
}

// ---- single scattering, over depth = (1 - P_f) tau and wide = P_S(v) --------------------------------------------------

// Reflectance factor of light that was scattered once by more than theta_f and leaves the lit face.
fn stratiform_shade_once_top(mu_l: f32, mu_v: f32, wide: f32, depth: f32) -> f32 {
    let w = stratiform_returned(mu_l, mu_v, depth);
    return 0.25 * wide * w.once;
}

// The same at the other face.
fn stratiform_shade_once_bottom(mu_l: f32, mu_v: f32, wide: f32, depth: f32) -> f32 {
    let w = stratiform_through(mu_l, mu_v, depth);
    return 0.25 * wide * w.once;
}

// ---- radiance --------------------------------------------------------------------------------------------------------

// Reflectance factor of all light that leaves the lit face at mu_v, v = 1 - cosTheta, with the k of this tau.
fn stratiform_shade_top_with(k: StratiformShadeFactors, mu_l: f32, mu_v: f32, v: f32, tau: f32) -> f32 {
    return stratiform_shade_once_top(mu_l, mu_v, stratiform_phase_modified(v), STRATIFORM_KAPPA_S * tau)
        + stratiform_shade_more_top(k, mu_l, mu_v, v, STRATIFORM_SIMILARITY * tau);
}

// Reflectance factor of all light that leaves the other face; the sun's disc and the halo around it are not in it.
fn stratiform_shade_bottom_with(k: StratiformShadeFactors, mu_l: f32, mu_v: f32, v: f32, tau: f32) -> f32 {
    return stratiform_shade_once_bottom(mu_l, mu_v, stratiform_phase_modified(v), STRATIFORM_KAPPA_S * tau)
        + stratiform_shade_more_bottom(k, mu_l, mu_v, v, STRATIFORM_SIMILARITY * tau);
}

// Reflectance factor of all light that leaves the lit face at mu_v, v = 1 - cosTheta.
fn stratiform_shade_top(mu_l: f32, mu_v: f32, v: f32, tau: f32) -> f32 {
    let k = stratiform_shade_of_top(STRATIFORM_SIMILARITY * tau);
    return stratiform_shade_top_with(k, mu_l, mu_v, v, tau);
}

// Reflectance factor of all light that leaves the other face; the sun's disc and the halo around it are not in it.
fn stratiform_shade_bottom(mu_l: f32, mu_v: f32, v: f32, tau: f32) -> f32 {
    let k = stratiform_shade_of_bottom(STRATIFORM_SIMILARITY * tau);
    return stratiform_shade_bottom_with(k, mu_l, mu_v, v, tau);
}

// ---- self-test ---------------------------------------------------------------------------------------------------

// Where vector i looks.
fn stratiform_shade_test_sight(i: u32) -> StratiformSight {
    switch i {
@SIGHTS@
    }
}

// What the model gives for vector i in double precision at the lit face.
fn stratiform_shade_test_top(i: u32) -> f32 {
    switch i {
@EXPECTED_TOP@
    }
}

// At the other face.
fn stratiform_shade_test_bottom(i: u32) -> f32 {
    switch i {
@EXPECTED_BOTTOM@
    }
}

// How many of the self-test's values are wrong: 0 if this file and those that it needs work together.
fn stratiform_shade_self_test() -> u32 {
    var wrong = 0u;
    for (var i = 0u; i < @COUNT@u; i += 1u) {
        let s = stratiform_shade_test_sight(i);
        let top = stratiform_shade_top(s.mu_l, s.mu_v, s.v, s.tau);
        let bottom = stratiform_shade_bottom(s.mu_l, s.mu_v, s.v, s.tau);
        wrong += stratiform_radiance_wrong(top, stratiform_shade_test_top(i));
        wrong += stratiform_radiance_wrong(bottom, stratiform_shade_test_bottom(i));
    }
    return wrong;
}
