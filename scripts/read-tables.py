#!/usr/bin/env python3
"""What `stratiform export` writes, read by other people's programs: numpy (npz), OpenEXR (EXR), ktx-parse (KTX2).

Usage: scripts/read-tables.py [FOLDER]     (default scripts/results)

Exports fit-configs/appendix-b.toml at 64, 256 and 1024 texels, installs the pinned packages into a temporary folder (pip; npm for
ktx-parse, the reader of three.js), and compares every number with the CSV file: npz exactly, f32 and f16 after numpy's own
rounding. Metadata must be the same in all containers. The look-up is done again with numpy alone, from the formula that the
metadata state, and its integral and g are compared with the printed card. Writes FOLDER/read-tables-DATE.md; exit code 1
if anything differs, 2 if a reader could not be installed.
"""

import csv, datetime, io, json, platform, subprocess, sys, tempfile, venv
from pathlib import Path

PACKAGES = ["numpy==2.4.6", "OpenEXR==3.5.3"]
KTX = "ktx-parse@1.1.0"
ROOT = Path(__file__).resolve().parent.parent
KTX_READER = """
import { read } from 'ktx-parse'; import fs from 'fs';
const file = read(new Uint8Array(fs.readFileSync(process.argv[2])));
const text = (value) => typeof value === 'string' ? value : new TextDecoder().decode(value);
const keys = Object.fromEntries(Object.entries(file.keyValue).map(([k, v]) => [k, text(v).replace(/\\0+$/, '')]));
const level = file.levels[0].levelData;
console.log(JSON.stringify({ format: file.vkFormat, width: file.pixelWidth, height: file.pixelHeight, keys,
    model: file.dataFormatDescriptor[0].colorModel, level: Buffer.from(level).toString('base64') }));
"""


class Reader:
    """Compares the files of one export; `lines` are the report's rows."""

    def __init__(self, folder, tools, cards):
        self.folder, self.tools, self.cards, self.lines, self.failures = folder, tools, cards, [], []

    def check(self, texels, file, reader, what, found, expected):
        import numpy as np

        found, expected = np.asarray(found), np.asarray(expected)
        same = found.shape == expected.shape and bool((found == expected).all())
        self.verdict(texels, file, reader, f"{what}: {found.size} numbers", same)

    def verdict(self, texels, file, reader, what, same):
        self.lines.append(f"| {texels} | {file} | {reader} | {what} | {'same' if same else 'DIFFERENT'} |")
        if not same:
            self.failures.append(f"{file}: {what}")

    def run(self, texels):
        import numpy as np

        metadata, names, table = read_csv(self.folder / "phase.csv")
        functions = [row["function"] for row in metadata["rows"]]
        channels = metadata["channel_names"]
        p = table[:, 3:].T.reshape(len(functions), len(channels), texels)
        document = json.loads((self.folder / "phase.json").read_text())
        self.check(texels, "phase.json", "json", "p", document["p"], p)
        self.verdict(texels, "phase.json", "json", "metadata", document["metadata"] == metadata)
        npz = np.load(self.folder / "phase.npz", allow_pickle=False)
        self.check(texels, "phase.npz", "numpy", "p", npz["p"], p)
        self.check(texels, "phase.npz", "numpy", "theta_deg", npz["theta_deg"], table[:, 2])
        self.check(texels, "phase.npz", "numpy", "coordinate", npz["coordinate"], table[:, 1])
        self.verdict(texels, "phase.npz", "numpy", "names", list(npz["functions"]) == functions and list(npz["channels"]) == channels)
        self.verdict(texels, "phase.npz", "numpy", "metadata", json.loads(str(npz["metadata"])) == metadata)
        planes, attribute = read_exr(self.folder / "phase.exr")
        self.check(texels, "phase.exr", "OpenEXR", "p", [planes[name] for name in channels], p.transpose(1, 0, 2).astype("f4"))
        self.verdict(texels, "phase.exr", "OpenEXR", "metadata", attribute == metadata)
        for precision in ("f4", "f2"):
            file = f"phase.rgba{16 if precision == 'f2' else 32}f.ktx2"
            pixels, keys = self.ktx2(file, precision)
            self.check(texels, file, "ktx-parse", "p", pixels[:, :, : len(channels)], p.transpose(0, 2, 1).astype(precision))
            self.verdict(texels, file, "ktx-parse", "metadata", json.loads(keys["stratiform"]) == metadata)
        self.parameters(texels)
        self.look_up(texels, metadata, functions, channels, p)

    def ktx2(self, file, precision):
        import base64, numpy as np

        command = ["node", str(self.tools / "read.mjs"), str(self.folder / file)]
        found = json.loads(subprocess.run(command, check=True, capture_output=True, cwd=self.tools).stdout)
        assert found["format"] == {"f4": 109, "f2": 97}[precision] and found["model"] == 1, found["format"]
        pixels = np.frombuffer(base64.b64decode(found["level"]), dtype="<" + precision)
        return pixels.reshape(found["height"], found["width"], 4), found["keys"]

    def parameters(self, texels):
        import numpy as np

        metadata, names, table = read_csv(self.folder / "parameters.csv")
        columns = dict(zip(names, table.T))
        npz = np.load(self.folder / "parameters.npz", allow_pickle=False)
        for name in ("mu_l", "b", "c", "kappa_c", "t", "r"):
            self.check(texels, "parameters.npz", "numpy", name, npz[name], columns[name])
        planes, attribute = read_exr(self.folder / "parameters.exr")
        held = {"mu_l": columns["mu_l"], "b": columns["b"], "t": columns["t"]}
        held |= {f"inverse_{name}": 1 / columns[name] for name in ("c", "kappa_c", "r")}
        for name, values in held.items():
            self.check(texels, "parameters.exr", "OpenEXR", name, planes[name][0], values.astype("f4"))
        self.verdict(texels, "parameters.exr", "OpenEXR", "metadata", attribute == metadata)
        for precision in ("f4", "f2"):
            file = f"parameters.rgba{16 if precision == 'f2' else 32}f.ktx2"
            pixels, keys = self.ktx2(file, precision)
            for row, names in enumerate(json.loads(keys["stratiformRows"])):
                for channel, name in enumerate(names):
                    values = held[name].astype(precision) if name else 0 * pixels[row, :, channel]
                    self.check(texels, file, "ktx-parse", name or "unused", pixels[row, :, channel], values)

    def look_up(self, texels, metadata, functions, channels, p):
        """The look-up at 400 001 angles, midpoint rule in cos(theta) and in each half of the map's coordinate."""
        import numpy as np

        assert metadata["angle_map"]["name"] == "double-ended square root"
        edge = np.linspace(0, 1, 400_001)
        angle = np.radians(np.where(edge < 0.5, 360 * edge**2, 180 - 360 * (1 - edge) ** 2))
        middle = 0.5 * (edge[1:] + edge[:-1])
        theta = np.radians(np.where(middle < 0.5, 360 * middle**2, 180 - 360 * (1 - middle) ** 2))
        weight = np.sin(0.5 * (angle[1:] + angle[:-1])) * np.sin(0.5 * (angle[1:] - angle[:-1]))
        for i, function in enumerate(functions):
            for j, channel in enumerate(channels):
                value = np.interp(middle, np.linspace(0, 1, texels), p[i, j])
                card = self.cards["phase.csv", function, channel]
                integral, g = (weight * value).sum(), (weight * value * np.cos(theta)).sum()
                same = abs(integral - float(card["integral"])) < 1e-8 and abs(g - float(card["asymmetry"])) < 1e-8
                what = f"look-up of {function} at {channel}: integral - 1 = {integral - 1:.0e}, g = {g:.7f}"
                self.verdict(texels, "phase.csv", "numpy", what, same)


