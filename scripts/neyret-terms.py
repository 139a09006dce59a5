#!/usr/bin/env python3
"""Would light traps or a corona (Neyret 2000, sections 4.3 and 4.2) bring the renderer nearer to the truth?

Usage: scripts/neyret-terms.py STRATIFORM HEIGHTS OUT [SCENE...]

STRATIFORM is the command with the feature `gpu`, HEIGHTS the example of that name of stratiform-world. For each scene (a name in
fit-configs/scenes) OUT gets the truth, pictures at 4 x 4 rays a pixel and the thickness map, unless they are there already;
OUT/neyret-terms.csv and stdout get a row per scene, term and parameter set. All numbers are of luminance. SAMPLES and MODEL may be
set in the environment. numpy is needed.

A term s F is added to the picture, F the mean over a pixel's rays, s by least squares; error changes are of s found in the other half
of the picture (6 x 6 pixels a square of a chequerboard), their standard errors from 1000 bootstraps over those squares.
"""

import csv, os, struct, subprocess, sys, tomllib, zlib
from pathlib import Path
import numpy as np

SIZE, OVER, BLOCK, FLOOR = (96, 54), 4, 6, 0.01
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
FIELDS = "scene term parameters pixels noise error change change_se strength strength_se median median_after noise_median".split()


