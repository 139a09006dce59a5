@group(0) @binding(0) var<storage, read> test_input: array<f32>;
@group(0) @binding(1) var<storage, read_write> test_output: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i == 0u) {
        test_output[0] = f32(stratiform_family_self_test());
    }
    if (3u * i >= arrayLength(&test_input)) {
        return;
    }
    let mu_l = test_input[3u * i];
    let radius_um = test_input[3u * i + 1u];
    let tau = test_input[3u * i + 2u];
    var f: StratiformFluxes;
    if (mu_l < 0.0) {
        f = stratiform_family_diffuse(radius_um, tau);
    } else {
        f = stratiform_family_beam(mu_l, radius_um, tau);
    }
    let o = 9u * i + 1u;
    test_output[o] = f.t_ms;
    test_output[o + 1u] = f.r_ms;
    test_output[o + 2u] = f.t_zero;
    test_output[o + 3u] = f.t_one;
    test_output[o + 4u] = f.t_two;
    test_output[o + 5u] = f.t_three_plus;
    test_output[o + 6u] = f.r_one;
    test_output[o + 7u] = f.r_two;
    test_output[o + 8u] = f.r_three_plus;
}
