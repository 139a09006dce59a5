#!/usr/bin/env python3
"""The files written for other programs, loaded by those programs: what they evaluate against the tables of origin.

Usage: scripts/peers-check.py [FOLDER]     (default scripts/results)

Builds the example `peer_files` of stratiform-tables, which writes every file for the paper's cloud, then installs the
pinned packages into two temporary virtual environments and asks
  - Mitsuba 3: `tabphase`, values at many angles, its integral, samples, and which end is forward;
  - Eradiate and its kernel: `tabphase_irregular`; the netCDF file by netCDF4, by xarray and by Eradiate's own loader,
    interpolated and evaluated in its kernel;
  - pmcx: its reader of the JSON input, and the lookup of its kernel carried out here (the program itself needs CUDA);
  - nanodisort (cdisort): the radiance of a thin layer from PMOM, which is P itself.
Writes FOLDER/peers-check-DATE.md. Exits 1 if a program disagrees with what the writer reported for it.
"""

import csv, datetime, json, subprocess, sys, tempfile, venv
from pathlib import Path

ENVIRONMENTS = {
    "mitsuba": ["mitsuba==3.9.1", "numpy==2.4.6", "nanodisort==0.3.0", "pmcx==0.8.1", "jdata==0.9.5"],
    "eradiate": ["eradiate[kernel]==1.2.0"],
}
DEGREES = [0.0, 0.05, 0.1, 0.3, 1.0, 2.0, 4.0, 6.0, 10.0, 30.0, 60.0, 90.0, 120.0, 138.0, 142.0, 160.0, 170.0, 175.0,
           177.5, 179.0, 179.7, 180.0]


class Table:
    """P of a CSV file, linear in the angle; a repeated angle is a jump."""

    def __init__(self, path):
        import numpy as np

        with open(path) as file:
            rows = [(float(r["theta_deg"]), float(r["p"])) for r in csv.DictReader(file)]
        self.theta, self.p = np.radians([r[0] for r in rows]), np.array([r[1] for r in rows])

    def at(self, theta):
        import numpy as np

        return np.interp(theta, self.theta, self.p)


class Report:
    def __init__(self):
        self.rows, self.failed = [], 0

    def add(self, program, file, what, value, bound):
        good = bool(value <= bound)
        self.failed += not good
        self.rows.append([program, file, what, f"{value:.2e}", f"{bound:.2e}", "yes" if good else "NO"])


def kernel_phase(mi, path):
    """The plugin of an XML fragment, and its value at Θ per steradian times 4π, evaluated in the kernel."""
    import numpy as np

    text = Path(path).read_text()
    text = text[text.index("<phase"):].replace("<phase ", '<phase version="3.0.0" ', 1)
    plugin = mi.load_string(text)
    interaction = mi.MediumInteraction3f()
    interaction.wi = mi.Vector3f(0, 0, 1)
    interaction.sh_frame = mi.Frame3f(interaction.wi)
    context = mi.PhaseFunctionContext()

    def evaluate(theta):
        # wi points back to where the light comes from: -wi is forward.
        out = [float(plugin.eval_pdf(context, interaction, mi.Vector3f(float(np.sin(t)), 0.0, float(-np.cos(t))))[1])
               for t in np.atleast_1d(theta)]
        return 4 * np.pi * np.array(out)

    def sample(count, seed=1):
        generator = np.random.default_rng(seed)
        cosines = []
        for a, b, c in generator.random((count, 3)):
            wo = plugin.sample(context, interaction, float(a), mi.Point2f(float(b), float(c)))[0]
            cosines.append(-float(wo.z))
        return np.array(cosines)

    return evaluate, sample


def rounding(table, theta):
    """What the cosine's rounding in f32 does to P."""
    import numpy as np

    near = [np.arccos(np.clip(np.cos(theta) + d, -1, 1)) for d in (-6e-8, 6e-8)]
    return np.abs(table.at(near[0]) - table.at(near[1])) / np.maximum(table.at(theta), 1e-3)


