"""One slab in Mitsuba 3, for scripts/compare-tracers.

Arguments: VARIANT THREADS walk|shadow-rays TAU G. Each line of input, `PATHS SEED`, is answered by
`paths,reflectance,standard error,seconds`.

The plane albedo for light from the zenith is, by reciprocity, the radiance that an orthographic camera above the slab sees
when the slab is lit from above by a uniform sky of radiance 1 and the floor below is black. The integrator is `volpath`
without a limit of depth and without Russian roulette; without absorption a path ends where it leaves. `walk` leaves paths to
find the sky by themselves; `shadow-rays` also asks for the sky at every collision, which is Mitsuba's default. The slab is
40 thicknesses wide, so that nothing leaves through its sides: light spreads by exp(-pi x) per thickness x at most.
The error is that of the mean of 32 x 32 pixels, each a sample of its own. Rendering and the copy of the film are timed;
the kernel is compiled before.
"""

import sys, time

PIXELS = 32
HALF_WIDTH = 20.0


def scene(mi, tau, g, shadow_rays):
    transform = mi.ScalarTransform4f
    return mi.load_dict({
        "type": "scene",
        "integrator": {"type": "volpath", "max_depth": -1, "rr_depth": 1_000_000},
        "sensor": {
            "type": "orthographic",
            "to_world": transform().look_at(origin=[0, 0, 5], target=[0, 0, 0], up=[0, 1, 0]),
            "film": {"type": "hdrfilm", "width": PIXELS, "height": PIXELS, "rfilter": {"type": "box"},
                     "pixel_format": "luminance", "component_format": "float32"},
            "sampler": {"type": "independent"},
        },
        "sky": {"type": "constant", "radiance": 1.0},
        "floor": {"type": "rectangle",
                  "to_world": transform().translate([0, 0, -1]).scale([10 * HALF_WIDTH, 10 * HALF_WIDTH, 1]),
                  "bsdf": {"type": "diffuse", "reflectance": 0.0}},
        "slab": {"type": "cube", "to_world": transform().scale([HALF_WIDTH, HALF_WIDTH, 0.5]), "bsdf": {"type": "null"},
                 "interior": {"type": "homogeneous", "albedo": 1.0, "sigma_t": tau, "sample_emitters": shadow_rays,
                              "phase": {"type": "hg", "g": g}}},
    })


def main():
    variant, threads, way, tau, g = sys.argv[1:]
    import drjit as dr
    import mitsuba as mi
    import numpy as np

    dr.set_thread_count(int(threads))
    mi.set_variant(variant)
    slab = scene(mi, float(tau), float(g), way == "shadow-rays")
    np.array(mi.render(slab, spp=2, seed=1))
    for line in sys.stdin:
        paths, seed = map(int, line.split())
        samples = max(1, paths // PIXELS**2)
        start = time.perf_counter()
        film = np.array(mi.render(slab, spp=samples, seed=seed)).ravel().astype(float)
        seconds = time.perf_counter() - start
        error = film.std(ddof=1) / PIXELS
        print(f"{samples * PIXELS**2},{film.mean():.9e},{error:.4e},{seconds:e}", flush=True)


main()
