/* Sights (mu_l, mu_v, v, tau, shape) from stdin, before them the tables where the language needs one; to stdout the
   self-test's count, then the orders at both faces, both sums, the transparency, L / F0 of factor 1, and the halo. */
#include <stdio.h>

#ifdef STRATIFORM_TEST_METAL
#include "stratiform_radiance.metal"
#define RADIANCE(function) radiance.function
#define HALO(function) halo.function
#else
#include "stratiform_radiance.h"
#define RADIANCE(function) function
#define HALO(function) function
#endif

int main(void) {
    float s[5], wrong;
#ifdef STRATIFORM_TEST_METAL
    static float table[2 * STRATIFORM_PHASE_COUNT];
    static float shape[STRATIFORM_HALO_COLUMNS * STRATIFORM_HALO_ROWS];
    const StratiformPhase phase = {table};
    const StratiformRadiance radiance = {phase};
    const StratiformHalo halo = {phase, shape};
    if (fread(table, sizeof table, 1, stdin) != 1 || fread(shape, sizeof shape, 1, stdin) != 1) {
        return 1;
    }
#endif
    wrong = (float)(RADIANCE(stratiform_radiance_self_test)() + HALO(stratiform_halo_self_test)());
    fwrite(&wrong, sizeof wrong, 1, stdout);
    while (fread(s, sizeof s, 1, stdin) == 1) {
        const uint32_t shape = (uint32_t)s[4];
        const StratiformOrders top = RADIANCE(stratiform_orders_top)(s[0], s[1], s[2], s[3], shape);
        const StratiformOrders bottom = RADIANCE(stratiform_orders_bottom)(s[0], s[1], s[2], s[3], shape);
        const float values[11] = {
            top.one, top.two, top.three_plus, bottom.one, bottom.two, bottom.three_plus,
            RADIANCE(stratiform_radiance_top)(s[0], s[1], s[2], s[3], shape),
            RADIANCE(stratiform_radiance_bottom)(s[0], s[1], s[2], s[3], shape),
            stratiform_transparency(s[1], s[3]), stratiform_radiance_from_factor(1.0f, s[0]),
            HALO(stratiform_halo)(s[0], s[1], s[2], s[3])
        };
        fwrite(values, sizeof values, 1, stdout);
    }
    return 0;
}
