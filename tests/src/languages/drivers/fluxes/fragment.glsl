in vec2 test_input;
out vec4 test_output;

void main() {
    StratiformFluxes beam = stratiform_beam(test_input.x, test_input.y);
    StratiformFluxes diffuse = stratiform_diffuse(test_input.y);
    test_output = vec4(beam.t_ms, diffuse.r_ms, stratiform_t_ms(test_input.x, test_input.y), float(stratiform_self_test()));
}
