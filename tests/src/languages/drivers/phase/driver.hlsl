[[vk::binding(1, 0)]] StructuredBuffer<float> test_input : register(t1);
[[vk::binding(2, 0)]] RWStructuredBuffer<float> test_output : register(u2);

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {
    uint i = id.x;
    uint count, stride;
    test_input.GetDimensions(count, stride);
    if (i == 0u) {
        test_output[0] = float(stratiform_phase_self_test());
    }
    if (i >= count) {
        return;
    }
    float v = test_input[i];
    uint o = 4u * i + 1u;
    test_output[o] = stratiform_phase(v);
    test_output[o + 1u] = stratiform_phase_modified(v);
    test_output[o + 2u] = stratiform_phase_squared(v);
    test_output[o + 3u] = stratiform_phase_angle(stratiform_phase_coordinate(stratiform_arc(v)));
}
