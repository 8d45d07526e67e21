# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W2: 9240 spheres settle dry: overlap, base force and time to rest against run time, for time steps and tolerances."""

import math

from pinnedRun import pinned
from results import BUILD, Table, pyplot, savePicture
from settledBox import D, G, GRAINS, MASS, settledBox

END = 0.2        # s; the last grains land at about 0.1 s
REST = 1e-8      # kinetic energy per grain over m g d
# time step [s], tolerance of the solver (1e-2 is the default), with its displacementTolerance in proportion
RUNS = ((1e-3, 1e-2), (1e-3, 1e-1), (5e-4, 1e-2), (2.5e-4, 1e-2), (1e-3, 1e-3))
COLUMNS = ["deltaT", "tolerance", "seconds", "secondsPerStep", "sweepsPerStep", "cappedSteps", "overlapMax", "overlapMeanMax",
           "baseForceError", "energyAtEnd", "timeToRest"]


def settle(deltaT, tolerance):
    """Report of a run, and its processor seconds beyond the first step."""
    case = settledBox(BUILD/"cases/W2", "fluid none; solver { tolerance %g; displacementTolerance %g; }" % (tolerance, 3e-2*tolerance))
    case.call("blockMesh")
    costs = []
    for end in (deltaT, END):
        case.control(deltaT, end, 1e6)
        costs.append(pinned("nscdDEMFoam", case.folder).cpu)
    report = case.report()
    case.remove()
    return report, costs[1] - costs[0]


def figures(report):
    """Base force: the worst step of the last 0.05 s. Time to rest: after it the energy stays below REST."""
    weight = GRAINS*MASS*G
    last = [k for k, t in enumerate(report["time"]) if t > END - 0.05]
    energy = [e/(GRAINS*MASS*G*D) for e in report["kineticEnergy"]]
    moving = [t for t, e in zip(report["time"], energy) if e >= REST]
    steps = len(energy)
    return [sum(report["sweeps"])/steps, sum(report["atCap"]), max(report["overlapMax"]), max(report["overlapMean"]),
            max(abs(-report["wallForceZ"][k]/weight - 1) for k in last), energy[-1],
            math.nan if moving[-1] >= END*(1 - 1e-9) else moving[-1]]


def measure(table):
    for deltaT, tolerance in RUNS:
        report, cpu = settle(deltaT, tolerance)
        table.add(deltaT, tolerance, cpu, cpu/(len(report["time"]) - 1), *figures(report))


def main():
    table = Table("W2", COLUMNS, larger=("seconds", "overlapMax", "overlapMeanMax", "baseForceError"))
    draw(table.inRounds(measure))


def draw(table):
    figure, axes = pyplot.subplots(1, 2, figsize=(9, 4))
    for axis, column, label in ((axes[0], "overlapMax", "largest overlap [d]"), (axes[1], "baseForceError", "worst base force error in the last 0.05 s")):
        for tolerance in sorted(set(table.column("tolerance"))):
            axis.loglog(table.column("seconds", tolerance=tolerance), table.column(column, tolerance=tolerance), "o-", label="tolerance %g" % tolerance)
        axis.set_xlabel("processor time of 0.2 s [s]")
        axis.set_ylabel(label)
    axes[0].legend()
    savePicture(figure, "W2")


main()
