// ---- parameters ----------------------------------------------------------------------------------------------

struct StratiformParameters {
    b: f32,
    c: f32,
    kappa_c: f32,
    t: f32,
    r: f32,
}

// The table's row i: every angle in rising theta_l.
fn stratiform_node(i: u32) -> StratiformParameters {
    switch i {
@NODES@
    }
}

// mu_l of the table's row i.
fn stratiform_node_mu(i: u32) -> f32 {
    switch i {
@NODE_MUS@
    }
}

// p * q / (q + (p - q) * w): 1/p to 1/q linearly.
fn stratiform_mix_reciprocal(p: f32, q: f32, w: f32) -> f32 {
    return p * q / (q + (p - q) * w);
}

// The parameters at mu_l: between rows b, t, 1/c, 1/kappa_c and 1/r are linear in mu_l.
fn stratiform_parameters(mu_l: f32) -> StratiformParameters {
    let i = @INTERVAL@;
    let mu_a = stratiform_node_mu(i);
    let mu_b = stratiform_node_mu(i + 1u);
    let w = (mu_a - mu_l) / (mu_a - mu_b);
    let p = stratiform_node(i);
    let q = stratiform_node(i + 1u);
    return StratiformParameters(
        p.b + (q.b - p.b) * w,
        stratiform_mix_reciprocal(p.c, q.c, w),
        stratiform_mix_reciprocal(p.kappa_c, q.kappa_c, w),
        p.t + (q.t - p.t) * w,
        stratiform_mix_reciprocal(p.r, q.r, w),
    );
}

// The parameters of diffuse light.
fn stratiform_diffuse_parameters() -> StratiformParameters {
    return @DIFFUSE@;
}

// ---- brackets without cancellation, y >= 0 ---------------------------------------------------------------------

// What the fluxes are made of: exp(-y), 1 - exp(-y), y - 1 + exp(-y), 1 - (1 + y) exp(-y).
struct StratiformBrackets {
    decay: f32,
    rise: f32,
    twice_back: f32,
    once_each: f32,
}

// (exp(-y) - 1 + y) / y^2 for 0 <= y <= 1, through its values at Chebyshev's points; error below 1e-8 of it.
fn stratiform_exp_tail(y: f32) -> f32 {
    var sum = 0.000016928128;
    sum = sum * y - 0.00018832476;
    sum = sum * y + 0.0013822416;
    sum = sum * y - 0.00833105;
    sum = sum * y + 0.04166629;
    sum = sum * y - 0.16666664;
    return sum * y + 0.5;
}

// 1 - exp(-y)
fn stratiform_rise(y: f32) -> f32 {
    if (y < 1.0) {
        return y - y * y * stratiform_exp_tail(y);
    }
    return 1.0 - exp(-y);
}

// All of them.
fn stratiform_brackets(y: f32) -> StratiformBrackets {
    if (y < 1.0) {
        let back = y * y * stratiform_exp_tail(y);
        let rise = y - back;
        return StratiformBrackets(1.0 - rise, rise, back, y * y - (1.0 + y) * back);
    }
    let decay = exp(-y);
    return StratiformBrackets(decay, 1.0 - decay, (y - 1.0) + decay, 1.0 - (1.0 + y) * decay);
}

// ---- the exponential integral E_3, for diffuse light -----------------------------------------------------------

// x^2 E_1(x) for 0 <= x <= 1.
fn stratiform_square_times_exponential_integral(x: f32) -> f32 {
    if (x <= 0.0) {
        return 0.0;
    }
    var sum = 1.0;
    for (var k = @E1_TERMS@.0; k > 1.5; k -= 1.0) {
        sum = 1.0 - x * ((k - 1.0) / (k * k)) * sum;
    }
    return x * x * (x * sum - 0.5772157 - log(x));
}

