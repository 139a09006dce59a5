layout(local_size_x = 64) in;
layout(std430, binding = 1) readonly buffer TestInput { float test_input[]; };
layout(std430, binding = 2) writeonly buffer TestOutput { float test_output[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i == 0u) {
        test_output[0] = float(stratiform_family_phase_self_test());
    }
    if (2u * i >= uint(test_input.length())) {
        return;
    }
    float v = test_input[2u * i];
    float radius_um = test_input[2u * i + 1u];
    uint o = 3u * i + 1u;
    test_output[o] = stratiform_family_phase(v, radius_um);
    test_output[o + 1u] = stratiform_family_phase_modified(v, radius_um);
    test_output[o + 2u] = stratiform_family_phase_squared(v, radius_um);
}
