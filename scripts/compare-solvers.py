#!/usr/bin/env python3
"""The deterministic solver against nanodisort (cdisort) and PythonicDISORT: accuracy and time on the same slabs.

Usage: scripts/compare-solvers.py [FOLDER]     (default scripts/results)

Installs the pinned packages into a temporary virtual environment, builds the example `slabs` of stratiform-transport
in release mode, and runs all three one after the other, one thread each, in one run. Slabs and Legendre moments come
from the example. Writes FOLDER/compare-solvers-DATE.csv (every run) and .md (times to reach an accuracy).

Every code gets the same moments; delta-M is on in both others (they get the n+1 moments that n streams use). Their time
is the solving call alone, not their set-up: not counted are the choice of streams, which a user of them must guess,
nor PythonicDISORT's evaluation of the fluxes. Errors are held against the solver's run at 1e-8; the finest run of
nanodisort tells how far that truth can be trusted.
"""

import csv, datetime, os, platform, subprocess, sys, tempfile, time, venv
from pathlib import Path

PACKAGES = ["nanodisort==0.3.0", "PythonicDISORT==1.8", "numpy==2.4.6", "scipy==1.17.1"]
STREAMS = [8, 16, 24, 32, 48, 64, 96, 128, 256, 320]
TRUTH = 1e-8
TARGETS = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7]
# PythonicDISORT refuses an albedo of 1. Closer to 1 it loses digits, further away it absorbs.
ALMOST_ONE = 1 - 1e-7


def nanodisort(chi, tau, omega, mu0, streams):
    import nanodisort as nd
    import numpy as np

    state = nd.DisortState()
    state.nstr, state.nmom, state.nlyr, state.ntau = streams, streams, 1, 2
    state.usrtau, state.usrang, state.lamber, state.onlyfl, state.quiet = True, False, True, True, True
    state.allocate()
    state.umu0, state.phi0, state.fbeam, state.albedo, state.fisot = mu0, 0.0, 1 / mu0, 0.0, 0.0
    state.dtauc, state.ssalb, state.utau = np.array([tau]), np.array([omega]), np.array([0.0, tau])
    state.pmom = padded(chi, streams + 1)[:, None]
    start = time.perf_counter()
    try:
        state.solve()
    except RuntimeError:
        # It refuses a beam close to one of its streams.
        return float("nan"), float("nan"), float("nan")
    seconds = time.perf_counter() - start
    return state.flup[0], state.rfldn[-1] + state.rfldir[-1], seconds


def pythonic(chi, tau, omega, mu0, streams):
    import numpy as np
    from PythonicDISORT.pydisort import pydisort

    chi = padded(chi, streams + 1)
    start = time.perf_counter()
    _, up, down, *_ = pydisort(
        tau, min(omega, ALMOST_ONE), streams, chi[None, :], mu0, 1 / mu0, 0.0,
        NLeg=streams, only_flux=True, f_arr=chi[streams],
    )
    seconds = time.perf_counter() - start
    return np.ravel(up(0.0))[0], np.ravel(sum(down(tau)))[0], seconds


def padded(chi, count):
    import numpy as np

    return np.array([chi[l] if l < len(chi) else 0.0 for l in range(count)])


def others(ours, moments):
    """Rows of both codes for every slab of `ours`."""
    import warnings

    warnings.simplefilter("ignore")
    rows = []
    for phase, tau, omega, mu0 in slabs(ours):
        for name, run, repeats in [("nanodisort", nanodisort, 7), ("PythonicDISORT", pythonic, 5)]:
            for streams in STREAMS:
                count = repeats if streams <= 128 else 2
                runs = [run(moments[phase], tau, omega, mu0, streams) for _ in range(count)]
                r, t, _ = runs[0]
                seconds = min(seconds for _, _, seconds in runs)
                rows.append(row((phase, tau, omega, mu0), name, streams, r, t, [seconds]))
    return rows


