layout(local_size_x = 64) in;
layout(std430, binding = 1) readonly buffer TestInput { float test_input[]; };
layout(std430, binding = 2) writeonly buffer TestOutput { float test_output[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i == 0u) {
        test_output[0] = float(stratiform_shade_self_test());
    }
    if (4u * i >= uint(test_input.length())) {
        return;
    }
    float mu_l = test_input[4u * i];
    float mu_v = test_input[4u * i + 1u];
    float v = test_input[4u * i + 2u];
    float tau = test_input[4u * i + 3u];
    float depth = STRATIFORM_KAPPA_S * tau;
    float scaled = STRATIFORM_SIMILARITY * tau;
    float wide = stratiform_phase_modified(v);
    StratiformShadeFactors top = stratiform_shade_of_top(scaled);
    StratiformShadeFactors bottom = stratiform_shade_of_bottom(scaled);
    uint o = 6u * i + 1u;
    test_output[o] = stratiform_shade_once_top(mu_l, mu_v, wide, depth);
    test_output[o + 1u] = stratiform_shade_more_top(top, mu_l, mu_v, v, scaled);
    test_output[o + 2u] = stratiform_shade_top(mu_l, mu_v, v, tau);
    test_output[o + 3u] = stratiform_shade_once_bottom(mu_l, mu_v, wide, depth);
    test_output[o + 4u] = stratiform_shade_more_bottom(bottom, mu_l, mu_v, v, scaled);
    test_output[o + 5u] = stratiform_shade_bottom(mu_l, mu_v, v, tau);
}