def check_kernel(report, program, mi, folder, file, source, card, single=True):
    import numpy as np

    table = Table(folder / source)
    evaluate, sample = kernel_phase(mi, folder / file)
    theta = np.radians(DEGREES)
    error = np.abs(evaluate(theta) / np.maximum(table.at(theta), 1e-3) - 1)
    error -= rounding(table, theta) if single else 0
    if "modified" in file:
        # Beyond the jump, by two cells of an equidistant table.
        cells = int(file.split("-")[1]) - 1 if file.startswith("tabphase") else 65536
        beyond = np.cos(theta) < np.cos(np.radians(5)) - 4.2 / cells
        error, theta = error[beyond], theta[beyond]
    report.add(program, file, "largest relative error at 22 angles", error.max(), 1.02 * card["largest_error"] + 1e-5)
    glory = theta >= np.radians(170)
    report.add(program, file, "relative error over 170-180 degrees", error[glory].max(), 1.02 * card["glory_error"] + 1e-5)
    # In u = theta^(1/3) the peak is spread out.
    u = np.linspace(0, np.pi ** (1 / 3), 20001)
    t = u**3
    f = 0.5 * evaluate(t) * np.sin(t) * 3 * u**2
    integral, g = np.trapezoid(f, u), np.trapezoid(f * np.cos(t), u)
    report.add(program, file, "integral less 1", abs(integral - 1), 2e-4)
    report.add(program, file, "g less the reported one", abs(g - card["asymmetry"]), 2e-4)
    mu = sample(20000)
    # Four standard errors of the mean.
    report.add(program, file, "mean cosine of 20000 samples less g", abs(mu.mean() - card["asymmetry"]), 4 * mu.std() / 20000**0.5)
    flipped = np.abs(evaluate(np.pi - theta) / np.maximum(table.at(theta), 1e-3) - 1).max()
    report.add(program, file, "a flipped sign would be seen: 1 / largest error", 1 / flipped, 0.1)


def check_mitsuba(folder, card, report):
    import mitsuba as mi

    mi.set_variant("scalar_rgb")
    for name in ("full", "modified"):
        for count in (1025, 65537):
            file = f"tabphase-{count}-{name}.xml"
            check_kernel(report, "mitsuba", mi, folder, file, f"source-{name}.csv", card[file][0])


def check_mcx(folder, card, report):
    """The program's reader, then its lookup: tmp = ξ (n-1), linear between the padded values, in f32."""
    import numpy as np
    import pmcx

    for name in ("full", "modified"):
        table = Table(folder / f"source-{name}.csv")
        for count in (254, 1022):
            file = f"mcx-{count}-{name}.json"
            read = np.asarray(json.loads((folder / file).read_text())["Domain"]["InverseCDF"], dtype=np.float32)
            nphase = len(read) + 2
            report.add("pmcx", file, "values modulo 2 (an odd number would be padded)", nphase % 2, 0)
            padded = np.concatenate([[-1], read, [1]]).astype(np.float32)
            report.add("pmcx", file, "values that do not ascend", int((np.diff(padded) <= 0).sum()), 0)
            xi = np.random.default_rng(7).random(2_000_000)
            place = xi * (nphase - 1)
            left = place.astype(int)
            mu = (1 - (place - left)) * padded[left] + (place - left) * padded[left + 1]
            g = card[file][0]["asymmetry"]
            report.add("pmcx", file, "mean cosine of 2e6 lookups less g", abs(mu.mean() - g), 4 * mu.std() / len(mu) ** 0.5)
            fine = np.unique(np.concatenate([np.linspace(*pair, 9) for pair in zip(table.theta[:-1], table.theta[1:])]))
            weight = 0.5 * table.at(fine) * np.sin(fine)
            cumulative = np.concatenate([[0], np.cumsum(0.5 * (weight[1:] + weight[:-1]) * np.diff(fine))])
            for degrees in (1, 5, 30, 90, 140):
                truth = np.interp(np.radians(degrees), fine, cumulative) / cumulative[-1]
                share = (mu > np.cos(np.radians(degrees))).mean()
                # Within a bin, and four standard errors.
                bound = 1 / (nphase - 1) + 4 * (max(truth * (1 - truth), 1e-6) / len(mu)) ** 0.5
                report.add("pmcx", file, f"probability below {degrees} degrees", abs(share - truth), bound)
    report.add("pmcx", "mcx-254-full.json", "invcdf is a field of the program's own reader", 0 if reads_invcdf(pmcx, folder) else 1, 0)


