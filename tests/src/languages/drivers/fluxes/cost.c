/* Pairs (mu_l, tau) from stdin; nanoseconds per evaluation to stdout, one line per repeat. */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <time.h>
#include "stratiform.h"

enum { PAIRS = 2048, WARM = 50, REPEATS = 401 };

static double nanoseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

int main(void) {
    static float pairs[PAIRS][2];
    static volatile float sink;
    const size_t count = fread(pairs, sizeof pairs[0], PAIRS, stdin);
    for (int repeat = -WARM; repeat < REPEATS; repeat++) {
        const double start = nanoseconds();
        float sum = 0.0f;
        for (size_t i = 0; i < count; i++) {
            const StratiformFluxes f = stratiform_beam(pairs[i][0], pairs[i][1]);
            sum += f.t_ms + f.r_ms + f.t_zero + f.t_one + f.t_two + f.t_three_plus + f.r_one + f.r_two + f.r_three_plus;
        }
        sink = sum;
        if (repeat >= 0) {
            printf("%.3f\n", (nanoseconds() - start) / (double)count);
        }
    }
    (void)sink;
    return 0;
}
