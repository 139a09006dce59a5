layout(local_size_x = 64) in;
layout(std430, binding = 1) readonly buffer TestInput { float test_input[]; };
layout(std430, binding = 2) writeonly buffer TestOutput { float test_output[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i == 0u) {
        test_output[0] = float(stratiform_radiance_self_test());
    }
    if (5u * i >= uint(test_input.length())) {
        return;
    }
    float mu_l = test_input[5u * i];
    float mu_v = test_input[5u * i + 1u];
    float v = test_input[5u * i + 2u];
    float tau = test_input[5u * i + 3u];
    uint shape = uint(test_input[5u * i + 4u]);
    StratiformOrders top = stratiform_orders_top(mu_l, mu_v, v, tau, shape);
    StratiformOrders bottom = stratiform_orders_bottom(mu_l, mu_v, v, tau, shape);
    uint o = 10u * i + 1u;
    test_output[o] = top.one;
    test_output[o + 1u] = top.two;
    test_output[o + 2u] = top.three_plus;
    test_output[o + 3u] = bottom.one;
    test_output[o + 4u] = bottom.two;
    test_output[o + 5u] = bottom.three_plus;
    test_output[o + 6u] = stratiform_radiance_top(mu_l, mu_v, v, tau, shape);
    test_output[o + 7u] = stratiform_radiance_bottom(mu_l, mu_v, v, tau, shape);
    test_output[o + 8u] = stratiform_transparency(mu_v, tau);
    test_output[o + 9u] = stratiform_radiance_from_factor(1.0, mu_l);
}
