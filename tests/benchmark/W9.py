# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W9: the bed that Mueller and others (2008, 2009) measured (C18): fluid fraction and grain velocity over 2 to 10 s against what was measured, and run
time, by time step and by how many impacts a grain may have in a step of the grains (0: any number, one step in each of the fluid's).

The error is the rms of the fluid fraction at both heights over the mean of what was measured. sediFoam's errors are those that its authors published."""

import math
import sys

from keptTable import KeptTable
from pinnedRun import pinned
from results import BUILD, ROOT, pyplot, savePicture
sys.path.insert(0, str(ROOT/"tests/validation/muellerBed"))
from muellerBed import FLUID_FRACTION, WEIGHT, Profiles, bed, inletPressure

END = 10.0
RUNS = {"dt %s s, impacts %s" % run: run for run in (("2e-3", "0"), ("1e-3", "0"), ("5e-4", "0"), ("2e-3", "0.1"), ("1e-3", "0.1"))}   # time step [s], impacts
LAW, RESTITUTION = "SyamlalOBrien", "0.98"
SEDIFOAM = (0.027, 0.057, 0.036)
COLUMNS = ["deltaT", "errorPercent", "seconds", "lowerRms", "upperRms", "velocityRms", "dropErrorPercent", "grainSteps", "impactsMean"]


def percent(rms):
    """Of the rms at both heights."""
    measured = [value for rows in FLUID_FRACTION.values() for _, value in rows]
    squares = sum(error*error*len(rows) for error, rows in zip(rms, FLUID_FRACTION.values()))
    return 100*math.sqrt(squares/len(measured))*len(measured)/sum(measured)


def mean(values):
    return sum(values)/len(values)


def ours(table, knob, run):
    deltaT, impacts = run
    case = bed(BUILD/"cases/W9", LAW, RESTITUTION, impacts, deltaT, END)
    case.call("blockMesh")
    seconds = pinned("nscdDEMFoam", case.folder).cpu
    profiles, report = Profiles(case), case.report()
    alpha, (velocity,) = list(profiles.fluidFractionRms.values()), profiles.grainVelocityRms.values()
    table.replace("nscdDEMFoam", knob, float(deltaT), percent(alpha), seconds, *alpha, velocity,
                  100*abs(inletPressure(case)/WEIGHT - 1), mean(report["subCycles"]), mean(report["impacts"]))
    case.remove()


def draw(table):
    figure, axes = pyplot.subplots(1, 2, figsize=(10, 4))
    for axis, column, label in ((axes[0], "errorPercent", "fluid fraction, rms from measured [%]"), (axes[1], "velocityRms", "grain velocity, rms from measured [m/s]")):
        for knob, seconds, error in zip(*(table.column(name, code="nscdDEMFoam") for name in ("knob", "seconds", column))):
            axis.plot(seconds, error, "o", label=knob)
        axis.axhline(table.column(column, code="sediFoam (stored)")[0], color="gray", label="sediFoam (no time)")
        axis.set(xlabel="processor time of %g s [s]" % END, ylabel=label, ylim=(0, None))
    axes[0].legend(fontsize=7)
    savePicture(figure, "W9")


if __name__ == "__main__":
    table = KeptTable("W9", COLUMNS, ("errorPercent", "seconds", "velocityRms")).ofRuns(RUNS, ours)
    table.replace("sediFoam (stored)", "-", math.nan, percent(SEDIFOAM[:2]), math.nan, *SEDIFOAM, *3*[math.nan])
    draw(table)
