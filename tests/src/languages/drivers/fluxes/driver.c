/* Pairs (mu_l, tau) from stdin, mu_l = -1 for diffuse light; to stdout the self-test's count, then nine fluxes each. */
#include <stdio.h>

int main(void) {
    const float wrong = (float)stratiform_self_test();
    float pair[2];
    fwrite(&wrong, sizeof wrong, 1, stdout);
    while (fread(pair, sizeof pair, 1, stdin) == 1) {
        const StratiformFluxes f = pair[0] < 0.0f ? stratiform_diffuse(pair[1]) : stratiform_beam(pair[0], pair[1]);
        const float fluxes[9] = {
            f.t_ms, f.r_ms, f.t_zero, f.t_one, f.t_two, f.t_three_plus, f.r_one, f.r_two, f.r_three_plus
        };
        fwrite(fluxes, sizeof fluxes, 1, stdout);
    }
    return 0;
}
