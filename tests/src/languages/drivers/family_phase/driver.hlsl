[[vk::binding(1, 0)]] StructuredBuffer<float> test_input : register(t1);
[[vk::binding(2, 0)]] RWStructuredBuffer<float> test_output : register(u2);

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {
    uint i = id.x;
    uint count, stride;
    test_input.GetDimensions(count, stride);
    if (i == 0u) {
        test_output[0] = float(stratiform_family_phase_self_test());
    }
    if (2u * i >= count) {
        return;
    }
    float v = test_input[2u * i];
    float radius_um = test_input[2u * i + 1u];
    uint o = 3u * i + 1u;
    test_output[o] = stratiform_family_phase(v, radius_um);
    test_output[o + 1u] = stratiform_family_phase_modified(v, radius_um);
    test_output[o + 2u] = stratiform_family_phase_squared(v, radius_um);
}
