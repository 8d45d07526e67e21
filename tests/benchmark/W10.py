# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W10: the fluidized bed of 24 750 grains (C19, tutorials/coupled/fluidizedBed, from its settled grains): height of the grains and pressure drop as
means over 4 s, against our finest run, and run time, by time step and by how many impacts a grain may have in a step of the grains.

Standard errors are those of blocks of 0.5 s. The error is that of the mean height, from the reference, once that is measured. DPMFoam would take 32
hours for its one run, and was not run."""

import math
import shutil
from pathlib import Path

import numpy

from dpmfoam import prepareOurs
from ensembles import DEFAULT, series
from foamFiles import setEntry
from keptTable import KeptTable
from pinnedRun import pinned
from results import BUILD, pyplot, savePicture     # before foamCase, whose folder it adds to the path
from foamCase import CaseFolder

TRANSIENT, LENGTH, BLOCK = 0.5, 4.0, 0.5                    # s
RUNS = {"dt %g s, impacts %g" % run: run for run in ((1e-3, 0), (5e-4, 0), (1e-3, 0.5), (1e-3, 0.25), (2.5e-4, 0.1))}   # time step [s], impacts
REFERENCE = list(RUNS)[-1]
WEIGHT = 24750*math.pi/6*0.0025**3*2526*9.81/(0.015*0.15)   # of the grains over the area [Pa]
COLUMNS = ["deltaT", "errorPercent", "seconds", "meanHeight", "heightError", "meanDrop", "dropError", "dropToWeightPercent", "dropDeviation", "grainSteps", "impactsMean"]


def relate(table):
    """Errors of all rows, once there is a reference."""
    heights, error = table.column("meanHeight", knob=REFERENCE), COLUMNS.index("errorPercent") + 2
    if heights:
        table.rounds = [[(*row[:error], 100*abs(row[table.columns.index("meanHeight")]/heights[0] - 1), *row[error + 1:]) for row in table.rounds[0]]]
        table.save()


def ours(table, knob, run):
    """Means of height and pressure drop with their standard errors, deviation of the drop."""
    deltaT, impacts = run
    folder = BUILD/"cases"/("W10." + knob.replace(" ", "").replace(",", "."))
    prepareOurs(DEFAULT, DEFAULT.parent, folder)
    setEntry(folder/"system/controlDict", "deltaT", "%.12g" % deltaT)
    setEntry(folder/"system/controlDict", "endTime", "%.12g" % (float(DEFAULT.name) + TRANSIENT + LENGTH))
    with open(folder/"constant/grainProperties", "a") as file:
        file.write("timeStep { maxGrainImpacts %g; }\n" % impacts)
    pinned("blockMesh", folder)
    seconds = pinned("nscdDEMFoam", folder).cpu
    times, heights, drops = series(folder)
    report = CaseFolder(folder).report()
    blocks = [numpy.logical_and(times > start, times <= start + BLOCK + 1e-9) for start in numpy.arange(TRANSIENT, TRANSIENT + LENGTH - 1e-9, BLOCK)]
    means = [[values[block].mean() for block in blocks] for values in (heights, drops)]
    height, drop = [(numpy.mean(each), numpy.std(each, ddof=1)/math.sqrt(len(each))) for each in means]
    table.replace("reference" if knob == REFERENCE else "nscdDEMFoam", knob, deltaT, math.nan, seconds, *height, *drop, 100*abs(drop[0]/WEIGHT - 1),
                  drops[times > TRANSIENT].std(), numpy.mean(report["subCycles"]), numpy.mean(report["impacts"]))
    relate(table)
    shutil.rmtree(folder)


def draw(table):
    figure, axes = pyplot.subplots(1, 2, figsize=(10, 4))
    for axis, column, error, label in ((axes[0], "meanHeight", "heightError", "mean height of the grains [m]"), (axes[1], "meanDrop", "dropError", "pressure drop [Pa]")):
        for knob, seconds, value, spread in zip(*(table.column(name) for name in ("knob", "seconds", column, error))):
            axis.errorbar(seconds, value, spread, fmt="o", label=knob)
        axis.set(xlabel="processor time of %g s [s]" % (TRANSIENT + LENGTH), ylabel=label)
    axes[1].axhline(WEIGHT, color="gray", label="weight over area")
    axes[1].legend(fontsize=7)
    savePicture(figure, "W10")


if __name__ == "__main__":
    if not Path(DEFAULT, "lagrangian/grains/position").exists():
        raise SystemExit("%s holds no grains: run tutorials/coupled/fluidizedBed/Allrun first" % DEFAULT)
    draw(KeptTable("W10", COLUMNS, ("errorPercent", "seconds")).ofRuns(RUNS, ours))
