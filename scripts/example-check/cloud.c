/* A sample implementation to be checked: the emitted shader's fluxes, ported to C by hand, as a renderer might have it.
 *
 *     cloud stratiform.wgsl < points.csv > values.csv
 *
 * reads the table's numbers from the emitted text, evaluates the beams of points.csv (sky light is left out: what is
 * not given is not judged), and fills in the column `value`. -DSLIP plants a mistake: extinction taken for kappa_c. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64 };
struct parameters { float b, c, kappa_c, t, r; };
struct fluxes { float t_ms, r_ms, t_0, t_1, t_2, r_1, r_2; };

static struct parameters node[MOST];
static float node_mu[MOST], slope, kappa_s;
static int rows;

/* Moves behind the next `mark`, if it comes before `end`. */
static int find(const char **text, const char *mark, const char *end) {
    const char *found = strstr(*text, mark);
    if (!found || (end && found > end)) return 0;
    *text = found + strlen(mark);
    return 1;
}

static float number(const char **text) {
    char *end;
    float value = strtof(*text, &end);
    *text = end + strspn(end, ", ");
    return value;
}

static int read_table(const char *text) {
    const char *end, *mu;
    if (!find(&text, "STRATIFORM_SLOPE: f32 = ", NULL)) return 0;
    slope = number(&text);
    if (!find(&text, "STRATIFORM_KAPPA_S: f32 = ", NULL)) return 0;
    kappa_s = number(&text);
    if (!find(&text, "fn stratiform_node(", NULL) || !(end = strstr(text, "fn stratiform_node_mu("))) return 0;
    for (mu = end; rows < MOST && find(&text, "return StratiformParameters(", end); rows++) {
        struct parameters *p = &node[rows];
        p->b = number(&text), p->c = number(&text), p->kappa_c = number(&text);
        p->t = number(&text), p->r = number(&text);
        if (!find(&mu, "return ", NULL)) return 0;
        node_mu[rows] = number(&mu);
    }
    return rows >= 2;
}

static float mix(float p, float q, float w) { return p + (q - p) * w; }
static float mix_reciprocal(float p, float q, float w) { return p * q / (q + (p - q) * w); }

static struct parameters parameters_at(float mu) {
    int i = 0;
    while (i < rows - 2 && mu < node_mu[i + 1]) i++;
    float w = (node_mu[i] - mu) / (node_mu[i] - node_mu[i + 1]);
    struct parameters p = node[i], q = node[i + 1], m;
    m.b = mix(p.b, q.b, w), m.t = mix(p.t, q.t, w);
    m.c = mix_reciprocal(p.c, q.c, w);
    m.kappa_c = mix_reciprocal(p.kappa_c, q.kappa_c, w);
    m.r = mix_reciprocal(p.r, q.r, w);
#ifdef SLIP
    m.kappa_c = 1.0f;
#endif
    return m;
}

static struct fluxes beam(float mu, float tau) {
    struct parameters p = parameters_at(mu);
    float x = p.kappa_c * tau, decay = expf(-x);
    struct fluxes f;
    f.t_ms = (p.b + (1 - p.b) * expf(-p.c * tau)) / (1 + slope * tau);
    f.r_ms = 1 - f.t_ms;
    f.t_0 = expf(-kappa_s * tau / mu);
    f.t_1 = p.t * x * decay;
    f.r_1 = -0.5f * p.r * expm1f(-2 * x);
    f.t_2 = 0.5f * p.t * x * f.t_1 + 0.25f * p.r * p.r * decay * (2 * x + expm1f(-2 * x));
    f.r_2 = 0.5f * p.r * p.t * (1 - (1 + 2 * x) * expf(-2 * x));
    return f;
}

static float value_of(const struct fluxes *f, int reflected, const char *order) {
    if (!strcmp(order, "total")) return reflected ? f->r_ms : f->t_ms;
    if (!strcmp(order, "0")) return reflected ? 0 : f->t_0;
    if (!strcmp(order, "1")) return reflected ? f->r_1 : f->t_1;
    if (!strcmp(order, "2")) return reflected ? f->r_2 : f->t_2;
    return reflected ? f->r_ms - f->r_1 - f->r_2 : f->t_ms - f->t_0 - f->t_1 - f->t_2;
}

static char text[1 << 20];

int main(int argc, char **argv) {
    FILE *file = argc == 2 ? fopen(argv[1], "r") : NULL;
    if (!file || !fread(text, 1, sizeof text - 1, file) || !read_table(text)) {
        fprintf(stderr, "usage: cloud stratiform.wgsl < points.csv > values.csv\n");
        return 2;
    }
    char line[256], quantity[32], theta[32], tau[32], order[32];
    if (!fgets(line, sizeof line, stdin)) return 2;
    fputs(line, stdout);
    while (fgets(line, sizeof line, stdin)) {
        if (sscanf(line, "%31[^,],%31[^,],,,%31[^,],%31[^,],", quantity, theta, tau, order) != 4) return 2;
        if (!strcmp(theta, "diffuse")) continue;
        float mu = (float)cos(atof(theta) * acos(-1.0) / 180.0);
        struct fluxes f = beam(mu, strtof(tau, NULL));
        float value = value_of(&f, !strcmp(quantity, "reflectance"), order);
        printf("%s,%s,,,%s,%s,%.9g\n", quantity, theta, tau, order, value);
    }
    return 0;
}
