in vec2 test_input;
out vec4 test_output;

void main() {
    float v = test_input.x;
    test_output = vec4(stratiform_phase(v), stratiform_phase_modified(v), stratiform_phase_squared(v), float(stratiform_phase_self_test()));
}
