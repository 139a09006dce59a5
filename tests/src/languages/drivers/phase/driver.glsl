layout(local_size_x = 64) in;
layout(std430, binding = 1) readonly buffer TestInput { float test_input[]; };
layout(std430, binding = 2) writeonly buffer TestOutput { float test_output[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i == 0u) {
        test_output[0] = float(stratiform_phase_self_test());
    }
    if (i >= uint(test_input.length())) {
        return;
    }
    float v = test_input[i];
    uint o = 4u * i + 1u;
    test_output[o] = stratiform_phase(v);
    test_output[o + 1u] = stratiform_phase_modified(v);
    test_output[o + 2u] = stratiform_phase_squared(v);
    test_output[o + 3u] = stratiform_phase_angle(stratiform_phase_coordinate(stratiform_arc(v)));
}
