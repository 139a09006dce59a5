// One plane receives what the other gives out: E = sum of weights times radiosity, added to what it received before. It gives back its
// albedo times E, and times the direct light beside it. A workgroup per texel.

@group(0) @binding(1) var<storage, read> weights: array<f32>;
@group(0) @binding(2) var<storage, read> radiosity: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read> albedo: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read> source: array<vec4<f32>>;
@group(0) @binding(5) var<storage, read_write> received: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read_write> given_back: array<vec4<f32>>;

@compute @workgroup_size(8, 8)
fn radiosity_gather(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) local: u32,
) {
    let n = exchange.side;
    var mine = vec4<f32>();
    for (var y = id.y; y < n; y += 8u) {
        let north = n * select(y + n - group.y, y - group.y, y >= group.y);
        for (var x = id.x; x < n; x += 8u) {
            let east = select(x + n - group.x, x - group.x, x >= group.x);
            mine += weights[north + east] * radiosity[y * n + x];
        }
    }
    let irradiance = sum_of_group(local, mine);
    if (local == 0u) {
        let texel = group.y * n + group.x;
        received[texel] += irradiance;
        given_back[texel] = albedo[texel] * (irradiance + source[texel]);
    }
}
