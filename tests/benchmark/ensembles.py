# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Chaos or the time step: mean height and pressure drop of the fluidized bed at several steps, each from several starts that differ by random
velocities of 1 mm/s. What the starts of one step scatter is chaos; what their means differ by beyond that is the step's."""

import argparse
import csv
import math
import os
import random
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy

from dpmfoam import prepareOurs
from foamFiles import readNumbers, setEntry
from results import BUILD, ROOT, Table, pyplot, savePicture

CASES = BUILD/"ensembles"
DEFAULT = ROOT/"tutorials/coupled/fluidizedBed/0.4"
DISTURBANCE = 1e-3      # standard deviation of each component of the velocities put on a start [m/s]
SAMPLE = 1e-3           # to which times all runs are brought [s], the longest of the steps


def arguments():
    parser = argparse.ArgumentParser(prog="tests/benchmark/run ensembles", description=__doc__)
    parser.add_argument("state", nargs="?", type=Path, default=DEFAULT, help="time folder of a packed bed (default: %(default)s)")
    parser.add_argument("--steps", type=float, nargs="+", default=[1e-3, 5e-4, 2.5e-4, 1e-4], help="time steps [s]")
    parser.add_argument("--starts", type=int, default=5, help="disturbed starts at each step (default: 5)")
    parser.add_argument("--length", type=float, default=1.6, help="simulated seconds of each (default: 1.6)")
    parser.add_argument("--transient", type=float, default=0.3, help="seconds left out of means (default: 0.3)")
    parser.add_argument("--at", type=float, nargs="+", default=[0.1, 0.2, 0.3, 0.5, 0.6], help="instants to show besides means [s]")
    parser.add_argument("--atOnce", type=int, default=1, help="runs at a time (default: 1)")
    parser.add_argument("--wall", type=float, default=1e9, help="seconds of the clock after which runs end where they are")
    parser.add_argument("--evaluate", action="store_true", help="only read what ran before")
    return parser.parse_args()


