in vec3 test_input;
out vec4 test_output;

void main() {
    StratiformFluxes beam = stratiform_family_beam(test_input.x, test_input.y, test_input.z);
    StratiformFluxes diffuse = stratiform_family_diffuse(test_input.y, test_input.z);
    test_output = vec4(beam.t_ms, diffuse.r_ms, beam.t_one, float(stratiform_family_self_test()));
}
