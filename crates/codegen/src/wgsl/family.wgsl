// ---- tables over the effective radius ----------------------------------------------------------------------------

// Tables, and rows of each.
const STRATIFORM_FAMILY_TABLES: u32 = @TABLES@u;
const STRATIFORM_FAMILY_ROWS: u32 = @ROWS@u;
// The first and the last effective radius, um.
const STRATIFORM_FAMILY_SMALLEST_UM: f32 = @SMALLEST@;
const STRATIFORM_FAMILY_LARGEST_UM: f32 = @LARGEST@;

// What a cloud's droplets say of it at every angle: (1 - beta) / beta, the modified medium's extinction per unit of tau.
struct StratiformFamilyMedium {
    slope: f32,
    kappa_s: f32,
}

// Between which tables an effective radius lies: the first one, and the weight of the next.
struct StratiformFamilyPlace {
    table: u32,
    weight: f32,
}

// Effective radius of table j, um.
fn stratiform_family_radius_um(j: u32) -> f32 {
    switch j {
@RADII@
    }
}

// Row j * STRATIFORM_FAMILY_ROWS + i: angle i of the fluxes' table, at radius j.
fn stratiform_family_node(k: u32) -> StratiformParameters {
    switch k {
@NODES@
    }
}

// Diffuse light at radius j.
fn stratiform_family_diffuse_node(j: u32) -> StratiformParameters {
    switch j {
@DIFFUSE@
    }
}

// The medium of radius j.
fn stratiform_family_medium_node(j: u32) -> StratiformFamilyMedium {
    switch j {
@MEDIA@
    }
}

// ---- interpolation ----------------------------------------------------------------------------------------------

// b, t, 1/c, 1/kappa_c and 1/r linearly from p to q.
fn stratiform_family_mix(p: StratiformParameters, q: StratiformParameters, w: f32) -> StratiformParameters {
    return StratiformParameters(
        p.b + (q.b - p.b) * w,
        stratiform_mix_reciprocal(p.c, q.c, w),
        stratiform_mix_reciprocal(p.kappa_c, q.kappa_c, w),
        p.t + (q.t - p.t) * w,
        stratiform_mix_reciprocal(p.r, q.r, w),
    );
}

// radius_um^(-2/3), in which parameters are nearly linear.
fn stratiform_family_coordinate(radius_um: f32) -> f32 {
    return exp(-0.6666667 * log(radius_um));
}

// Where radius_um lies.
fn stratiform_family_place(radius_um: f32) -> StratiformFamilyPlace {
    var table = 0u;
    for (var j = 1u; j < STRATIFORM_FAMILY_TABLES - 1u; j += 1u) {
        table += select(0u, 1u, radius_um > stratiform_family_radius_um(j));
    }
    let first = stratiform_family_coordinate(stratiform_family_radius_um(table));
    let next = stratiform_family_coordinate(stratiform_family_radius_um(table + 1u));
    return StratiformFamilyPlace(table, (stratiform_family_coordinate(radius_um) - first) / (next - first));
}

// The medium at radius_um.
fn stratiform_family_medium(radius_um: f32) -> StratiformFamilyMedium {
    let place = stratiform_family_place(radius_um);
    let p = stratiform_family_medium_node(place.table);
    let q = stratiform_family_medium_node(place.table + 1u);
    return StratiformFamilyMedium(
        p.slope + (q.slope - p.slope) * place.weight,
        p.kappa_s + (q.kappa_s - p.kappa_s) * place.weight,
    );
}

// The parameters at mu_l and radius_um.
fn stratiform_family_parameters(mu_l: f32, radius_um: f32) -> StratiformParameters {
    var row = 0u;
    for (var i = 1u; i < STRATIFORM_FAMILY_ROWS - 1u; i += 1u) {
        row += select(0u, 1u, mu_l < stratiform_node_mu(i));
    }
    let mu_a = stratiform_node_mu(row);
    let w = (mu_a - mu_l) / (mu_a - stratiform_node_mu(row + 1u));
    let place = stratiform_family_place(radius_um);
    let k = place.table * STRATIFORM_FAMILY_ROWS + row;
    let next = k + STRATIFORM_FAMILY_ROWS;
    let p = stratiform_family_mix(stratiform_family_node(k), stratiform_family_node(k + 1u), w);
    let q = stratiform_family_mix(stratiform_family_node(next), stratiform_family_node(next + 1u), w);
    return stratiform_family_mix(p, q, place.weight);
}