// E_3(x) for x >= 1.
fn stratiform_exponential_integral_far(x: f32) -> f32 {
    var fraction = x + @E3_START@.0;
    for (var k = @E3_DEPTH@.0; k > 0.5; k -= 1.0) {
        fraction = x + (2.0 * k + 1.0) - k * (k + 2.0) / fraction;
    }
    return exp(-x) / fraction;
}

// 2 E_3(x), the unscattered share of diffuse light.
fn stratiform_diffuse_unscattered(x: f32) -> f32 {
    if (x < 1.0) {
        return (1.0 - x) * exp(-x) + stratiform_square_times_exponential_integral(x);
    }
    return 2.0 * stratiform_exponential_integral_far(x);
}

// 1 - 2 E_3(x)
fn stratiform_diffuse_extinguished(x: f32) -> f32 {
    if (x < 1.0) {
        return stratiform_rise(x) + (x * exp(-x) - stratiform_square_times_exponential_integral(x));
    }
    return 1.0 - 2.0 * stratiform_exponential_integral_far(x);
}

// ---- fluxes ----------------------------------------------------------------------------------------------------

// Shares of the incident flux. three_plus are differences of the other terms: they fall below 0 where those do not
// fit together, and are not clamped.
struct StratiformFluxes {
    t_ms: f32,
    r_ms: f32,
    t_zero: f32,
    t_one: f32,
    t_two: f32,
    t_three_plus: f32,
    r_one: f32,
    r_two: f32,
    r_three_plus: f32,
}

// All fluxes for given parameters, t_zero the unscattered and extinguished the remaining share.
fn stratiform_fluxes(p: StratiformParameters, t_zero: f32, extinguished: f32, tau: f32) -> StratiformFluxes {
    let onset = stratiform_rise(p.c * tau);
    let denominator = 1.0 + STRATIFORM_SLOPE * tau;
    let t_ms = (1.0 - (1.0 - p.b) * onset) / denominator;
    let r_ms = (STRATIFORM_SLOPE * tau + (1.0 - p.b) * onset) / denominator;
    let x = p.kappa_c * tau;
    let k = stratiform_brackets(x);
    // Those of 2 x.
    let rise = k.rise * (1.0 + k.decay);
    let twice_back = 2.0 * k.twice_back + k.rise * k.rise;
    let once_each = k.rise * k.rise + 2.0 * k.decay * k.once_each;
    let t_one = p.t * x * k.decay;
    let r_one = 0.5 * p.r * rise;
    let t_two = 0.5 * (p.t * x) * t_one + 0.25 * p.r * p.r * (k.decay * twice_back);
    let r_two = 0.5 * p.r * p.t * once_each;
    let scattered = select(t_ms - t_zero, extinguished - r_ms, r_ms < 0.5);
    return StratiformFluxes(
        t_ms, r_ms, t_zero, t_one, t_two, scattered - t_one - t_two, r_one, r_two, r_ms - r_one - r_two,
    );
}

// A beam at mu_l in [0, 1] on optical thickness tau in [0, 1e6].
fn stratiform_beam(mu_l: f32, tau: f32) -> StratiformFluxes {
    let depth = STRATIFORM_KAPPA_S * tau;
    var t_zero = select(1.0, 0.0, tau > 0.0);
    var extinguished = 1.0 - t_zero;
    if (mu_l > 0.0) {
        let k = stratiform_brackets(depth / mu_l);
        t_zero = k.decay;
        extinguished = k.rise;
    }
    return stratiform_fluxes(stratiform_parameters(mu_l), t_zero, extinguished, tau);
}

// Uniform light from the whole upper hemisphere on optical thickness tau in [0, 1e6].
fn stratiform_diffuse(tau: f32) -> StratiformFluxes {
    let depth = STRATIFORM_KAPPA_S * tau;
    return stratiform_fluxes(
        stratiform_diffuse_parameters(),
        stratiform_diffuse_unscattered(depth),
        stratiform_diffuse_extinguished(depth),
        tau,
    );
}

