// The host binds phase_warped.csv: @COUNT@ values of column p, then @COUNT@ of column p_squared. Change group and
// binding to suit.
@group(0) @binding(0) var<storage, read> stratiform_phase_table: array<f32>;

const STRATIFORM_PHASE_COUNT: u32 = @COUNT@u;
// P_S = P / (1 - P_f) where 1 - cosTheta >= 1 - cos(theta_f), and 0 below.
const STRATIFORM_WIDE_SCALE: f32 = @WIDE_SCALE@;
const STRATIFORM_WIDE_EDGE: f32 = @WIDE_EDGE@;

// acos(1 - v) for v = 1 - cosTheta in [0, 2]; error below 1e-7 of pi, relative at both ends. Abramowitz & Stegun 1964, 4.4.46.
fn stratiform_arc(v: f32) -> f32 {
    let near = min(v, 2.0 - v);
    let x = 1.0 - near;
    var sum = -0.0012624911;
    sum = sum * x + 0.0066700901;
    sum = sum * x - 0.0170881256;
    sum = sum * x + 0.0308918810;
    sum = sum * x - 0.0501743046;
    sum = sum * x + 0.0889789874;
    sum = sum * x - 0.2145988016;
    sum = sum * x + 1.5707963050;
    let arc = sqrt(max(near, 0.0)) * sum;
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

fn stratiform_phase_lookup(row: u32, v: f32) -> f32 {
    let place = stratiform_phase_coordinate(stratiform_arc(v)) * f32(STRATIFORM_PHASE_COUNT - 1u);
    let cell = min(u32(place), STRATIFORM_PHASE_COUNT - 2u);
    let first = stratiform_phase_table[row * STRATIFORM_PHASE_COUNT + cell];
    let second = stratiform_phase_table[row * STRATIFORM_PHASE_COUNT + cell + 1u];
    return first + (second - first) * (place - f32(cell));
}

// P of the full medium at v = 1 - cosTheta.
fn stratiform_phase(v: f32) -> f32 {
    return stratiform_phase_lookup(0u, v);
}

// P_S of the modified medium at v = 1 - cosTheta.
fn stratiform_phase_modified(v: f32) -> f32 {
    return select(0.0, STRATIFORM_WIDE_SCALE * stratiform_phase(v), v >= STRATIFORM_WIDE_EDGE);
}

// P_S convolved with itself on the sphere, at v = 1 - cosTheta.
fn stratiform_phase_squared(v: f32) -> f32 {
    return stratiform_phase_lookup(1u, v);
}