def reads_invcdf(pmcx, folder):
    import numpy as np

    document = json.loads((folder / "mcx-254-full.json").read_text())
    reader = getattr(pmcx, "json2mcx", None)
    if reader is None:
        return False
    whole = {"Session": {"Photons": 1}, "Forward": {"T0": 0, "T1": 1e-9, "Dt": 1e-9},
             "Optode": {"Source": {"Pos": [0, 0, 0], "Dir": [0, 0, 1], "Type": "pencil"}},
             "Domain": {"Dim": [2, 2, 2], "Media": [{"mua": 0, "mus": 0, "g": 1, "n": 1}], **document["Domain"]},
             "Shapes": [{"Grid": {"Tag": 1, "Size": [2, 2, 2]}}]}
    return np.allclose(np.ravel(reader(whole)["invcdf"]), document["Domain"]["InverseCDF"])


def check_disort(folder, card, report):
    """A layer of tau 1e-4 seen from below: the radiance is tau P(Θ)/(4π μ) F to first order."""
    import numpy as np

    for name in ("full",):
        file = f"pmom-1024-{name}.txt"
        chi = np.array([float(line) for line in (folder / file).read_text().splitlines() if not line.startswith("#")])
        table = Table(folder / f"source-{name}.csv")
        report.add("DISORT", file, "chi_0 less 1", abs(chi[0] - 1), 0)
        report.add("DISORT", file, "chi_1 less g", abs(chi[1] - card[file][0]["asymmetry"]), 1e-13)
        theta = np.radians(DEGREES)
        series = np.polynomial.legendre.legval(np.cos(theta), (2 * np.arange(len(chi)) + 1) * chi)
        error = np.abs(series / table.at(theta) - 1).max()
        report.add("numpy", file, "largest relative error of the series at 22 angles", error, 1.02 * card[file][0]["largest_error"] + 1e-6)
        error, angles = thin_layer(chi, table)
        report.add("DISORT", file, f"single scattering in a layer of tau 1e-4, {angles} angles", error, 2e-3)


def thin_layer(chi, table):
    import nanodisort as nd
    import numpy as np

    tau, mu0 = 1e-4, 1.0
    degrees = np.array([10.0, 20.0, 40.0, 60.0, 75.0, 105.0, 120.0, 139.0, 142.0, 150.0, 165.0, 175.0])
    umu = np.sort(-np.cos(np.radians(degrees)))
    state = nd.DisortState()
    streams, moments = 64, len(chi) - 1
    state.nstr, state.nmom, state.nlyr, state.ntau, state.numu, state.nphi = streams, moments, 1, 2, len(umu), 1
    state.usrtau, state.usrang, state.lamber, state.onlyfl, state.quiet = True, True, True, False, True
    # The correction from moments (Nakajima & Tanaka 1988); the other kind wants the phase function itself.
    state.intensity_correction, state.old_intensity_correction = True, True
    state.allocate()
    state.umu0, state.phi0, state.fbeam, state.albedo, state.fisot = mu0, 0.0, 1.0, 0.0, 0.0
    state.dtauc, state.ssalb, state.utau = np.array([tau]), np.array([1.0]), np.array([0.0, tau])
    state.umu, state.phi = umu, np.array([0.0])
    state.pmom = chi[:, None]
    state.solve()
    radiance = np.asarray(state.uu)
    errors = []
    for i, u in enumerate(umu):
        truth = tau * table.at(np.arccos(np.clip(-u, -1, 1))) / (4 * np.pi * abs(u))
        lit = 0 if u > 0 else 1
        value = radiance.reshape(len(umu), 2, -1)[i, lit, 0]
        errors.append(abs(value / truth - 1))
    return max(errors), len(errors)


