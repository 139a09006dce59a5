// What a picture is of, for every pass that draws. Metres, unit vectors, linear sRGB; `position` is reduced by whole periods of the field
// in x and y, `albedo_at` by those of the ground's map.
struct View {
    position: vec3<f32>,
    pixel: f32,
    ahead: vec3<f32>,
    base: f32,
    right: vec3<f32>,
    most: f32,
    up: vec3<f32>,
    kappa: f32,
    sun: vec3<f32>,
    disc_versine: f32,
    sun_irradiance: vec3<f32>,
    extent: f32,
    disc_radiance: vec3<f32>,
    albedo_extent: f32,
    // Radiance of uniform light with the sky's irradiance.
    sky_mean: vec3<f32>,
    side: u32,
    // 1 - P_f of each channel.
    kept: vec3<f32>,
    albedo_side: u32,
    // Unit vector of the sun's azimuth.
    towards_sun: vec2<f32>,
    // Texels of the sky's table: columns and rows.
    sky_size: vec2<u32>,
    albedo_at: vec2<f32>,
    size: vec2<u32>,
    contributions: u32,
    emission_top: u32,
    emission_bottom: u32,
    depth: u32,
    normals: u32,
    top_level: u32,
    exchange_side: u32,
    reserved: u32,
    // Of each level of the pyramid: where it starts, and its texels a side.
    levels: array<vec4<u32>, 16>,
}

@group(0) @binding(2) var<uniform> view: View;
