@group(0) @binding(1) var<storage, read> test_input: array<f32>;
@group(0) @binding(2) var<storage, read_write> test_output: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i == 0u) {
        test_output[0] = f32(stratiform_shade_self_test());
    }
    if (4u * i >= arrayLength(&test_input)) {
        return;
    }
    let mu_l = test_input[4u * i];
    let mu_v = test_input[4u * i + 1u];
    let v = test_input[4u * i + 2u];
    let tau = test_input[4u * i + 3u];
    let depth = STRATIFORM_KAPPA_S * tau;
    let scaled = STRATIFORM_SIMILARITY * tau;
    let wide = stratiform_phase_modified(v);
    let top = stratiform_shade_of_top(scaled);
    let bottom = stratiform_shade_of_bottom(scaled);
    let o = 6u * i + 1u;
    test_output[o] = stratiform_shade_once_top(mu_l, mu_v, wide, depth);
    test_output[o + 1u] = stratiform_shade_more_top(top, mu_l, mu_v, v, scaled);
    test_output[o + 2u] = stratiform_shade_top(mu_l, mu_v, v, tau);
    test_output[o + 3u] = stratiform_shade_once_bottom(mu_l, mu_v, wide, depth);
    test_output[o + 4u] = stratiform_shade_more_bottom(bottom, mu_l, mu_v, v, scaled);
    test_output[o + 5u] = stratiform_shade_bottom(mu_l, mu_v, v, tau);
}
