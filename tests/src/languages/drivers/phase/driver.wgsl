@group(0) @binding(1) var<storage, read> test_input: array<f32>;
@group(0) @binding(2) var<storage, read_write> test_output: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i == 0u) {
        test_output[0] = f32(stratiform_phase_self_test());
    }
    if (i >= arrayLength(&test_input)) {
        return;
    }
    let v = test_input[i];
    let o = 4u * i + 1u;
    test_output[o] = stratiform_phase(v);
    test_output[o + 1u] = stratiform_phase_modified(v);
    test_output[o + 2u] = stratiform_phase_squared(v);
    test_output[o + 3u] = stratiform_phase_angle(stratiform_phase_coordinate(stratiform_arc(v)));
}
