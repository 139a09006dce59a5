// Means over a texel of the exchange: the cloud's diffuse source and albedo, the ground's direct light. A workgroup per texel.
// The accumulators start from zero.

@group(0) @binding(1) var<storage, read> thickness_m: array<f32>;
@group(0) @binding(2) var<storage, read> direct: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read_write> cloud_source: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> cloud_albedo: array<vec4<f32>>;
@group(0) @binding(5) var<storage, read_write> ground_source: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read_write> ground_indirect: array<vec4<f32>>;
@group(0) @binding(7) var<storage, read_write> cloud_from_ground: array<vec4<f32>>;

@compute @workgroup_size(64)
fn radiosity_sources(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let n = exchange.samples;
    let corner = group.xy * n;
    var cloud = vec4<f32>();
    var ground = vec4<f32>();
    for (var i = local; i < n * n; i += 64u) {
        let point = (vec2<f32>(corner + vec2<u32>(i % n, i / n)) + 0.5) / f32(exchange.side * n);
        let c = cell_at(point, exchange.field_side);
        let k = c.corners;
        let h = bilinear(vec4<f32>(thickness_m[k.x], thickness_m[k.y], thickness_m[k.z], thickness_m[k.w]), c.at);
        let tau = exchange.sky.w * h;
        let beam = stratiform_beam(exchange.sun.w, tau);
        let diffuse = stratiform_diffuse(tau);
        cloud += vec4<f32>(beam.t_three_plus, diffuse.t_ms, diffuse.r_ms, 0.0);
        ground += mix(mix(direct[k.x], direct[k.y], c.at.x), mix(direct[k.z], direct[k.w], c.at.x), c.at.y);
    }
    let cloud_mean = sum_of_group(local, cloud) / f32(n * n);
    let ground_mean = sum_of_group(local, ground) / f32(n * n);
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
