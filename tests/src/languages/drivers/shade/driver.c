/* Sights (mu_l, mu_v, v, tau) from stdin, before them the table where the language needs one; to stdout the self-test's count,
   then single scattering, the rest and both at the lit face, and the same at the other. */
#include <stdio.h>

#ifdef STRATIFORM_TEST_METAL
#define PHASE(function) phase.function
#define SHADE(function) shade.function
#else
#define PHASE(function) function
#define SHADE(function) function
#endif

int main(void) {
    float s[4], wrong;
#ifdef STRATIFORM_TEST_METAL
    static float table[2 * STRATIFORM_PHASE_COUNT];
    const StratiformPhase phase = {table};
    const StratiformShade shade = {phase};
    if (fread(table, sizeof table, 1, stdin) != 1) {
        return 1;
    }
#endif
    wrong = (float)SHADE(stratiform_shade_self_test)();
    fwrite(&wrong, sizeof wrong, 1, stdout);
    while (fread(s, sizeof s, 1, stdin) == 1) {
        const float depth = STRATIFORM_KAPPA_S * s[3], scaled = STRATIFORM_SIMILARITY * s[3];
        const float wide = PHASE(stratiform_phase_modified)(s[2]);
        const StratiformShadeFactors top = SHADE(stratiform_shade_of_top)(scaled);
        const StratiformShadeFactors bottom = SHADE(stratiform_shade_of_bottom)(scaled);
        const float values[6] = {
            SHADE(stratiform_shade_once_top)(s[0], s[1], wide, depth),
            SHADE(stratiform_shade_more_top)(top, s[0], s[1], s[2], scaled),
            SHADE(stratiform_shade_top)(s[0], s[1], s[2], s[3]),
            SHADE(stratiform_shade_once_bottom)(s[0], s[1], wide, depth),
            SHADE(stratiform_shade_more_bottom)(bottom, s[0], s[1], s[2], scaled),
            SHADE(stratiform_shade_bottom)(s[0], s[1], s[2], s[3])
        };
        fwrite(values, sizeof values, 1, stdout);
    }
    return 0;
}
