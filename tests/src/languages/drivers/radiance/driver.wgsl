@group(0) @binding(1) var<storage, read> test_input: array<f32>;
@group(0) @binding(2) var<storage, read_write> test_output: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i == 0u) {
        test_output[0] = f32(stratiform_radiance_self_test());
    }
    if (5u * i >= arrayLength(&test_input)) {
        return;
    }
    let mu_l = test_input[5u * i];
    let mu_v = test_input[5u * i + 1u];
    let v = test_input[5u * i + 2u];
    let tau = test_input[5u * i + 3u];
    let shape = u32(test_input[5u * i + 4u]);
    let top = stratiform_orders_top(mu_l, mu_v, v, tau, shape);
    let bottom = stratiform_orders_bottom(mu_l, mu_v, v, tau, shape);
    let o = 10u * i + 1u;
    test_output[o] = top.one;
    test_output[o + 1u] = top.two;
    test_output[o + 2u] = top.three_plus;
    test_output[o + 3u] = bottom.one;
    test_output[o + 4u] = bottom.two;
    test_output[o + 5u] = bottom.three_plus;
    test_output[o + 6u] = stratiform_radiance_top(mu_l, mu_v, v, tau, shape);
    test_output[o + 7u] = stratiform_radiance_bottom(mu_l, mu_v, v, tau, shape);
    test_output[o + 8u] = stratiform_transparency(mu_v, tau);
    test_output[o + 9u] = stratiform_radiance_from_factor(1.0, mu_l);
}
