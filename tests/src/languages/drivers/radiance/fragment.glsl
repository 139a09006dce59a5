in vec4 test_input;
out vec4 test_output;

void main() {
    float top = stratiform_radiance_top(test_input.x, test_input.y, test_input.z, test_input.w, STRATIFORM_LAMBERTIAN);
    float bottom = stratiform_radiance_bottom(test_input.x, test_input.y, test_input.z, test_input.w, STRATIFORM_ESCAPE);
    float transparency = stratiform_transparency(test_input.y, test_input.w);
    test_output = vec4(stratiform_radiance_from_factor(top, test_input.x), bottom, transparency, float(stratiform_radiance_self_test()));
}
