// Append to stratiform.wgsl. Inputs are (mu_l, tau), with mu_l = -1 for diffuse light; outputs are nine fluxes
// each, in the order of StratiformFluxes. self_test.json holds inputs and the f64 model's outputs.
@group(0) @binding(0) var<storage, read> stratiform_self_test_input: array<vec2<f32>>;
@group(0) @binding(1) var<storage, read_write> stratiform_self_test_output: array<f32>;

@compute @workgroup_size(64)
fn stratiform_self_test_kernel(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i >= arrayLength(&stratiform_self_test_input)) {
        return;
    }
    let mu_l = stratiform_self_test_input[i].x;
    let tau = stratiform_self_test_input[i].y;
    var f: StratiformFluxes;
    if (mu_l < 0.0) {
        f = stratiform_diffuse(tau);
    } else {
        f = stratiform_beam(mu_l, tau);
    }
    let o = 9u * i;
    stratiform_self_test_output[o] = f.t_ms;
    stratiform_self_test_output[o + 1u] = f.r_ms;
    stratiform_self_test_output[o + 2u] = f.t_zero;
    stratiform_self_test_output[o + 3u] = f.t_one;
    stratiform_self_test_output[o + 4u] = f.t_two;
    stratiform_self_test_output[o + 5u] = f.t_three_plus;
    stratiform_self_test_output[o + 6u] = f.r_one;
    stratiform_self_test_output[o + 7u] = f.r_two;
    stratiform_self_test_output[o + 8u] = f.r_three_plus;
}