// The parameters of diffuse light at radius_um.
fn stratiform_family_diffuse_parameters(radius_um: f32) -> StratiformParameters {
    let place = stratiform_family_place(radius_um);
    let p = stratiform_family_diffuse_node(place.table);
    return stratiform_family_mix(p, stratiform_family_diffuse_node(place.table + 1u), place.weight);
}

// ---- fluxes -----------------------------------------------------------------------------------------------------

// All fluxes for given parameters: the orders of stratiform_fluxes, the totals with this medium's slope.
fn stratiform_family_fluxes(
    p: StratiformParameters, slope: f32, t_zero: f32, extinguished: f32, tau: f32,
) -> StratiformFluxes {
    let f = stratiform_fluxes(p, t_zero, extinguished, tau);
    let onset = stratiform_rise(p.c * tau);
    let denominator = 1.0 + slope * tau;
    let t_ms = (1.0 - (1.0 - p.b) * onset) / denominator;
    let r_ms = (slope * tau + (1.0 - p.b) * onset) / denominator;
    let scattered = select(t_ms - t_zero, extinguished - r_ms, r_ms < 0.5);
    let t_three_plus = scattered - f.t_one - f.t_two;
    let r_three_plus = r_ms - f.r_one - f.r_two;
    return StratiformFluxes(t_ms, r_ms, t_zero, f.t_one, f.t_two, t_three_plus, f.r_one, f.r_two, r_three_plus);
}

// A beam at mu_l in [0, 1] on optical thickness tau in [0, 1e6] of a cloud of effective radius radius_um.
fn stratiform_family_beam(mu_l: f32, radius_um: f32, tau: f32) -> StratiformFluxes {
    let medium = stratiform_family_medium(radius_um);
    let depth = medium.kappa_s * tau;
    var t_zero = select(1.0, 0.0, tau > 0.0);
    var extinguished = 1.0 - t_zero;
    if (mu_l > 0.0) {
        let k = stratiform_brackets(depth / mu_l);
        t_zero = k.decay;
        extinguished = k.rise;
    }
    let p = stratiform_family_parameters(mu_l, radius_um);
    return stratiform_family_fluxes(p, medium.slope, t_zero, extinguished, tau);
}

// Uniform light from the whole upper hemisphere.
fn stratiform_family_diffuse(radius_um: f32, tau: f32) -> StratiformFluxes {
    let medium = stratiform_family_medium(radius_um);
    let depth = medium.kappa_s * tau;
    return stratiform_family_fluxes(
        stratiform_family_diffuse_parameters(radius_um),
        medium.slope,
        stratiform_diffuse_unscattered(depth),
        stratiform_diffuse_extinguished(depth),
        tau,
    );
}

// ---- self-test ---------------------------------------------------------------------------------------------------

// mu_l, effective radius in um and tau of a vector; mu_l = -1 stands for diffuse light.
struct StratiformFamilyVector {
    mu_l: f32,
    radius_um: f32,
    tau: f32,
}

// Vector i.
fn stratiform_family_test_vector(i: u32) -> StratiformFamilyVector {
    switch i {
@TEST_VECTORS@
    }
}

// What the model gives for it in double precision.
fn stratiform_family_test_expected(i: u32) -> StratiformFluxes {
    switch i {
@TEST_FLUXES@
    }
}

// The fluxes of vector i.
fn stratiform_family_test_fluxes(i: u32) -> StratiformFluxes {
    let s = stratiform_family_test_vector(i);
    if (s.mu_l < 0.0) {
        return stratiform_family_diffuse(s.radius_um, s.tau);
    }
    return stratiform_family_beam(s.mu_l, s.radius_um, s.tau);
}

// How many of the self-test's values are wrong: 0 if this file works as its author saw it work.
fn stratiform_family_self_test() -> u32 {
    var wrong = 0u;
    for (var i = 0u; i < @TEST_COUNT@u; i += 1u) {
        let f = stratiform_family_test_fluxes(i);
        let e = stratiform_family_test_expected(i);
        @COMPARE@
    }
    return wrong;
}