def disturb(velocities, seed):
    """The grains' velocities with the disturbance of a start, in ASCII."""
    numbers, noise = readNumbers(velocities, 3), random.Random(seed)
    disturbed = [number + noise.gauss(0, DISTURBANCE) for number in numbers]
    rows = "\n".join("(%.17g %.17g %.17g)" % tuple(disturbed[i:i + 3]) for i in range(0, len(disturbed), 3))
    head = "FoamFile { version 2.0; format ascii; class vectorField; object U; }\n"
    velocities.write_text("%s%d\n(\n%s\n)\n" % (head, len(numbers)//3, rows))


def prepare(state, folder, step, start, length):
    prepareOurs(state, state.parent, folder)
    disturb(folder/state.name/"lagrangian/grains/U", start)
    setEntry(folder/"system/controlDict", "deltaT", "%.12g" % step)
    setEntry(folder/"system/controlDict", "endTime", "%.12g" % (float(state.name) + length))
    with open(folder/"log.blockMesh", "w") as log:
        subprocess.run(["blockMesh"], cwd=folder, stdout=log, stderr=log, check=True, env=dict(os.environ, PWD=str(folder)))


def runCase(folder, wall):
    """To its end, or as far as it gets in `wall` seconds."""
    with open(folder/"log.nscdDEMFoam", "w") as log:
        command = ["timeout", "%.0f" % wall, "nscdDEMFoam"]
        status = subprocess.run(command, cwd=folder, stdout=log, stderr=log, env=dict(os.environ, PWD=str(folder))).returncode
    if status not in (0, 124):
        raise SystemExit("nscdDEMFoam failed in %s; what it said is in its log.nscdDEMFoam" % folder)


def caseOf(step, start):
    return CASES/("%g-%d" % (step, start))


def runAll(options):
    """The longest runs first."""
    cases = [(step, start) for step in sorted(options.steps) for start in range(options.starts)]
    for step, start in cases:
        prepare(options.state, caseOf(step, start), step, start, options.length)
    with ThreadPoolExecutor(options.atOnce) as pool:
        list(pool.map(lambda case: runCase(caseOf(*case), options.wall), cases))


def series(folder):
    """Time since the start, mean height of the grains [m] and pressure drop [Pa], all at the ends of steps."""
    with open(next((folder/"postProcessing/grains").glob("*/report.csv"))) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    rows = [row for row in rows if None not in row.values() and all(row.values())]
    times, heights = ([float(row[name]) for row in rows] for name in ("time", "massCenterZ"))
    drops = numpy.loadtxt(next((folder/"postProcessing/pressureDrop").glob("*/surfaceFieldValue.dat")), comments="#").T
    count = min(len(times), len(drops[0]))
    return numpy.array(times[:count]) - times[0] + float(rows[0]["deltaT"]), numpy.array(heights[:count]), drops[1][:count]


def sampled(folder):
    """Mean height and pressure drop in intervals of SAMPLE, each the mean of its steps."""
    times, heights, drops = series(folder)
    whole = math.floor(times[-1]/SAMPLE + 1e-6)
    interval = numpy.minimum(numpy.ceil(times/SAMPLE - 1e-6).astype(int) - 1, whole)
    return [numpy.array([values[interval == i].mean() for i in range(whole)]) for values in (heights, drops)]


def meanAndError(values):
    """Over starts; the standard error of the mean."""
    return numpy.mean(values), numpy.std(values, ddof=1)/math.sqrt(len(values))


def spectrum(drops):
    """Frequencies [Hz] and mean power density [Pa2/Hz] over the starts, of the pressure drop less its mean."""
    window = numpy.hanning(drops.shape[1])
    power = numpy.abs(numpy.fft.rfft((drops - drops.mean(axis=1, keepdims=True))*window, axis=1))**2
    return numpy.fft.rfftfreq(drops.shape[1], SAMPLE), 2*SAMPLE*power.mean(axis=0)/(window**2).sum()


def windows(options, ends):
    """From and to, in samples: instants, and means with and without the transient up to where the runs of each step end."""
    instants = [(round(t/SAMPLE) - 1, round(t/SAMPLE)) for t in options.at]
    return instants + [(first, end) for first in (0, round(options.transient/SAMPLE)) for end in sorted(ends)]


def evaluate(options):
    table = Table("ensembles", ["deltaT", "starts", "from", "to", "meanHeight", "heightError", "meanDrop", "dropError", "dropDeviation"])
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4))
    runs = {step: [sampled(caseOf(step, start)) for start in range(options.starts)] for step in options.steps}
    longest = {step: min(len(run[0]) for run in group) for step, group in runs.items()}
    for step, group in runs.items():
        heights, drops = (numpy.array([run[i][:longest[step]] for run in group]) for i in (0, 1))
        for first, end in windows(options, longest.values()):
            if end <= longest[step]:
                meanHeights, meanDrops = (values[:, first:end].mean(axis=1) for values in (heights, drops))
                deviation = drops[:, first:end].std(axis=1).mean()
                table.add(step, len(group), first*SAMPLE, end*SAMPLE, *meanAndError(meanHeights), *meanAndError(meanDrops), deviation)
        draw(left, step, heights)
        frequencies, power = spectrum(drops[:, round(options.transient/SAMPLE):])
        right.loglog(frequencies[1:], power[1:], label="%g s" % step)
    left.set(xlabel="time since the air came on [s]", ylabel="mean height of the grains [m]")
    right.set(xlabel="frequency [Hz]", ylabel="power density of the pressure drop [Pa2/Hz]")
    left.legend(title="time step")
    table.save()
    savePicture(figure, "ensembles")


def draw(axes, step, heights):
    """Mean over the starts, and what its standard error spans."""
    times = SAMPLE*numpy.arange(1, heights.shape[1] + 1)
    mean, error = heights.mean(axis=0), heights.std(axis=0, ddof=1)/math.sqrt(len(heights))
    line, = axes.plot(times, mean, label="%g s" % step)
    axes.fill_between(times, mean - error, mean + error, color=line.get_color(), alpha=0.25)


def main():
    options = arguments()
    options.state = options.state.resolve()
    if not options.evaluate:
        runAll(options)
    evaluate(options)


if __name__ == "__main__":
    main()
