// ---- self-test ---------------------------------------------------------------------------------------------------

// Vectors of the self-test: thin, thick and grazing, at and between the table's angles, diffuse.
const STRATIFORM_SELF_TEST_COUNT: u32 = @COUNT@u;

// mu_l of vector i; -1 stands for diffuse light.
fn stratiform_self_test_mu(i: u32) -> f32 {
    switch i {
@MUS@
    }
}

// tau of vector i.
fn stratiform_self_test_tau(i: u32) -> f32 {
    switch i {
@TAUS@
    }
}

// What the model gives for vector i in double precision.
fn stratiform_self_test_expected(i: u32) -> StratiformFluxes {
    switch i {
@FLUXES@
    }
}

// 1 if value is off by more than 2e-5 (0.1 + |expected|), else 0.
fn stratiform_wrong(value: f32, expected: f32) -> u32 {
    return select(1u, 0u, abs(value - expected) <= 2e-5 * (0.1 + abs(expected)));
}

// The fluxes of vector i.
fn stratiform_self_test_fluxes(i: u32) -> StratiformFluxes {
    let mu_l = stratiform_self_test_mu(i);
    let tau = stratiform_self_test_tau(i);
    if (mu_l < 0.0) {
        return stratiform_diffuse(tau);
    }
    return stratiform_beam(mu_l, tau);
}

// How many of the self-test's values are wrong: 0 if this file works as its author saw it work.
fn stratiform_self_test() -> u32 {
    var wrong = stratiform_wrong(stratiform_tau_from_metres_@CONVENTION@(@MEAN_FREE_PATH@), 1.0);
    for (var i = 0u; i < STRATIFORM_SELF_TEST_COUNT; i += 1u) {
        let f = stratiform_self_test_fluxes(i);
        let e = stratiform_self_test_expected(i);
        @COMPARE@
    }
    return wrong;
}
