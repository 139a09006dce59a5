// ---- phase functions over the effective radius ---------------------------------------------------------------------

// Row of P of the first radius in the phase table, below the two rows of one cloud; P_S convolved with itself follows.
const STRATIFORM_FAMILY_PHASE_ROW: u32 = 2u;
const STRATIFORM_FAMILY_SQUARED_ROW: u32 = @SQUARED_ROW@u;

const STRATIFORM_FAMILY_PHASE_TABLES: u32 = @TABLES@u;

// Between which radii an effective radius lies: the first one, and the weight of the next.
struct StratiformFamilyRadii {
    table: u32,
    weight: f32,
}

// Effective radius j, um.
fn stratiform_family_phase_radius_um(j: u32) -> f32 {
    switch j {
@RADII@
    }
}

// P_f of radius j.
fn stratiform_family_forward_node(j: u32) -> f32 {
    switch j {
@FORWARD@
    }
}

// Between which radii radius_um lies, linear in its logarithm.
fn stratiform_family_phase_radii(radius_um: f32) -> StratiformFamilyRadii {
    var table = 0u;
    for (var j = 1u; j < STRATIFORM_FAMILY_PHASE_TABLES - 1u; j += 1u) {
        table += select(0u, 1u, radius_um > stratiform_family_phase_radius_um(j));
    }
    let first = log(stratiform_family_phase_radius_um(table));
    let next = log(stratiform_family_phase_radius_um(table + 1u));
    return StratiformFamilyRadii(table, (log(radius_um) - first) / (next - first));
}

// Rows from `row` on at v and at radius_um.
fn stratiform_family_phase_row(row: u32, v: f32, radius_um: f32) -> f32 {
    let radii = stratiform_family_phase_radii(radius_um);
    let place = stratiform_phase_place(v);
    let p = stratiform_phase_row(row + radii.table, place);
    let q = stratiform_phase_row(row + radii.table + 1u, place);
    return p + (q - p) * radii.weight;
}

// P_f at radius_um.
fn stratiform_family_forward_fraction(radius_um: f32) -> f32 {
    let radii = stratiform_family_phase_radii(radius_um);
    let p = stratiform_family_forward_node(radii.table);
    return p + (stratiform_family_forward_node(radii.table + 1u) - p) * radii.weight;
}

// P of the full medium at v = 1 - cosTheta in a cloud of effective radius radius_um.
fn stratiform_family_phase(v: f32, radius_um: f32) -> f32 {
    return stratiform_family_phase_row(STRATIFORM_FAMILY_PHASE_ROW, v, radius_um);
}

// P_S of the modified medium there.
fn stratiform_family_phase_modified(v: f32, radius_um: f32) -> f32 {
    let wide = stratiform_family_phase(v, radius_um) / (1.0 - stratiform_family_forward_fraction(radius_um));
    return select(0.0, wide, v >= STRATIFORM_WIDE_EDGE);
}

// P_S convolved with itself on the sphere, there.
fn stratiform_family_phase_squared(v: f32, radius_um: f32) -> f32 {
    return stratiform_family_phase_row(STRATIFORM_FAMILY_SQUARED_ROW, v, radius_um);
}

// ---- self-test ---------------------------------------------------------------------------------------------------

// v, radius_um, and what P, P_S and P_S convolved with itself are in double precision.
struct StratiformFamilyPhaseVector {
    v: f32,
    radius_um: f32,
    full: f32,
    modified: f32,
    squared: f32,
}

// Vector i.
fn stratiform_family_phase_test_vector(i: u32) -> StratiformFamilyPhaseVector {
    switch i {
@TEST_VECTORS@
    }
}

// How many of the self-test's values are wrong: 0 if the table is in place.
fn stratiform_family_phase_self_test() -> u32 {
    var wrong = 0u;
    for (var i = 0u; i < @TEST_COUNT@u; i += 1u) {
        let s = stratiform_family_phase_test_vector(i);
        wrong += stratiform_phase_wrong(stratiform_family_phase(s.v, s.radius_um), s.full);
        wrong += stratiform_phase_wrong(stratiform_family_phase_modified(s.v, s.radius_um), s.modified);
        wrong += stratiform_phase_wrong(stratiform_family_phase_squared(s.v, s.radius_um), s.squared);
    }
    return wrong;
}
