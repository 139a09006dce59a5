// Share of scattering below theta_f.
const STRATIFORM_FORWARD_FRACTION: f32 = @FORWARD@;
// Columns: sin(Theta / 2) = sqrt(v / 2) in equal steps from 0. Rows: the optical path in equal steps from 0.
const STRATIFORM_HALO_COLUMNS: u32 = @COLUMNS@u;
const STRATIFORM_HALO_ROWS: u32 = @ROWS@u;
// Steps per sqrt(v), and per optical path.
const STRATIFORM_HALO_ACROSS: f32 = @ACROSS@;
const STRATIFORM_HALO_ALONG: f32 = @ALONG@;

// Distribution over the sphere, mean 1, of light that met two or more forward events on the optical path q.
fn stratiform_halo_shape(v: f32, q: f32) -> f32 {
    let across = sqrt(select(0.0, v, v > 0.0)) * STRATIFORM_HALO_ACROSS;
    if (across >= f32(STRATIFORM_HALO_COLUMNS - 1u)) {
        return 0.0;
    }
    let last = f32(STRATIFORM_HALO_ROWS - 1u);
    let place = q * STRATIFORM_HALO_ALONG;
    let along = select(last, place, place < last);
    let column = u32(across);
    let whole = u32(along);
    let row = select(STRATIFORM_HALO_ROWS - 2u, whole, whole < STRATIFORM_HALO_ROWS - 2u);
    let share = across - f32(column);
    let a = stratiform_halo_texel(row, column);
    let b = stratiform_halo_texel(row, column + 1u);
    let c = stratiform_halo_texel(row + 1u, column);
    let d = stratiform_halo_texel(row + 1u, column + 1u);
    let near_row = a + (b - a) * share;
    let far_row = c + (d - c) * share;
    return near_row + (far_row - near_row) * (along - f32(row));
}

// Reflectance factor of light that met one forward event: P of the full medium below theta_f.
fn stratiform_halo_once(mu_l: f32, mu_v: f32, v: f32, tau: f32) -> f32 {
    if (v >= STRATIFORM_WIDE_EDGE) {
        return 0.0;
    }
    let w = stratiform_through(mu_l, mu_v, tau);
    return 0.25 * stratiform_phase(v) * w.once;
}

// Reflectance factor of light that met two or more, all of them forward, on the mean path of sun and view.
fn stratiform_halo_several(mu_l: f32, mu_v: f32, v: f32, tau: f32) -> f32 {
    let sun = stratiform_leaning(mu_l);
    let view = stratiform_leaning(mu_v);
    let q = 0.5 * (tau / sun + tau / view);
    let y = STRATIFORM_FORWARD_FRACTION * q;
    let k = stratiform_brackets(y);
    let weight = exp(y - q) * k.once_each;
    return 0.5 * weight * stratiform_halo_shape(v, q) / (sun + view);
}

// Reflectance factor of all light that met forward events only: what the libraries of radiance leave out around the
// sun. There is none at the lit face.
fn stratiform_halo(mu_l: f32, mu_v: f32, v: f32, tau: f32) -> f32 {
    return stratiform_halo_once(mu_l, mu_v, v, tau) + stratiform_halo_several(mu_l, mu_v, v, tau);
}

// ---- self-test ---------------------------------------------------------------------------------------------------

// Where vector i looks.
fn stratiform_halo_test_sight(i: u32) -> StratiformSight {
    switch i {
@SIGHTS@
    }
}

// What the model gives for vector i in double precision.
fn stratiform_halo_test_expected(i: u32) -> f32 {
    switch i {
@EXPECTED@
    }
}

// How many of the self-test's values are wrong: 0 if the table is in place.
fn stratiform_halo_self_test() -> u32 {
    var wrong = 0u;
    for (var i = 0u; i < @COUNT@u; i += 1u) {
        let s = stratiform_halo_test_sight(i);
        let found = stratiform_halo(s.mu_l, s.mu_v, s.v, s.tau);
        wrong += stratiform_radiance_wrong(found, stratiform_halo_test_expected(i));
    }
    return wrong;
}
