/* Clouds (mu_l, radius_um, tau) from stdin, mu_l = -1 for diffuse light; to stdout the self-test's count, then nine fluxes each. */
#include <stdio.h>

int main(void) {
    const float wrong = (float)stratiform_family_self_test();
    float s[3];
    fwrite(&wrong, sizeof wrong, 1, stdout);
    while (fread(s, sizeof s, 1, stdin) == 1) {
        const StratiformFluxes f =
            s[0] < 0.0f ? stratiform_family_diffuse(s[1], s[2]) : stratiform_family_beam(s[0], s[1], s[2]);
        const float fluxes[9] = {
            f.t_ms, f.r_ms, f.t_zero, f.t_one, f.t_two, f.t_three_plus, f.r_one, f.r_two, f.r_three_plus
        };
        fwrite(fluxes, sizeof fluxes, 1, stdout);
    }
    return 0;
}
