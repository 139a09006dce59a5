/* Numbers v from stdin, before them the table where the language needs one; to stdout the self-test's count, then
   P, P_S, P_S convolved with itself, and the angle from the table's coordinate of v. */
#include <stdio.h>

#ifdef STRATIFORM_TEST_METAL
#define PHASE(function) phase.function
#else
#define PHASE(function) function
#endif

int main(void) {
    float v, wrong;
#ifdef STRATIFORM_TEST_METAL
    static float table[2 * STRATIFORM_PHASE_COUNT];
    const StratiformPhase phase = {table};
    if (fread(table, sizeof table, 1, stdin) != 1) {
        return 1;
    }
#endif
    wrong = (float)PHASE(stratiform_phase_self_test)();
    fwrite(&wrong, sizeof wrong, 1, stdout);
    while (fread(&v, sizeof v, 1, stdin) == 1) {
        const float values[4] = {
            PHASE(stratiform_phase)(v), PHASE(stratiform_phase_modified)(v), PHASE(stratiform_phase_squared)(v),
            PHASE(stratiform_phase_angle)(PHASE(stratiform_phase_coordinate)(PHASE(stratiform_arc)(v)))
        };
        fwrite(values, sizeof values, 1, stdout);
    }
    return 0;
}