def row(slab, code, streams, r, t, seconds, tolerance="", estimate=""):
    return {"slab": slab, "code": code, "tolerance": tolerance, "streams": streams, "r": float(r), "t": float(t),
            "estimate": estimate, "seconds": seconds}


def slabs(ours):
    return list(dict.fromkeys(row["slab"] for row in ours))


def read_ours(text):
    rows = []
    for line in csv.DictReader(text.splitlines()):
        slab = (line["phase"], float(line["tau"]), float(line["omega"]), float(line["mu0"]))
        seconds = [float(line[f"seconds_{name}"]) for name in ("from_moments", "first", "further")]
        code = "stratiform, tolerance given" if line["tolerance"] else "stratiform, streams given"
        rows.append(row(slab, code, 2 * int(line["streams"]), line["reflectance"], line["transmittance"], seconds,
                        line["tolerance"], line["error"]))
    return rows


def with_errors(rows):
    truth = {r["slab"]: (r["r"], r["t"]) for r in rows if r["tolerance"] and float(r["tolerance"]) == TRUTH}
    for r in rows:
        r["error"] = max(abs(a - b) for a, b in zip((r["r"], r["t"]), truth[r["slab"]]))
    return rows


def least(rows, code, place, slab, target):
    """Least mean seconds with which all mu0 of a slab are within `target` with the same streams or tolerance."""
    chosen = [r for r in rows if r["code"] == code and r["slab"][:3] == slab]
    best = None
    for key in dict.fromkeys((r["tolerance"] or r["streams"]) for r in chosen):
        group = [r for r in chosen if (r["tolerance"] or r["streams"]) == key]
        promised = all(not r["tolerance"] or float(r["tolerance"]) <= target for r in group)
        if promised and all(r["error"] <= target for r in group):
            mean = sum(r["seconds"][place] for r in group) / len(group)
            best = mean if best is None else min(best, mean)
    return "-" if best is None else f"{1e3 * best:.3f}"


COLUMNS = [
    ("nanodisort", "nanodisort", 0),
    ("PythonicDISORT", "PythonicDISORT", 0),
    ("streams given, first slab", "stratiform, streams given", 1),
    ("streams given, further slab", "stratiform, streams given", 2),
    ("streams given, from moments", "stratiform, streams given", 0),
    ("tolerance given, first slab", "stratiform, tolerance given", 1),
    ("tolerance given, further slab", "stratiform, tolerance given", 2),
    ("tolerance given, from moments", "stratiform, tolerance given", 0),
]


def markdown(rows, date):
    lines = [
        f"# Deterministic solvers compared, {date}",
        "",
        f"{', '.join(PACKAGES)}; Python {platform.python_version()}; stratiform-transport built in release mode. "
        f"Machine: {machine()}. One thread each; the least of several runs.",
        "",
        "Milliseconds per slab and angle until reflectance and transmittance for mu0 = 1, 0.5, 0.3 and 0.1 are all within "
        "the error of the truth (`-`: not reached with up to 320 streams). The two others get their streams given; "
        "delta-M is on; only their solving call is timed. Three times are given for stratiform. *From moments*: "
        "everything. *First slab*: the projection of the phase function done (for up to 64 streams). *Further slab*: the medium's modes "
        "known, as for every further thickness or angle. *Tolerance given* includes the search for the streams and "
        "gives an estimate of the error, which the others do not. "
        "Every figure is for one slab and one angle.",
        "",
        "| slab | error | " + " | ".join(name for name, _, _ in COLUMNS) + " |",
        "| --- | --- |" + " ---: |" * len(COLUMNS),
    ]
    for slab in dict.fromkeys(r["slab"][:3] for r in rows):
        name = f"{slab[0]}, tau {slab[1]:g}, omega {slab[2]:g}"
        for target in TARGETS:
            cells = [least(rows, code, place, slab, target) for _, code, place in COLUMNS]
            lines.append(f"| {name} | {target:.0e} | " + " | ".join(cells) + " |")
    return "\n".join(lines + ["", *truth_section(rows), ""])


