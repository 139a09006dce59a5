// Values of each row.
const STRATIFORM_PHASE_COUNT: u32 = @COUNT@u;
// P_S = P / (1 - P_f) where 1 - cosTheta >= 1 - cos(theta_f), and 0 below.
const STRATIFORM_WIDE_SCALE: f32 = @WIDE_SCALE@;
const STRATIFORM_WIDE_EDGE: f32 = @WIDE_EDGE@;

// Where a row is read: between texels cell and cell + 1, at the share of the second.
struct StratiformPlace {
    cell: u32,
    share: f32,
}

// acos(1 - v) for v = 1 - cosTheta in [0, 1]; relative error below 1e-7 of pi / 2. Abramowitz & Stegun 1964, 4.4.46.
fn stratiform_near_arc(v: f32) -> f32 {
    let x = 1.0 - v;
    var sum = -0.0012624911;
    sum = sum * x + 0.0066700901;
    sum = sum * x - 0.0170881256;
    sum = sum * x + 0.0308918810;
    sum = sum * x - 0.0501743046;
    sum = sum * x + 0.0889789874;
    sum = sum * x - 0.2145988016;
    sum = sum * x + 1.5707963050;
    return sqrt(max(v, 0.0)) * sum;
}

// acos(1 - v) for v in [0, 2].
fn stratiform_arc(v: f32) -> f32 {
    let arc = stratiform_near_arc(min(v, 2.0 - v));
    return select(3.14159265 - arc, arc, v <= 1.0);
}

// Table coordinate in [0, 1] of Theta in [0, pi]: steps shrink towards the forward peak and towards the glory.
fn stratiform_phase_coordinate(theta: f32) -> f32 {
    let back = 3.14159265 - theta;
    if (theta < 1.57079633) {
        return sqrt(max(theta, 0.0) * 0.159154943);
    }
    return 1.0 - sqrt(max(back, 0.0) * 0.159154943);
}

// Its inverse.
fn stratiform_phase_angle(coordinate: f32) -> f32 {
    let back = 1.0 - coordinate;
    if (coordinate < 0.5) {
        return 6.28318531 * coordinate * coordinate;
    }
    return 3.14159265 - 6.28318531 * back * back;
}

// Where v is in every row.
fn stratiform_phase_place(v: f32) -> StratiformPlace {
    let nearest = sqrt(stratiform_near_arc(min(v, 2.0 - v)) * 0.159154943);
    let place = select(1.0 - nearest, nearest, v <= 1.0) * f32(STRATIFORM_PHASE_COUNT - 1u);
    let whole = u32(place);
    let cell = select(STRATIFORM_PHASE_COUNT - 2u, whole, whole < STRATIFORM_PHASE_COUNT - 2u);
    return StratiformPlace(cell, place - f32(cell));
}

// Row `row` there, linear in the coordinate.
fn stratiform_phase_row(row: u32, place: StratiformPlace) -> f32 {
    let first = stratiform_phase_texel(row, place.cell);
    let second = stratiform_phase_texel(row, place.cell + 1u);
    return first + (second - first) * place.share;
}

// P of the full medium at v = 1 - cosTheta.
fn stratiform_phase(v: f32) -> f32 {
    return stratiform_phase_row(0u, stratiform_phase_place(v));
}

// P_S of the modified medium at v, whose place is given.
fn stratiform_phase_modified_at(place: StratiformPlace, v: f32) -> f32 {
    return select(0.0, STRATIFORM_WIDE_SCALE * stratiform_phase_row(0u, place), v >= STRATIFORM_WIDE_EDGE);
}

// P_S of the modified medium at v = 1 - cosTheta.
fn stratiform_phase_modified(v: f32) -> f32 {
    return stratiform_phase_modified_at(stratiform_phase_place(v), v);
}

// P_S convolved with itself on the sphere, at a place.
fn stratiform_phase_squared_at(place: StratiformPlace) -> f32 {
    return stratiform_phase_row(1u, place);
}

// P_S convolved with itself on the sphere, at v = 1 - cosTheta.
fn stratiform_phase_squared(v: f32) -> f32 {
    return stratiform_phase_squared_at(stratiform_phase_place(v));
}

// ---- self-test ---------------------------------------------------------------------------------------------------

// v of vector i.
fn stratiform_phase_test_v(i: u32) -> f32 {
    switch i {
@TEST_V@
    }
}

// P of the full medium there, in double precision.
fn stratiform_phase_test_full(i: u32) -> f32 {
    switch i {
@TEST_P@
    }
}

// P_S convolved with itself there.
fn stratiform_phase_test_squared(i: u32) -> f32 {
    switch i {
@TEST_SQUARED@
    }
}

// 1 if value is off by more than 1e-4 of expected, else 0.
fn stratiform_phase_wrong(value: f32, expected: f32) -> u32 {
    return select(1u, 0u, abs(value - expected) <= 1e-4 * expected);
}

// How many of the self-test's values are wrong: 0 if the table is in place.
fn stratiform_phase_self_test() -> u32 {
    var wrong = 0u;
    for (var i = 0u; i < @TEST_COUNT@u; i += 1u) {
        let v = stratiform_phase_test_v(i);
        wrong += stratiform_phase_wrong(stratiform_phase(v), stratiform_phase_test_full(i));
        wrong += stratiform_phase_wrong(stratiform_phase_squared(v), stratiform_phase_test_squared(i));
    }
    return wrong;
}
