/* A scalar event loop for one slab, in the manner of MCML (Wang, Jacques and Zheng 1995): one photon at a time, hop and spin,
 * with position and three direction cosines. Written for the comparison in scripts/compare-tracers.
 *
 * No absorption and no refraction, so photons carry no weight and the parts of MCML for these are left out; a photon is
 * counted where it leaves. Depth is in mean free paths. Henyey-Greenstein by its closed inversion; logarithm, cosine and
 * square root of the system's library; random numbers of PCG-XSH-RR 64/32 (O'Neill 2014), 32 bits each.
 *
 * Arguments: TAU G MU0. Each line of input, PHOTONS SEED, is answered by photons,reflected,transmitted,scatterings,seconds. */

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static const double PI = 3.14159265358979323846;
/* Closer than this to the vertical, the azimuth is that of the new direction itself. */
static const double VERTICAL = 0.99999;

typedef struct { uint64_t state, increment; } Generator;
typedef struct { double x, y, z, ux, uy, uz; } Photon;
typedef struct { uint64_t reflected, transmitted, scatterings; } Counts;

static uint32_t word(Generator *rng) {
    uint64_t old = rng->state;
    rng->state = old * 6364136223846793005ULL + rng->increment;
    uint32_t shifted = (uint32_t)(((old >> 18) ^ old) >> 27);
    uint32_t turn = (uint32_t)(old >> 59);
    return (shifted >> turn) | (shifted << (-turn & 31));
}

/* In (0, 1). */
static double uniform(Generator *rng) {
    return (word(rng) + 0.5) * (1.0 / 4294967296.0);
}

/* The state is the seed's SplitMix64 hash. */
static Generator seeded(uint64_t seed) {
    uint64_t mixed = (seed + 1) * 0x9e3779b97f4a7c15ULL;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ULL;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
    Generator rng = {mixed ^ (mixed >> 31), 1442695040888963407ULL};
    return rng;
}

static void hop(Photon *p, Generator *rng) {
    double path = -log(uniform(rng));
    p->x += path * p->ux;
    p->y += path * p->uy;
    p->z += path * p->uz;
}

/* Cosine of the scattering angle. */
static double deflection(double g, Generator *rng) {
    if (g == 0.0)
        return 2.0 * uniform(rng) - 1.0;
    double ratio = (1.0 - g * g) / (1.0 - g + 2.0 * g * uniform(rng));
    double cosine = (1.0 + g * g - ratio * ratio) / (2.0 * g);
    return cosine < -1.0 ? -1.0 : cosine > 1.0 ? 1.0 : cosine;
}

static void spin(Photon *p, double g, Generator *rng) {
    double cost = deflection(g, rng);
    double sint = sqrt(1.0 - cost * cost);
    double azimuth = 2.0 * PI * uniform(rng);
    double cosp = cos(azimuth);
    double sinp = azimuth < PI ? sqrt(1.0 - cosp * cosp) : -sqrt(1.0 - cosp * cosp);
    double ux = p->ux, uy = p->uy, uz = p->uz;
    if (fabs(uz) > VERTICAL) {
        p->ux = sint * cosp;
        p->uy = sint * sinp;
        p->uz = uz > 0.0 ? cost : -cost;
    } else {
        double across = sqrt(1.0 - uz * uz);
        p->ux = sint * (ux * uz * cosp - uy * sinp) / across + ux * cost;
        p->uy = sint * (uy * uz * cosp + ux * sinp) / across + uy * cost;
        p->uz = -sint * cosp * across + uz * cost;
    }
}

static void trace(double tau, double g, double mu0, Generator *rng, Counts *counts) {
    Photon p = {0.0, 0.0, 0.0, sqrt(1.0 - mu0 * mu0), 0.0, mu0};
    for (;;) {
        hop(&p, rng);
        if (p.z < 0.0) {
            counts->reflected++;
            return;
        }
        if (p.z >= tau) {
            counts->transmitted++;
            return;
        }
        spin(&p, g, rng);
        counts->scatterings++;
    }
}

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
}

int main(int argc, char **argv) {
    if (argc != 4) {
        fprintf(stderr, "usage: slab TAU G MU0\n");
        return 2;
    }
    double tau = atof(argv[1]), g = atof(argv[2]), mu0 = atof(argv[3]);
    unsigned long long photons, seed;
    while (scanf("%llu %llu", &photons, &seed) == 2) {
        Counts counts = {0, 0, 0};
        Generator rng = seeded(seed);
        double start = now();
        for (unsigned long long k = 0; k < photons; k++)
            trace(tau, g, mu0, &rng, &counts);
        double seconds = now() - start;
        printf("%llu,%llu,%llu,%llu,%e\n", photons, (unsigned long long)counts.reflected,
               (unsigned long long)counts.transmitted, (unsigned long long)counts.scatterings, seconds);
        fflush(stdout);
    }
    return 0;
}
