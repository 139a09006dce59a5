#!/usr/bin/env python3
"""What a trace costs when it is spread out: measured here, extrapolated to 1e5 cores.

Usage: scripts/scaling.py STRATIFORM [STRATIFORM-MPI]     (release builds of the two commands)

Measures the slab SLAB: a photon's time; threads, shards and ranks on two cores; what a shard costs besides its photons; the
size of a part and the time to merge it; the start of MPI ranks. Prints the tables of scripts/scaling.md, whose formulas are
those of `efficiency`. Each time is the shortest of several runs: others may use the machine.
"""

import math, os, resource, subprocess, sys, tempfile, time
from pathlib import Path

SLAB = "trace --phase hg:0.85 --tau 1,5,16 --mu0 1 --quiet".split()
PHOTONS = 2_000_000
MPIRUN = "mpirun --oversubscribe --bind-to none --mca btl self,vader -n".split()
THREADS = 64  # of a shard on a cluster: one shard per node
WAIT = 1e-4  # s, latency of a message between nodes, assumed
BANDWIDTH = 1e9  # bytes/s of a message between nodes, assumed
FAN_OUT = 32  # of a launcher that starts nodes through nodes, assumed
VARIATION = 2.0  # standard deviation of a photon's work over its mean, assumed


def used():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def seconds(commands, repeats=7):
    """Shortest wall and processor time of running `commands` side by side."""
    walls, processors = [], []
    for _ in range(repeats):
        before, start = used(), time.perf_counter()
        running = [subprocess.Popen(command, stdout=subprocess.DEVNULL) for command in commands]
        if any(process.wait() for process in running):
            sys.exit(f"failed: {commands}")
        walls.append(time.perf_counter() - start)
        processors.append(used() - before)
    return min(walls), min(processors)


def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def head(*cells):
    row(*cells)
    row(*["---"] * len(cells))


def measure_cores(stratiform, mpi, folder):
    """Wall and processor time on one and two cores. Returns the seconds of a photon on one core."""
    photons = ["--photons", str(PHOTONS)]
    one = [stratiform, *SLAB, *photons, "--threads"]
    shard = lambda k: [*one, "1", "--shard", f"{k}/2", "--out", f"{folder}/{k}.bin"]
    runs = [("1 thread", [[*one, "1"]]), ("2 threads", [[*one, "2"]]), ("2 shards at once", [shard(1), shard(2)])]
    if mpi:
        runs += [(f"{n} rank{'s'[:n-1]}", [[*MPIRUN, str(n), mpi, *SLAB, *photons]]) for n in (1, 2)]
    head(f"{PHOTONS:.0e} photons", "wall, s", "processor, s")
    times = {}
    for name, commands in runs:
        times[name] = seconds(commands)
        row(name, *(f"{value:.2f}" for value in times[name]))
    start = seconds([[stratiform, *SLAB, "--photons", "2", "--threads", "1"]], 30)
    photon = (times["1 thread"][1] - start[1]) / PHOTONS
    print(f"\nstart to end of a trace of 2 photons: {start[0]*1e3:.0f} ms (processor {start[1]*1e3:.0f} ms)")
    print(f"one photon on one core: {photon*1e9:.0f} ns\n")
    return photon, start[0]


