// A picture in a window: one triangle over all of it; each fragment takes the pixel under it. `fn shown(radiance, exposure_ev)` comes
// from the caller. What is no number, or marked 0 by its fourth number, is magenta.
struct Frame {
    picture: vec2<u32>,
    window: vec2<u32>,
    exposure_ev: f32,
    // 1 where the surface encodes sRGB itself.
    encodes: u32,
}

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read> pixels: array<vec4<f32>>;

@vertex
fn corner(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

fn finite(v: vec3<f32>) -> bool {
    return all((bitcast<vec3<u32>>(v) & vec3<u32>(0x7f800000u)) != vec3<u32>(0x7f800000u));
}

// The inverse of the sRGB transfer curve.
fn decoded(v: vec3<f32>) -> vec3<f32> {
    return select(pow((v + 0.055) / 1.055, vec3<f32>(2.4)), v / 12.92, v <= vec3<f32>(0.04045));
}

@fragment
fn colour(@builtin(position) at: vec4<f32>) -> @location(0) vec4<f32> {
    let place = vec2<u32>(at.xy * vec2<f32>(frame.picture) / vec2<f32>(frame.window));
    let nearest = min(place, frame.picture - 1u);
    let pixel = pixels[nearest.y * frame.picture.x + nearest.x];
    if (pixel.w == 0.0 || !finite(pixel.xyz)) {
        return vec4<f32>(1.0, 0.0, 1.0, 1.0);
    }
    let stored = shown(pixel.xyz, frame.exposure_ev);
    return vec4<f32>(select(stored, decoded(stored), frame.encodes == 1u), 1.0);
}