def exr(path):
    """Channels of a scan-line EXR of 32-bit floats, ZIP in blocks of 16 rows."""
    data, at, head = path.read_bytes(), 8, {}
    text = lambda at: (data[at : data.index(0, at)].decode(), data.index(0, at) + 1)
    while data[at]:
        name, at = text(at)
        kind, at = text(at)
        (size,) = struct.unpack_from("<i", data, at)
        head[name] = at + 4
        at += 4 + size
    x0, y0, x1, y1 = struct.unpack_from("<4i", data, head["dataWindow"])
    assert data[head["compression"]] == 3, "not ZIP16"
    width, height, names, c = x1 - x0 + 1, y1 - y0 + 1, [], head["channels"]
    while data[c]:
        name, c = text(c)
        names.append(name)
        c += 16
    out = np.empty((height, len(names), width), np.float32)
    for (offset,) in struct.iter_unpack("<Q", data[at + 1 : at + 1 + 8 * -(-height // 16)]):
        y, size = struct.unpack_from("<2i", data, offset)
        rows = min(16, height - (y - y0))
        raw, full = data[offset + 8 : offset + 8 + size], rows * len(names) * width * 4
        if size < full:
            mixed = np.frombuffer(zlib.decompress(raw), np.uint8).astype(np.int64)
            mixed[1:] -= 128
            mixed = np.cumsum(mixed).astype(np.uint8)
            raw = np.stack([mixed[: (full + 1) // 2], mixed[(full + 1) // 2 :]], 1).tobytes()
        out[y - y0 : y - y0 + rows] = np.frombuffer(raw, "<f4").reshape(rows, len(names), width)
    return {name: out[:, i].astype(float) for i, name in enumerate(names)}


def luminance(channels, layer=""):
    return sum(w * channels[layer + c] for w, c in zip(LUMINANCE, "RGB"))


def down(fine):
    h, w = fine.shape
    return fine.reshape(h // OVER, OVER, w // OVER, OVER).mean((1, 3))


def direction(azimuth, elevation):
    a, e = np.radians([azimuth, elevation])
    return np.array([np.sin(a) * np.cos(e), np.cos(a) * np.cos(e), np.sin(e)])


def box(values, side, of):
    """`of` (np.minimum, np.maximum, np.add) over a periodic square of `side` texels round each."""
    for axis in (0, 1):
        total = values
        for k in range(1, side):
            total = of(total, np.roll(values, k, axis))
        values = np.roll(total, -(side // 2), axis)
    return values


class Geometry:
    """Rays of a scene: where each meets the cloud, and how far it goes in it."""

    def __init__(self, path, heights):
        scene = tomllib.loads(path.read_text())
        clouds, camera = scene["clouds"], scene["camera"]
        folder = path.parent / clouds["tables"]
        words = (folder / "generated/parameters.json").read_text()
        self.kappa = float(words.split('"extinction_per_m":')[1].split(",")[0])
        self.map = np.fromfile(heights, "<f4").astype(float)
        self.side = int(np.sqrt(self.map.size))
        self.map = self.map.reshape(self.side, self.side)
        self.step = clouds["extent_m"] / self.side
        self.cell = clouds.get("cell_m", 1600.0)
        self.sun = direction(scene["sun"]["azimuth_deg"], 90 - scene["sun"]["theta_deg"])
        a, e = camera["azimuth_deg"], camera["elevation_deg"]
        w, h = SIZE[0] * OVER, SIZE[1] * OVER
        scale = 2 * np.tan(np.radians(camera.get("field_of_view_deg", 50)) / 2) / h
        x = (np.arange(w) + 0.5 - w / 2) * scale
        y = -(np.arange(h) + 0.5 - h / 2) * scale
        d = direction(a, e) + x[None, :, None] * direction(a + 90, 0) + y[:, None, None] * direction(a, e + 90)
        d = (d / np.linalg.norm(d, axis=2, keepdims=True)).reshape(-1, 3)
        d[:, 2] = np.where(d[:, 2] >= 0, np.maximum(d[:, 2], 1e-3), np.minimum(d[:, 2], -1e-3))
        self.d, self.shape = d, (h, w)
        self.march(np.array(camera["position_m"], float), clouds["base_m"])

    def at(self, values, x, y):
        """Bilinear and periodic, texel centres at + 1/2."""
        u, v = x / self.step - 0.5, y / self.step - 0.5
        i, j = np.floor(u).astype(int), np.floor(v).astype(int)
        s, t, n = u - i, v - j, self.side
        row = lambda j: (1 - s) * values[j % n, i % n] + s * values[j % n, (i + 1) % n]
        return (1 - t) * row(j) + t * row(j + 1)

    def march(self, position, base):
        most, d, height = self.map.max(), self.d, position[2] - base
        to_base, to_top = -height / d[:, 2], (most - height) / d[:, 2]
        way = np.maximum(np.minimum(to_base, to_top), 0)
        end = np.maximum(to_base, to_top)
        step = np.minimum(0.5 * self.step, most / 100 / np.abs(d[:, 2]))
        self.chord, self.hit = np.zeros(len(d)), np.full(len(d), -1.0)
        go = np.flatnonzero(end > way)
        for _ in range(20000):
            middle = way[go] + 0.5 * step[go]
            p = position + middle[:, None] * d[go]
            inside = p[:, 2] - base < self.at(self.map, p[:, 0], p[:, 1])
            first = inside & (self.hit[go] < 0)
            self.hit[go[first]] = middle[first]
            self.chord[go] += inside * step[go]
            way[go] += step[go]
            go = go[(way[go] < end[go]) & (self.kappa * self.chord[go] < 30)]
            if not len(go):
                break
        p = position + np.maximum(self.hit, 0)[:, None] * d
        self.x, self.y = p[:, 0], p[:, 1]
        # Seen through its top: from above, or through a flank.
        self.top = (self.hit >= 0) & ((d[:, 2] < 0) | (p[:, 2] - base > 0.03 * most))

    def traps(self, texels, ambient):
        """Local height h from 0 to 1, and the mean Lambertian light of the neighbourhood, under every ray."""
        low, high = box(self.map, texels, np.minimum), box(self.map, texels, np.maximum)
        h = (self.map - low) / np.maximum(high - low, 1e-3)
        slope = lambda axis: (np.roll(self.map, -1, axis) - np.roll(self.map, 1, axis)) / (2 * self.step)
        normal = np.stack([-slope(1), -slope(0), np.ones_like(self.map)], 2)
        lambert = np.maximum(normal @ self.sun / np.linalg.norm(normal, axis=2), 0) / np.pi
        mean = ambient + box(lambert, texels, np.add) / texels**2
        return self.at(h, self.x, self.y), self.at(mean, self.x, self.y)


class Held:
    """A picture held against its truth."""

    def __init__(self, name, truth, error, picture):
        self.name, self.truth, self.error, self.picture = name, truth, error, picture
        i, j = np.indices(truth.shape) // BLOCK
        self.block, self.odd = (i * 1000 + j), (i + j) % 2 == 1
        self.labels = np.unique(self.block)

    def excess(self, square):
        noise = np.mean(self.error**2)
        return np.sqrt(max(square - noise, 0)) / np.mean(self.truth)

    def median(self, picture):
        return np.median(np.abs(picture - self.truth) / np.maximum(np.abs(self.truth), FLOOR * np.mean(self.truth)))

    def fit(self, term, parameters, features, fixed=0.0, base=None):
        """`features` are added with strengths of their own; the last one's is reported. `base`: those of what it is measured against."""
        D = self.truth - self.picture
        before = self.rest(D, base, 0.0) if base is not None else D
        after = self.rest(D, features, fixed)
        sums = [[np.sum(s[self.block == b]) for b in self.labels] for s in (before**2, after**2, self.error**2, np.ones_like(D))]
        sums = np.array(sums)
        draws = np.random.default_rng(1).integers(0, len(self.labels), (1000, len(self.labels)))
        B, A, N, n = (s[draws].sum(1) for s in sums)
        corrected = lambda square: np.sqrt(np.maximum(square - N, 0) / n) / np.mean(self.truth)
        change = self.excess(np.mean(after**2)) - self.excess(np.mean(before**2))
        strength = [self.solve(D - fixed, features, np.isin(self.block, self.labels[d]))[-1] for d in draws[:60]]
        return dict(
            scene=self.name, term=term, parameters=parameters, pixels=D.size, noise=np.sqrt(np.mean(self.error**2)) / np.mean(self.truth),
            error=self.excess(np.mean(before**2)), change=change, change_se=np.std(corrected(A) - corrected(B)),
            strength=self.solve(D - fixed, features, np.ones_like(self.odd))[-1], strength_se=np.std(strength),
            median=self.median(self.truth - before), median_after=self.median(self.truth - after),
            noise_median=np.median(self.error / np.maximum(np.abs(self.truth), FLOOR * np.mean(self.truth))),
        )  # fmt: skip

    def solve(self, D, features, where):
        F = np.stack([f[where] for f in features], 1)
        return np.linalg.lstsq(F, D[where], rcond=None)[0]

    def rest(self, D, features, fixed):
        """What is left with strengths of the other half."""
        left = D - fixed
        for half in (self.odd, ~self.odd):
            s = self.solve(D - fixed, features, ~half)
            left = left - half * sum(a * f for a, f in zip(s, features))
        return left


def light_traps(g, held, cloud):
    """f(h) I_mean, against nothing and against a plain gain of I_mean."""
    ambient = 0.25 / np.pi
    shown = np.where(g.top, 1 - np.exp(-0.5 * g.kappa * g.chord), 0)
    pixel = lambda values: down((shown * values).reshape(g.shape))
    for share in (1.0, 1 / 3, 1 / 9):
        texels = max(int(round(share * g.cell / g.step)), 3)
        h, mean = g.traps(texels, ambient)
        profile(g, held, share, h)
        lights = {"Lambert mean": mean, "one mean": np.ones_like(mean), "own light": cloud.ravel()}
        for light, values in lights.items():
            for k in (1, 4, 16):
                f = np.arctan(k * (1 - h)) / np.arctan(k)
                words = f"{light} of {share:.2f} cells k={k}"
                yield held.fit("light trap", words, [pixel(f * values)])
                yield held.fit("light trap beyond a gain", words, [pixel(values), pixel(f * values)], base=[pixel(values)])


def profile(g, held, share, h):
    """Picture - truth over the truth's mean by local height, to stderr."""
    height, seen = (down((g.top * v).reshape(g.shape)) for v in (h, np.ones_like(h)))
    D = (held.picture - held.truth) / np.mean(held.truth)
    whole = seen > 0.99
    for low in np.arange(0, 1, 0.2):
        pick = whole & (height >= low) & (height < low + 0.2)
        if pick.sum() > 20:
            se = D[pick].std() / np.sqrt(pick.sum())
            print(f"{held.name} {share:.2f} cells: h {low:.1f}-{low + 0.2:.1f}: {pick.sum()} pixels, bias {D[pick].mean():+.4f} +- {se:.4f}", file=sys.stderr)


def coronas(g, held, cloud):
    """rho (1 - rho) cos^(K/q) added, and as printed: in place of (1 - rho) of the cloud's own light. q = chord's optical thickness."""
    q = g.kappa * g.chord
    forward = np.maximum(g.d @ g.sun, 1e-6)
    for opaque in (1, 3, 10):
        rho = np.minimum(q / opaque, 1)
        gone = -down(((1 - rho) * (q > 0) * cloud.ravel()).reshape(g.shape))
        for K in (1, 10, 100, 1000):
            lobe = down((rho * (1 - rho) * np.exp(np.maximum(K / np.maximum(q, 1e-3) * np.log(forward), -80))).reshape(g.shape))
            if lobe.max() < 1e-9:
                continue
            words = f"q1={opaque} K={K}"
            yield held.fit("corona added", words, [lobe])
            yield held.fit("corona as printed", words, [lobe], fixed=gone)


def made(command, path):
    if not path.exists():
        subprocess.run([str(c) for c in command], check=True, stdout=subprocess.DEVNULL)
    return path


def main(stratiform, heights, out, *names):
    root = Path(__file__).resolve().parent.parent
    model, samples, rows = os.environ.get("MODEL", "fitted"), os.environ.get("SAMPLES", "256"), []
    fine, coarse = (f"{SIZE[0] * k}x{SIZE[1] * k}" for k in (OVER, 1))
    for name in names or ("stratocumulus", "pseudo-specular", "silver-lining"):
        scene, folder = root / f"fit-configs/scenes/{name}.toml", Path(out) / name
        folder.mkdir(parents=True, exist_ok=True)
        truth = exr(made([stratiform, "truth", scene, "--size", coarse, "--samples", samples, "--out", folder], folder / "truth.exr"))
        draw = [stratiform, "render", scene, "--size", fine, "--model", model, "--out", folder / "picture.png", "--exr"]
        whole = luminance(exr(made([*draw, folder / f"{model}.exr"], folder / f"{model}.exr")))
        lit = folder / f"{model}-cloud.exr"
        cloud = luminance(exr(made([*draw, lit, "--without", "background"], lit)))
        g = Geometry(scene, made([heights, scene, folder / "heights.f32"], folder / "heights.f32"))
        held = Held(name, luminance(truth), luminance(truth, "std_error."), down(whole))
        rows += [*light_traps(g, held, cloud), *coronas(g, held, cloud)]
    with open(Path(out) / "neyret-terms.csv", "w", newline="") as file:
        for sink in (file, sys.stdout):
            table = csv.DictWriter(sink, FIELDS)
            table.writeheader()
            table.writerows({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows)


if __name__ == "__main__":
    main(*sys.argv[1:])
