# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Dry spheres by this library, LIGGGHTS, LAMMPS, and Siconos' NSGS: tests/benchmark/run peers --help"""

import argparse
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import softRuns     # brings the folder of the benchmarks to the path
import frozen
import ourRuns
from pinnedRun import CORE
from results import ROOT, Table, bars, pyplot, savePicture
from softPeers import PEERS, RESTITUTION, timeStep

BEDS = ROOT/"build/beds"
EVERY = 0.05        # s between states of a collapse
MODULI = (5e6, 1e8)             # Pa
GLASS = 5e10
MOST_ITERATIONS = 20000
OUR_STEPS, REST_STEPS = 10, 50
PEER_SECONDS = {5e6: 6e-3, 1e8: 1e-3}       # s of motion in a window of as many grains as this; longer where there are fewer, or start-up hides it
MANY = 25230


def arguments():
    parser = argparse.ArgumentParser(prog="tests/benchmark/run peers", description=__doc__.split(":")[0])
    parser.add_argument("parts", nargs="*", help="of: prepare collapse rest glass accuracy frozen (default: all, in this order)")
    parser.add_argument("--bed", type=Path, default=BEDS/"bed29x30.dat", help="settled bed of LIGGGHTS and LAMMPS (%(default)s)")
    parser.add_argument("--frozen", type=Path, default=BEDS/"bed20x25.dat", help="settled bed of Siconos (%(default)s)")
    parser.add_argument("--moments", type=int, nargs="+", default=[1, 2, 4, 6], help="of the collapse, in %g s, to time windows at; it is run to the last" % EVERY)
    parser.add_argument("--restitution", type=float, nargs="+", default=[0.0], help="of the collapse (default: 0; the soft peers, which need some, then have %g)" % RESTITUTION)
    parser.add_argument("--reference", action="store_true", help="also make the reference run of the collapse: hours")
    parser.add_argument("--tolerances", type=float, nargs="+", default=[1e-2, 1e-3], help="of our frozen solves (default: 1e-2 1e-3)")
    parser.add_argument("--core", type=int, default=CORE, help="core all are pinned to (default: BENCHMARK_CORE, else 0)")
    return parser.parse_args()


def installed():
    """Those of the soft peers that are there; the others are named."""
    there = [peer for peer in PEERS if softRuns.isInstalled(peer)]
    for peer in PEERS:
        if peer not in there:
            print("%s is not installed (Debian package %s): left out" % (peer, {"LIGGGHTS": "liggghts", "LAMMPS": "lammps"}[peer]))
    return there


def hasSiconos():
    try:
        import siconos.numerics     # noqa: F401
        return True
    except ImportError:
        print("Siconos is not installed for this Python (Debian package python3-siconos): frozen problems left out")
        return False


def settledBed(path, core):
    if not path.exists():
        perSide, layers = path.stem.replace("bed", "").split("x")
        path.parent.mkdir(parents=True, exist_ok=True)
        frozen.subprocess.run([ROOT/"build/core/benchmark/coldSolve", "settle", path, perSide, layers, "2000"], check=True)
    with open(path) as file:
        return [float(word) for word in file.readline().split()]


def prepare(o, peers):
    """Whole motions of everybody, which leave the states that windows start from."""
    softRuns.FOLDER.mkdir(parents=True, exist_ok=True)
    periods, grains = settledBed(o.bed, o.core), ourRuns.settle(o.bed, o.core)
    for setting in ourRuns.SETTINGS:
        for restitution in o.restitution if setting != "reference" or o.reference else ():
            ourRuns.moveWhole(o.bed, setting, EVERY, max(o.moments), o.core, restitution)
    for peer in peers:
        for modulus in MODULI:
            softRuns.moveWhole(peer, modulus, "bed", grains["bed"], periods, EVERY, 0, o.core)
            for restitution in o.restitution:
                softRuns.moveWhole(peer, modulus, "collapse", grains["box"], periods, EVERY, max(o.moments), o.core, softRestitution(restitution))


def softRestitution(restitution):
    """Soft grains that do not bounce at all would need a dashpot without end."""
    return restitution or RESTITUTION


