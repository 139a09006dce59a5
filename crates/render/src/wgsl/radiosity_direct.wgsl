// Sunlight on the ground that met two wide events at most, per texel of the height field.

@group(0) @binding(1) var<storage, read> thickness_m: array<f32>;
@group(0) @binding(2) var<storage, read_write> direct: array<vec4<f32>>;

@compute @workgroup_size(8, 8)
fn radiosity_direct(@builtin(global_invocation_id) id: vec3<u32>) {
    if (any(id.xy >= vec2<u32>(exchange.field_side))) {
        return;
    }
    let c = cell(id.xy + exchange.whole, exchange.fraction, exchange.field_side);
    let i = c.corners;
    let h = bilinear(vec4<f32>(thickness_m[i.x], thickness_m[i.y], thickness_m[i.z], thickness_m[i.w]), c.at);
    let f = stratiform_beam(exchange.sun.w, exchange.sky.w * h);
    let share = exchange.sun.w * (f.t_zero + f.t_one + f.t_two);
    direct[id.y * exchange.field_side + id.x] = vec4<f32>(share * exchange.sun.rgb, 0.0);
}
