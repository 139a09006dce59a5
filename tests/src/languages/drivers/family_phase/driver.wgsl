@group(0) @binding(1) var<storage, read> test_input: array<f32>;
@group(0) @binding(2) var<storage, read_write> test_output: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i == 0u) {
        test_output[0] = f32(stratiform_family_phase_self_test());
    }
    if (2u * i >= arrayLength(&test_input)) {
        return;
    }
    let v = test_input[2u * i];
    let radius_um = test_input[2u * i + 1u];
    let o = 3u * i + 1u;
    test_output[o] = stratiform_family_phase(v, radius_um);
    test_output[o + 1u] = stratiform_family_phase_modified(v, radius_um);
    test_output[o + 2u] = stratiform_family_phase_squared(v, radius_um);
}