def peerRow(o, table, peer, modulus, scene, width, moment, restitution=RESTITUTION):
    state = softRuns.FOLDER/(softRuns.name(peer, modulus, scene, moment, restitution) + ".restart")
    if not state.exists():
        return
    grains = softRuns.tableOf(peer, modulus, scene, moment, restitution)
    count = softRuns.steps(PEER_SECONDS[modulus]*max(1, MANY/len(ourRuns.readTable(grains))), modulus)
    seconds = softRuns.timeWindow(peer, modulus, scene, width, moment, count, o.core, restitution=restitution)
    figures = ourRuns.rows(ourRuns.call("figures", scene, o.bed, grains, core=o.core))[0]
    table.add(scene, peer, "%.0e" % modulus, restitution, moment*EVERY, timeStep(modulus), 1e3*seconds, seconds/timeStep(modulus), figures["overlapMax"],
              figures["overlapMean"])


def ourRow(table, scene, setting, moment, row, restitution=0.0):
    deltaT = row["msPerStep"]*1e-3/row["secondsPerSecond"]
    table.add(scene, "ours", setting, restitution, moment*EVERY, deltaT, row["msPerStep"], row["secondsPerSecond"],
              max(row["overlapMax"], row["overlapMaxReported"]), row["overlapMean"])


COLUMNS = ["scene", "program", "kind", "restitution", "time", "deltaT", "msPerStep", "secondsPerSecond", "overlapMax", "overlapMean"]
COSTS = ("msPerStep", "secondsPerSecond", "overlapMax")


def means(table, scene):
    """Over the moments at which all were timed: program, kind, restitution, seconds per second, worst overlap."""
    keys = list(dict.fromkeys(row[1:4] for row in table.rows if row[0] == scene))
    times = set.intersection(*(set(table.column("time", scene=scene, program=p, kind=k, restitution=e)) for p, k, e in keys))
    result = {}
    for key in keys:
        chosen = [row for row in table.rows if row[:4] == (scene, *key) and row[4] in times]
        result[key] = (sum(row[7] for row in chosen)/len(chosen), max(row[8] for row in chosen))
    return result, sorted(times)


def printRatios(table, scene):
    result, times = means(table, scene)
    print("%s: means at %s s" % (scene, ", ".join("%g" % time for time in times)))
    for (program, kind, restitution), (seconds, overlap) in result.items():
        line = "%-10s %-10s e %-5g %8.1f s/s, worst overlap %.1e d" % (program, kind, restitution, seconds, overlap)
        if program != "ours":
            fits = ["%.1f of '%s', e %g" % (seconds/mine, k, e) for (p, k, e), (mine, depth) in result.items()
                    if p == "ours" and (scene == "bed" or depth <= overlap and softRestitution(e) == restitution)]
            line += "; times " + (", ".join(fits) or "none of ours with as little overlap")
        print(line)


def collapse(o, peers):
    """Windows of all programs, in turn, at several moments of the same motion."""
    table = Table("peersCollapse", COLUMNS, larger=COSTS)
    table.inRounds(lambda table: collapseWindows(table, o, peers, settledBed(o.bed, o.core)[0]))
    printRatios(table, "collapse")
    draw(table, "peersCollapse")


def collapseWindows(table, o, peers, width):
    for moment in o.moments:
        for restitution in o.restitution:
            for setting, values in ourRuns.SETTINGS.items():
                state = ourRuns.fileOf(setting, moment, restitution)
                if setting != "reference" and state.exists():
                    ourRow(table, "collapse", setting, moment,
                           ourRuns.window("collapse", o.bed, state, o.core, values, steps=OUR_STEPS, restitution=restitution), restitution)
        for restitution in dict.fromkeys(map(softRestitution, o.restitution)):
            for modulus in MODULI:
                for peer in peers:
                    peerRow(o, table, peer, modulus, "collapse", width, moment, restitution)


def rest(o, peers):
    """The bed at rest: all awake, and what sleep makes of it."""
    table = Table("peersRest", COLUMNS, larger=COSTS)
    table.inRounds(lambda table: restWindows(table, o, peers, settledBed(o.bed, o.core)[0]))
    printRatios(table, "bed")
    draw(table, "peersRest")