def check_eradiate(folder, card, report):
    import eradiate
    import eradiate.kernel
    import mitsuba as mi
    import netCDF4
    import numpy as np
    import xarray as xr

    path = folder / "particles.nc"
    mi.set_variant("scalar_mono_double")
    for name in ("full", "modified"):
        file = f"irregular-{name}.xml"
        check_kernel(report, "eradiate kernel, double", mi, folder, file, f"source-{name}.csv", card[file][0], single=False)
    mi.set_variant("scalar_rgb")
    for name in ("full", "modified"):
        file = f"irregular-{name}.xml"
        check_kernel(report, "eradiate kernel, f32", mi, folder, file, f"source-{name}.csv", card[file][0])

    with netCDF4.Dataset(path) as data:
        kinds = {k: len(v) for k, v in data.dimensions.items()}
        report.add("netCDF4", path.name, f"variables that are missing ({data.data_model}, {kinds})",
                   len({"w", "mu", "theta", "phase", "ext", "ssa", "nangles", "pmom", "nmom"} - set(data.variables)), 0)
    data = xr.load_dataset(path)
    for i, w in enumerate(data["w"].values):
        n = int(data["nangles"][i])
        mu, p = data["mu"].values[i, :n], data["phase"].values[0, i, :n]
        report.add("xarray", path.name, f"{w:.0f} nm: integral over mu less 2", abs(np.trapezoid(p, mu) - 2), 1e-9)
        report.add("xarray", path.name, f"{w:.0f} nm: cosines that do not ascend", int((np.diff(mu) <= 0).sum()), 0)
        report.add("xarray", path.name, f"{w:.0f} nm: theta less acos mu, radians",
                   np.abs(np.radians(data["theta"].values[i, :n]) - np.arccos(mu)).max(), 1e-9)

    eradiate.set_mode("mono_double")
    from eradiate import unit_registry as ureg
    from eradiate.radprops import ParticleProperties
    from eradiate.util.pmom import compute_pmom

    properties = ParticleProperties.convert(str(path))
    for i, nm in enumerate((450, 550, 650)):
        table = Table(folder / f"source-{nm}nm.csv")
        mu, phase = properties.eval_phase(nm * ureg.nm)
        theta = np.radians(DEGREES)
        value = np.interp(np.cos(theta), mu, phase[0])
        limit = 1.02 * card["particles.nc"][i]["largest_error"] + 1e-6
        report.add("eradiate loader", path.name, f"{nm} nm: largest relative error at 22 angles", np.abs(value / table.at(theta) - 1).max(), limit)
        n = int(data["nangles"][i])
        own = compute_pmom(data["theta"].values[i, :n][::-1], data["phase"].values[0, i, :n][::-1], nmom=256,
                           grid_res=3, coefficients=True, check_normalization=True)
        written = properties.eval_pmom(nm * ureg.nm)[0][:256, 0]
        scale = 2 * np.arange(256) + 1
        report.add("eradiate pmom", path.name, f"{nm} nm: largest difference of 256 moments", np.abs((own - written) / scale).max(), 2e-5)
        report.add("eradiate loader", path.name, f"{nm} nm: extinction less the file's",
                   abs(float(properties.eval_ext(nm * ureg.nm).m) - float(data["ext"][i])), 1e-12)


def programs(environment, folder):
    """Runs inside an environment; prints the rows as JSON."""
    folder = Path(folder)
    card = json.loads((folder / "cards.json").read_text())
    report = Report()
    checks = {"mitsuba": [check_mitsuba, check_mcx, check_disort], "eradiate": [check_eradiate]}[environment]
    for check in checks:
        check(folder, card, report)
    print("RESULT" + json.dumps({"rows": report.rows, "failed": report.failed}))


def main():
    root = Path(__file__).resolve().parent.parent
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else root / "scripts" / "results"
    rows, failed = [], 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "files"
        subprocess.run(["cargo", "run", "-q", "-p", "stratiform-tables", "--example", "peer_files", "--", folder],
                       cwd=root, check=True, stdout=subprocess.DEVNULL)
        for environment, packages in ENVIRONMENTS.items():
            home = Path(scratch) / environment
            venv.create(home, with_pip=True)
            subprocess.run([home / "bin" / "pip", "-q", "install", *packages], check=True)
            answer = subprocess.run([home / "bin" / "python", __file__, "--inside", environment, folder],
                                    check=True, stdout=subprocess.PIPE, text=True).stdout
            result = json.loads(answer[answer.index("RESULT") + 6:])
            rows += result["rows"]
            failed += result["failed"]
    write(out, rows, failed)
    print(f"{len(rows) - failed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


def write(out, rows, failed):
    today = datetime.date.today().isoformat()
    packages = "; ".join(", ".join(p) for p in ENVIRONMENTS.values())
    lines = [f"# Files for other programs, loaded by them, {today}", "", f"{packages}. The paper's cloud (r_e 7 um), 0.55 um; "
             "`full` is P, `modified` P without its peak below 5 degrees, compared beyond the jump.", "",
             f"{len(rows) - failed} of {len(rows)} comparisons are within their bound. A relative error's bound is what the "
             "writer's own card of the file says, and 2 %.", "",
             "| program | file | what | found | bound | within |", "| --- | --- | --- | ---: | ---: | --- |"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    (out / f"peers-check-{today}.md").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--inside"]:
        programs(sys.argv[2], sys.argv[3])
    else:
        main()
