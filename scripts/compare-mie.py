#!/usr/bin/env python3
"""The size average against miepython, with numba and without, and against scatrs: time at equal error.

Usage: scripts/compare-mie.py [FOLDER]     (default scripts/results)

Runs the bench `spectrum` of stratiform-optics in release mode, which times stratiform and scatrs and writes the spheres,
angles and phase functions of the paper's cloud at three wavelengths. Then miepython, pinned and installed into a temporary
virtual environment, sums the same spheres at the same angles: the error of the size average is the same by construction,
and the largest difference of P is told. One thread each; plain miepython computes every 64th sphere only, scaled.
Writes FOLDER/compare-mie-DATE.md. Seconds are those that the processor spent, so that other work does not count.
"""

import csv, datetime, json, os, platform, subprocess, sys, tempfile, time, venv
from pathlib import Path

PACKAGES = ["miepython==3.3.0", "numba==0.68.1", "numpy==2.4.6", "scipy==1.17.1"]
ROOT = Path(__file__).resolve().parent.parent


def table(file):
    import numpy as np

    return np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2).T


def repeat(folder, wavelength, every):
    """Seconds of processor for all spheres, and the largest relative difference of P (nan if only some were summed)."""
    import miepython as mie
    import numpy as np

    (n,), (k,) = table(folder / f"m-{wavelength}.csv")
    x, weight = table(folder / f"spheres-{wavelength}.csv")
    theta, p = table(folder / f"phase-{wavelength}.csv")
    m, mu = complex(n, -k), np.cos(np.radians(theta))
    mie.i_unpolarized(m, x[0], mu, norm="wiscombe")  # numba compiles
    mie.efficiencies_mx(m, x[0])
    start = time.process_time()
    intensity, scattering = np.zeros_like(mu), 0.0
    for size, share in zip(x[::every], weight[::every]):
        _, q_sca, _, _ = mie.efficiencies_mx(m, size)
        # |S|^2 of Wiscombe's amplitudes: no factor between spheres.
        intensity += share * mie.i_unpolarized(m, size, mu, norm="wiscombe")
        scattering += share * q_sca * size**2
    seconds = (time.process_time() - start) * len(x) / len(x[::every])
    ours = 4 * intensity / scattering
    # The table is divided by its own norm.
    scale = np.median(ours / p)
    return seconds, float(np.max(np.abs(ours / scale / p - 1))) if every == 1 else float("nan")


def inside(folder):
    every = 1 if os.environ.get("MIEPYTHON_USE_JIT") == "1" else 64
    wavelengths = [file.stem[2:] for file in sorted(Path(folder).glob("m-*.csv"))]
    print(json.dumps({w: repeat(Path(folder), w, every) for w in wavelengths}))


def python_with(packages, folder):
    venv.create(folder, with_pip=True)
    python = str(Path(folder) / "bin" / "python")
    done = subprocess.run([python, "-m", "pip", "install", "-q", *packages], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"compare-mie: NOTHING COMPARED: pip cannot install {' '.join(packages)}:\n{done.stderr}")
    return python


def machine():
    names = [line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
    return f"{names[0] if names else platform.processor()}, {os.cpu_count()} cores, shared with other work"


def markdown(printed, ours, jit, plain):
    lines = [
        f"# Mie averages compared, {datetime.date.today().isoformat()}",
        "",
        f"`scripts/compare-mie.py`: {', '.join(PACKAGES)}; Python {platform.python_version()}; scatrs 0.3 (a dev-dependency). "
        f"Machine: {machine()}. The paper's cloud (modified gamma, gamma = 2, r_e = 7 um; Hale & Querry's water), seconds "
        "of processor, one thread each.",
        "",
        "miepython sums the spheres of stratiform's own average at the same angles (`same P to`: the largest relative "
        "difference), so the error of the size average is the same; without numba every 64th sphere was computed and the "
        "time scaled. scatrs chooses its radii itself, to the relative tolerance given. Errors of P are relative, "
        "against sixteen times the radii. stratiform's time includes the refinements that find how many radii are needed.",
        "",
        "| wavelength, um | code | seconds | times stratiform | error of P below 60 deg | beyond | same P to |",
        "| --- | --- | ---: | ---: | ---: | ---: | ---: |",
    ]
    for w in dict.fromkeys(row["wavelength_um"] for row in ours):
        rows = [row for row in ours if row["wavelength_um"] == w]
        own = float(rows[0]["processor_seconds"])
        for row in rows:
            spheres = f", {row['radii']} spheres, {row['angles']} angles" if row["radii"] else ""
            seconds = float(row["processor_seconds"])
            lines.append(f"| {w} | {row['code']}{spheres} | {seconds:.3g} | {seconds / own:.3g} | {row['p_below_60']} | {row['p_beyond_60']} | |")
        for name, results in [("miepython, numba", jit), ("miepython", plain)]:
            seconds, off = results[w]
            same = "" if off != off else f"{off:.1e}"
            lines.append(f"| {w} | {name} | {seconds:.3g} | {seconds / own:.3g} | {rows[0]['p_below_60']} | {rows[0]['p_beyond_60']} | {same} |")
    return "\n".join([*lines, "", "The bench's other lines:", "", "```text", *printed, "```", ""])


def main():
    results = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "scripts" / "results"
    with tempfile.TemporaryDirectory() as temporary:
        python = python_with(PACKAGES, Path(temporary) / "venv")
        spheres = Path(temporary) / "spheres"
        bench = ["cargo", "bench", "-q", "-p", "stratiform-optics", "--bench", "spectrum", "--", str(spheres)]
        text = subprocess.run(bench, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
        printed, rows = text.split("code,", 1)
        ours = list(csv.DictReader(("code," + rows).splitlines()))

        def miepython(jit):
            environment = {**os.environ, "MIEPYTHON_USE_JIT": jit, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
            command = [python, __file__, "--inside", str(spheres)]
            done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env=environment)
            return json.loads(done.stdout)

        page = markdown(printed.strip().splitlines(), ours, miepython("1"), miepython("0"))
    results.mkdir(parents=True, exist_ok=True)
    file = results / f"compare-mie-{datetime.date.today().isoformat()}.md"
    file.write_text(page)
    print(file)


if sys.argv[1:2] == ["--inside"]:
    inside(sys.argv[2])
else:
    main()
