in vec4 test_input;
out vec4 test_output;

void main() {
    float top = stratiform_shade_top(test_input.x, test_input.y, test_input.z, test_input.w);
    StratiformShadeFactors k = stratiform_shade_of_bottom(STRATIFORM_SIMILARITY * test_input.w);
    float bottom = stratiform_shade_bottom_with(k, test_input.x, test_input.y, test_input.z, test_input.w);
    test_output = vec4(stratiform_radiance_from_factor(top, test_input.x), bottom, 0.0, float(stratiform_shade_self_test()));
}
