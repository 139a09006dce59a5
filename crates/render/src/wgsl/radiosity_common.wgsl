// What every pass of the exchange between ground and cloud reads. The twin is radiosity/plan.rs.

struct Exchange {
    // Irradiance normal to the sun's beam; w: mu_l.
    sun: vec4<f32>,
    // Irradiance of a horizontal plane under the clear sky; w: extinction per metre.
    sky: vec4<f32>,
    // From a point of the ground to where its sunlight passes the cloud's base: texels of the height field, and what is left of one.
    whole: vec2<u32>,
    fraction: vec2<f32>,
    // The factor of the sun in the cloud's diffuse source: mu_l.
    source_mu: f32,
    // Texels a side of the height field.
    field_side: u32,
    // Texels a side of the exchange.
    side: u32,
    // Points a side that a texel of the exchange is the mean of.
    samples: u32,
}

@group(0) @binding(0) var<uniform> exchange: Exchange;

var<workgroup> partial: array<vec4<f32>, 64>;

// The sum over the workgroup's 64 invocations, in the same order always; 0 in all but the first.
fn sum_of_group(local: u32, mine: vec4<f32>) -> vec4<f32> {
    partial[local] = mine;
    workgroupBarrier();
    for (var width = 32u; width > 0u; width /= 2u) {
        if (local < width) {
            partial[local] += partial[local + width];
        }
        workgroupBarrier();
    }
    let sum = partial[0];
    workgroupBarrier();
    return select(vec4<f32>(), sum, local == 0u);
}

// Texel (x, y) of a periodic map, its eastern and northern neighbours, and where a point lies between their centres.
struct Cell {
    corners: vec4<u32>,
    at: vec2<f32>,
}

fn cell(west: vec2<u32>, at: vec2<f32>, side: u32) -> Cell {
    let w = west % side;
    let e = (w + 1u) % side;
    return Cell(vec4<u32>(w.y * side + w.x, w.y * side + e.x, e.y * side + w.x, e.y * side + e.x), at);
}

// That of a point in periods, 0 to 1.
fn cell_at(point: vec2<f32>, side: u32) -> Cell {
    let scaled = point * f32(side) - 0.5;
    let below = floor(scaled);
    return cell(vec2<u32>(vec2<i32>(below) + i32(side)), scaled - below, side);
}

fn bilinear(corners: vec4<f32>, at: vec2<f32>) -> f32 {
    return mix(mix(corners.x, corners.y, at.x), mix(corners.z, corners.w, at.x), at.y);
}