def read_csv(path):
    """Metadata, names, and numbers; an angle that is a word becomes NaN."""
    import numpy as np

    first, rest = path.read_text().split("\n", 1)
    rows = list(csv.reader(io.StringIO(rest)))
    numbers = [[float(x) if x != "diffuse" else float("nan") for x in row] for row in rows[1:]]
    return json.loads(first[1:]), rows[0], np.array(numbers)


def read_exr(path):
    import OpenEXR

    file = OpenEXR.File(str(path), separate_channels=True)
    return {name: channel.pixels for name, channel in file.channels().items()}, json.loads(file.header()["stratiform"])


def install(folder):
    venv.create(folder / "venv", with_pip=True)
    python = folder / "venv" / "bin" / "python"
    subprocess.run([python, "-m", "pip", "install", "--quiet", *PACKAGES], check=True)
    subprocess.run(["npm", "install", "--silent", "--no-fund", KTX], check=True, cwd=folder, stdout=subprocess.DEVNULL)
    (folder / "read.mjs").write_text(KTX_READER)
    return python


def export(folder, texels):
    command = ["cargo", "run", "--quiet", "--", "export", "fit-configs/appendix-b.toml", "--out", str(folder), "--texels", str(texels)]
    text = subprocess.run(command, check=True, capture_output=True, text=True, cwd=ROOT).stdout
    rows = csv.DictReader(io.StringIO(text))
    return {(row["file"], row["function"], row["channel"]): row for row in rows}


def inside(tools, results):
    """Runs under the virtual environment's Python."""
    lines, failures = [], []
    for texels in (64, 256, 1024):
        folder = tools / str(texels)
        reader = Reader(folder, tools, export(folder, texels))
        reader.run(texels)
        lines, failures = lines + reader.lines, failures + reader.failures
    date = datetime.date.today().isoformat()
    head = [
        f"# Exported tables read by other programs, {date}",
        "",
        f"{', '.join(PACKAGES)}, {KTX}; Python {platform.python_version()}. Every number compared with the CSV file; `same` is equality "
        "to the last bit (after numpy's rounding to f32 and f16); look-ups within 1e-8 of the printed card.",
        "",
        f"{len(lines) - len(failures)} of {len(lines)} comparisons are the same.",
        "",
        "| texels | file | reader | what | verdict |",
        "| ---: | --- | --- | --- | --- |",
    ]
    results.mkdir(parents=True, exist_ok=True)
    (results / f"read-tables-{date}.md").write_text("\n".join(head + lines) + "\n")
    print(head[4])
    sys.exit(f"different: {failures}" if failures else 0)


def main():
    if len(sys.argv) == 4 and sys.argv[1] == "--inside":
        return inside(Path(sys.argv[2]), Path(sys.argv[3]))
    results = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "scripts" / "results").resolve()
    with tempfile.TemporaryDirectory() as folder:
        try:
            python = install(Path(folder))
        except (OSError, subprocess.CalledProcessError) as error:
            print(f"a reader could not be installed: {error}", file=sys.stderr)
            sys.exit(2)
        sys.exit(subprocess.run([python, __file__, "--inside", folder, str(results)]).returncode)


if __name__ == "__main__":
    main()