def truth_section(rows):
    lines = [
        "## The truth",
        "",
        "The solver's run at a tolerance of 1e-8. The largest difference over mu0 from it: of the other codes with the "
        "number of streams that comes closest for each mu0 (nanodisort refuses a beam close to a stream and answers NaN in some cases, PythonicDISORT's rounding grows with "
        "streams at omega near 1); and the largest error that the solver itself reports.",
        "",
        "| slab | nanodisort | PythonicDISORT | reported |",
        "| --- | ---: | ---: | ---: |",
    ]
    for slab in dict.fromkeys(r["slab"][:3] for r in rows):
        of = [r for r in rows if r["slab"][:3] == slab]
        nano, pythonic = (closest(of, code) for code in ("nanodisort", "PythonicDISORT"))
        own = max(float(r["estimate"]) for r in of if r["tolerance"] and float(r["tolerance"]) == TRUTH)
        lines.append(f"| {slab[0]}, tau {slab[1]:g}, omega {slab[2]:g} | {nano} | {pythonic} | {own:.1e} |")
    return lines


def closest(rows, code):
    """Largest over mu0 of the least error over the streams."""
    least = {}
    for r in rows:
        if r["code"] == code and r["error"] == r["error"]:
            least[r["slab"]] = min(r["error"], least.get(r["slab"], float("inf")))
    return f"{max(least.values()):.1e}"


def machine():
    model = "unknown processor"
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
    return f"{model}, {os.cpu_count()} cores, shared with other work"


def write(rows, folder, date):
    folder.mkdir(parents=True, exist_ok=True)
    name = folder / f"compare-solvers-{date}"
    with open(f"{name}.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["phase", "tau", "omega", "mu0", "code", "tolerance", "streams", "reflectance", "transmittance",
                        "error", "estimated_error", "seconds_from_moments", "seconds_first", "seconds_further"])
        for r in rows:
            seconds = [f"{s:.3e}" for s in r["seconds"]]
            table.writerow([*r["slab"], r["code"], r["tolerance"], r["streams"], f"{r['r']:.12f}", f"{r['t']:.12f}",
                            f"{r['error']:.2e}", r["estimate"] and f"{float(r['estimate']):.2e}", *seconds,
                            *[""] * (3 - len(seconds))])
    Path(f"{name}.md").write_text(markdown(rows, date))
    print(f"{name}.md", f"{name}.csv", sep="\n")


def compare(folder):
    root = Path(__file__).resolve().parent.parent
    with tempfile.TemporaryDirectory() as temporary:
        file = Path(temporary) / "moments.csv"
        command = ["cargo", "run", "-q", "--release", "-p", "stratiform-transport", "--example", "slabs", "--", str(file)]
        ours = read_ours(subprocess.run(command, cwd=root, check=True, capture_output=True, text=True).stdout)
        moments = {}
        for line in csv.DictReader(file.read_text().splitlines()):
            moments.setdefault(line["phase"], []).append(float(line["chi"]))
    date = datetime.date.today().isoformat()
    write(with_errors(ours + others(ours, moments)), folder, date)


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "results"
    if os.environ.get("COMPARE_SOLVERS_INSIDE"):
        compare(folder)
        return
    with tempfile.TemporaryDirectory() as temporary:
        venv.create(temporary, with_pip=True)
        python = str(Path(temporary) / "bin" / "python")
        subprocess.run([python, "-m", "pip", "install", "-q", *PACKAGES], check=True)
        threads = {name: "1" for name in
                   ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "RAYON_NUM_THREADS")}
        environment = {**os.environ, **threads, "COMPARE_SOLVERS_INSIDE": "1"}
        subprocess.run([python, __file__, str(folder.resolve())], check=True, env=environment)


main()
