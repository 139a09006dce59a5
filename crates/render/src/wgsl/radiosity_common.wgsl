// What every pass of the exchange between ground and cloud reads. The twin is radiosity/plan.rs.

struct Exchange {
    // Irradiance normal to the sun's beam; w: mu_l.
    sun: vec4<f32>,
    // Irradiance of a horizontal plane under the clear sky; w: extinction per metre.
    sky: vec4<f32>,
    // From a point of the ground to where its sunlight passes the cloud's base, in periods.
    offset: vec2<f32>,
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

// Four neighbours of a point, in periods, on a periodic map, and where it lies between them.
struct Cell {
    corners: vec4<u32>,
    at: vec2<f32>,
}

fn cell(point: vec2<f32>, side: u32) -> Cell {
    let scaled = (point - floor(point)) * f32(side) - 0.5;
    let below = floor(scaled);
    let n = i32(side);
    let west = (vec2<i32>(below) + n) % n;
    let east = (west + 1) % n;
    let corners = vec4<i32>(west.y * n + west.x, west.y * n + east.x, east.y * n + west.x, east.y * n + east.x);
    return Cell(vec4<u32>(corners), scaled - below);
}
