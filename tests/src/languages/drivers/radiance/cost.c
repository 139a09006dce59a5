/* Sights (mu_l, mu_v, v, tau) from stdin; nanoseconds per evaluation of COST_FUNCTION to stdout, one line per repeat. */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <time.h>
#include "stratiform_halo.h"
#include "stratiform_radiance.h"
#include "stratiform_shade.h"

enum { SIGHTS = 2048, WARM = 50, REPEATS = 401 };

/* Some functions take the shape of the light that was scattered often. */
#define stratiform_radiance_top(...) (stratiform_radiance_top)(__VA_ARGS__, STRATIFORM_LAMBERTIAN)
#define stratiform_radiance_bottom(...) (stratiform_radiance_bottom)(__VA_ARGS__, STRATIFORM_ESCAPE)

/* Here all sights share a thickness, so that its factors are computed once. */
#define stratiform_shade_top_with(mu_l, mu_v, v, tau) \
    (stratiform_shade_top_with)(stratiform_shade_of_top(5.0f * STRATIFORM_SIMILARITY), mu_l, mu_v, v, 5.0f)

static double nanoseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

int main(void) {
    static float sights[SIGHTS][4];
    static volatile float sink;
    const size_t count = fread(sights, sizeof sights[0], SIGHTS, stdin);
    for (int repeat = -WARM; repeat < REPEATS; repeat++) {
        const double start = nanoseconds();
        float sum = 0.0f;
        for (size_t i = 0; i < count; i++) {
            const float *s = sights[i];
            sum += COST_FUNCTION(s[0], s[1], s[2], s[3]);
        }
        sink = sum;
        if (repeat >= 0) {
            printf("%.3f\n", (nanoseconds() - start) / (double)count);
        }
    }
    (void)sink;
    return 0;
}
