// The thickness of the cloud, bilinear and periodic, in coordinates of texels: texel (i, j) has its centre at (i, j).
// `heights` holds side x side thicknesses in metres, then the pyramid of greatest thicknesses (pyramid.wgsl).
@group(0) @binding(3) var<storage, read> heights: array<f32>;

fn wrapped(i: i32, side: i32) -> i32 {
    return ((i % side) + side) % side;
}

// South-west, south-east, north-west, north-east of a cell.
fn corners(cell: vec2<i32>) -> vec4<f32> {
    let side = i32(view.side);
    let west = wrapped(cell.x, side);
    let south = wrapped(cell.y, side) * side;
    let east = wrapped(cell.x + 1, side);
    let north = wrapped(cell.y + 1, side) * side;
    return vec4<f32>(heights[south + west], heights[south + east], heights[north + west], heights[north + east]);
}

fn between(c: vec4<f32>, at: vec2<f32>) -> f32 {
    let south = c.x + (c.y - c.x) * at.x;
    let north = c.z + (c.w - c.z) * at.x;
    return south + (north - south) * at.y;
}

fn thickness(texel: vec2<f32>) -> f32 {
    let whole = floor(texel);
    return between(corners(vec2<i32>(whole)), texel - whole);
}

// Unit normal of the top, upwards: differences of thickness over one texel each way.
fn top_normal(texel: vec2<f32>) -> vec3<f32> {
    let step = view.extent / f32(view.side);
    let half_x = vec2<f32>(0.5, 0.0);
    let half_y = vec2<f32>(0.0, 0.5);
    let east = (thickness(texel + half_x) - thickness(texel - half_x)) / step;
    let north = (thickness(texel + half_y) - thickness(texel - half_y)) / step;
    return normalize(vec3<f32>(-east, -north, 1.0));
}
