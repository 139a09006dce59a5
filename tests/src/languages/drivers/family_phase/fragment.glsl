in vec2 test_input;
out vec4 test_output;

void main() {
    float squared = stratiform_family_phase_squared(test_input.x, test_input.y);
    test_output = vec4(stratiform_family_phase(test_input.x, test_input.y), squared, 0.0, float(stratiform_family_phase_self_test()));
}