def restWindows(table, o, peers, width):
    state = softRuns.FOLDER/"bed.state"
    for kind, more in (("awake", {"sleep": 0, "warmUp": 20}), ("asleep", {"sleep": 1, "warmUp": 1000})):
        ourRow(table, "bed", kind, 0, ourRuns.window("bed", o.bed, state, o.core, ourRuns.REST, steps=REST_STEPS, **more))
    for modulus in MODULI:
        for peer in peers:
            peerRow(o, table, peer, modulus, "bed", width, 0)


def glass(o, peers):
    """What glass would cost the soft peers: their time step for it, and their cost of a step, over a window too short for anything to move."""
    periods = settledBed(o.bed, o.core)
    start = softRuns.FOLDER/"glass.grains"
    ourRuns.call("table", ourRuns.fileOf("default", o.moments[0]), start, core=o.core)

    def windows(table):
        for peer in peers:
            seconds = softRuns.timeFromData(peer, GLASS, "collapse", ourRuns.readTable(start), periods, 300, o.core)
            table.add(peer, GLASS, timeStep(GLASS), 1e3*seconds, seconds/timeStep(GLASS))
    table = Table("peersGlass", ["program", "modulus", "deltaT", "msPerStep", "secondsPerSecond"]).inRounds(windows)
    bars(table, ["program"], "secondsPerSecond", "processor seconds per simulated second")


def accuracy(o, peers):
    """Runs of ours against the reference, as far as both go."""
    reference = ourRuns.fileOf("reference")
    if not reference.exists():
        print("no reference run: tests/benchmark/run peers prepare --reference makes it")
        return
    columns = ["centerX", "centerZ", "runOut90", "runOut99"]

    def deviations(table):
        for setting in ourRuns.SETTINGS:
            if setting != "reference" and ourRuns.fileOf(setting).exists():
                found = ourRuns.deviations(ourRuns.rows(ourRuns.fileOf(setting).read_text()), ourRuns.rows(reference.read_text()))
                if found:
                    table.add(setting, found[1], *(found[0][name] for name in columns))
    table = Table("peersAccuracy", ["setting", "until", *columns], larger=columns).inRounds(deviations, 1)
    bars(table, ["setting"], "runOut99", "deviation of the run-out of 99 %")


def frozenProblem(o, peers):
    """Cold solves to the same residual, for two tolerances of ours."""
    if not hasSiconos():
        return
    settledBed(o.frozen, o.core)
    os.sched_setaffinity(0, {o.core})
    def solves(table):
        for tolerance in o.tolerances:
            frozen.addRows(table, ourRuns.PROGRAM, o.frozen, softRuns.FOLDER/"frozen", tolerance, MOST_ITERATIONS, o.core)
    columns = ["tolerance", "bar", "ourSeconds", "ourSweeps", "ourRms", "ourMax", "seconds", "iterations", "rms", "max", "ratio"]
    table = Table("peersFrozen", columns, larger=("ourSeconds", "ourSweeps"), smaller=("ratio",)).inRounds(solves)
    bars(table, ["tolerance", "bar"], "ratio", "processor time of NSGS over ours")


def draw(table, name):
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    for key in dict.fromkeys(row[1:4] for row in table.rows):
        chosen = [row for row in table.rows if row[1:4] == key]
        axes.loglog([row[8] for row in chosen], [row[7] for row in chosen], "o", label="%s, %s, e %g" % key)
    axes.set(xlabel="worst overlap [d]", ylabel="processor seconds per simulated second")
    axes.legend(fontsize=7)
    savePicture(figure, name)


PARTS = {"prepare": prepare, "collapse": collapse, "rest": rest, "glass": glass, "accuracy": accuracy, "frozen": frozenProblem}


def main():
    o = arguments()
    unknown = [part for part in o.parts if part not in PARTS]
    if unknown:
        raise SystemExit("tests/benchmark/run peers: knows %s, not '%s'" % (", ".join(PARTS), unknown[0]))
    peers = installed()
    for part in o.parts or PARTS:
        print("== " + part)
        PARTS[part](o, peers)


if __name__ == "__main__":
    main()
