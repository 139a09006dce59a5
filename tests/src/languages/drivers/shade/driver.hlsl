[[vk::binding(1, 0)]] StructuredBuffer<float> test_input : register(t1);
[[vk::binding(2, 0)]] RWStructuredBuffer<float> test_output : register(u2);

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {
    uint i = id.x;
    uint count, stride;
    test_input.GetDimensions(count, stride);
    if (i == 0u) {
        test_output[0] = float(stratiform_shade_self_test());
    }
    if (4u * i >= count) {
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