def measure_merge(stratiform, folder):
    """Returns bytes of a part and seconds to merge one, for 3 slabs × 5 rows and for 300 × 102."""
    head("slabs × orders", "bytes of a part", "of them per count", "merge of one part, ms")
    results = []
    for slabs, orders in ((3, 2), (30, 20), (100, 100)):
        tau = ",".join(str(0.2 * (k + 1)) for k in range(slabs))
        trace = [*SLAB[:4], tau, *SLAB[5:], "--orders", str(orders), "--photons", "1e6"]
        few, many, files = 4, 44, []
        for k in range(1, many + 1):
            files.append(f"{folder}/m{k}.bin")
            subprocess.run([stratiform, *trace, "--shard", f"{k}/{many}", "--out", files[-1]], check=True)
        size = os.path.getsize(files[0])
        # Files of one shard only cannot be merged; the slope over many is what one costs.
        for k in range(1, few + 1):
            subprocess.run([stratiform, *trace, "--shard", f"{k}/{few}", "--out", f"{folder}/f{k}.bin"], check=True)
        long = seconds([[stratiform, "merge", *files]], 15)[0]
        short = seconds([[stratiform, "merge", *(f"{folder}/f{k}.bin" for k in range(1, few + 1))]], 15)[0]
        merge = max(long - short, 0) / (many - few)
        counts = 256 * slabs * (2 * (orders + 2) + 3)
        row(f"{slabs} × {orders + 2}", size, f"{size / counts:.1f}", f"{merge*1e3:.2f}")
        results.append((size, merge))
    print()
    return results[0]


def measure_ranks(mpi):
    """Wall time of jobs of 2 photons. Returns the start of a job of one rank, and what another rank adds."""
    head("ranks on this machine", "start to end of 2 photons, s")
    walls = {}
    for ranks in (1, 2, 4, 8, 16):
        walls[ranks] = seconds([[*MPIRUN, str(ranks), mpi, *SLAB, "--photons", "2"]], 7)[0]
        row(ranks, f"{walls[ranks]:.2f}")
    slope = max(walls[16] - walls[1], 0) / 15
    print(f"\nanother rank on two cores: {slope*1e3:.0f} ms\n")
    return walls[1], slope


def measure_memory(stratiform):
    head("photons", "largest memory, MB")
    for photons in ("1e4", "1e6", "1e7"):
        command = [stratiform, *SLAB, "--photons", photons, "--threads", "2"]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        _, _, usage = os.wait4(process.pid, 0)
        row(photons, f"{usage.ru_maxrss / 1024:.1f}")
    print()


def uneven(photons, workers):
    """The slowest worker's excess over the mean: the largest of `workers` normal deviations."""
    return VARIATION * math.sqrt(2 * math.log(workers) / photons) if workers > 1 else 0.0


def launch(nodes, node):
    """Nodes start each other in a tree; each step takes `node` seconds."""
    return node * (1 + math.ceil(math.log(nodes, FAN_OUT)) if nodes > 1 else 1)


def efficiency(photons, cores, photon, start, part, ranks):
    """Ideal over real time of shards (one per THREADS cores) and of MPI (one rank per core)."""
    ideal, (size, merge) = photons * photon / cores, part
    nodes = math.ceil(cores / THREADS)
    shards = start + ideal * (1 + uneven(photons / nodes, nodes)) + nodes * merge + start
    begin, another = ranks
    node = begin + another / 32 * THREADS  # THREADS ranks on as many cores, where two cores took `another` each
    step = merge + WAIT + size / BANDWIDTH
    mpi = launch(nodes, node) + ideal * (1 + uneven(photons / cores, cores)) + math.ceil(math.log2(cores)) * step
    return shards, mpi, ideal


def extrapolate(photon, start, part, ranks):
    for index, name in enumerate(("shards of 64 threads, then one merge", "MPI, one rank per core")):
        print(f"Efficiency, {name} (seconds in brackets):\n")
        head("photons", *(f"{10**k:,} cores" for k in (2, 3, 4, 5)))
        for exponent in (9, 10, 11, 12, 13):
            cells = []
            for cores in (10**2, 10**3, 10**4, 10**5):
                result = efficiency(10**exponent, cores, photon, start, part, ranks)
                cells.append(f"{100 * result[2] / result[index]:.0f} % ({result[index]:.3g})")
            row(f"1e{exponent}", *cells)
        print()


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    stratiform, mpi = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
    os.environ |= {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    with tempfile.TemporaryDirectory() as folder:
        photon, start = measure_cores(stratiform, mpi, folder)
        measure_memory(stratiform)
        part = measure_merge(stratiform, folder)
    ranks = measure_ranks(mpi) if mpi else (0.5, 0.03)
    extrapolate(photon, start, part, ranks)


main()
