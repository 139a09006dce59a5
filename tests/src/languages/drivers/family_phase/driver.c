/* (v, radius_um) from stdin, before them the table where the language needs one; to stdout the self-test's count, then P, P_S and
   P_S convolved with itself. */
#include <stdio.h>

#ifdef STRATIFORM_TEST_METAL
#define FAMILY(function) family.function
#else
#define FAMILY(function) function
#endif

int main(void) {
    float s[2], wrong;
#ifdef STRATIFORM_TEST_METAL
    static float table[(2 + 2 * STRATIFORM_FAMILY_PHASE_TABLES) * STRATIFORM_PHASE_COUNT];
    const StratiformPhase phase = {table};
    const StratiformFamilyPhase family = {phase};
    if (fread(table, sizeof table, 1, stdin) != 1) {
        return 1;
    }
#endif
    wrong = (float)FAMILY(stratiform_family_phase_self_test)();
    fwrite(&wrong, sizeof wrong, 1, stdout);
    while (fread(s, sizeof s, 1, stdin) == 1) {
        const float values[3] = {
            FAMILY(stratiform_family_phase)(s[0], s[1]), FAMILY(stratiform_family_phase_modified)(s[0], s[1]),
            FAMILY(stratiform_family_phase_squared)(s[0], s[1])
        };
        fwrite(values, sizeof values, 1, stdout);
    }
    return 0;
}
