layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer TestInput { float test_input[]; };
layout(std430, binding = 1) writeonly buffer TestOutput { float test_output[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i == 0u) {
        test_output[0] = float(stratiform_family_self_test());
    }
    if (3u * i >= uint(test_input.length())) {
        return;
    }
    float mu_l = test_input[3u * i];
    float radius_um = test_input[3u * i + 1u];
    float tau = test_input[3u * i + 2u];
    StratiformFluxes f;
    if (mu_l < 0.0) {
        f = stratiform_family_diffuse(radius_um, tau);
    } else {
        f = stratiform_family_beam(mu_l, radius_um, tau);
    }
    uint o = 9u * i + 1u;
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
