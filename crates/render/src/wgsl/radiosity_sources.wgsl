// Means over a texel of the exchange: the cloud's diffuse source and albedo, the ground's direct light. A workgroup per texel.
// The accumulators start from zero.

@group(0) @binding(1) var<storage, read> thickness_m: array<f32>;
@group(0) @binding(2) var<storage, read> direct: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read_write> cloud_source: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> cloud_albedo: array<vec4<f32>>;
@group(0) @binding(5) var<storage, read_write> ground_source: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read_write> ground_indirect: array<vec4<f32>>;
@group(0) @binding(7) var<storage, read_write> cloud_from_ground: array<vec4<f32>>;

// What a texel takes the mean of.
struct Sample {
    // T_3+ of the sun, T_ms and R_ms of diffuse light.
    cloud: vec4<f32>,
    // Direct light of the ground.
    ground: vec4<f32>,
}

fn sampled(point: vec2<f32>) -> Sample {
    let c = cell_at(point, exchange.field_side);
    let k = c.corners;
    let h = bilinear(vec4<f32>(thickness_m[k.x], thickness_m[k.y], thickness_m[k.z], thickness_m[k.w]), c.at);
    let beam = stratiform_beam(exchange.sun.w, exchange.sky.w * h);
    let diffuse = stratiform_diffuse(exchange.sky.w * h);
    let ground = mix(mix(direct[k.x], direct[k.y], c.at.x), mix(direct[k.z], direct[k.w], c.at.x), c.at.y);
    return Sample(vec4<f32>(beam.t_three_plus, diffuse.t_ms, diffuse.r_ms, 0.0), ground);
}

@compute @workgroup_size(8, 8)
fn radiosity_sources(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) local: u32,
) {
    let n = exchange.samples;
    let step = 1.0 / f32(exchange.side * n);
    var cloud = vec4<f32>();
    var ground = vec4<f32>();
    for (var y = id.y; y < n; y += 8u) {
        for (var x = id.x; x < n; x += 8u) {
            let here = sampled((vec2<f32>(group.xy * n + vec2<u32>(x, y)) + 0.5) * step);
            cloud += here.cloud;
            ground += here.ground;
        }
    }
    let points = f32(n * n);
    let cloud_mean = sum_of_group(local, cloud) / points;
    let ground_mean = sum_of_group(local, ground) / points;
    if (local == 0u) {
        let texel = group.y * exchange.side + group.x;
        let source = cloud_mean.x * exchange.source_mu * exchange.sun.rgb + cloud_mean.y * exchange.sky.rgb;
        cloud_source[texel] = vec4<f32>(source, 0.0);
        cloud_albedo[texel] = vec4<f32>(vec3<f32>(cloud_mean.z), 0.0);
        ground_source[texel] = ground_mean;
        ground_indirect[texel] = vec4<f32>();
        cloud_from_ground[texel] = vec4<f32>();
    }
}
