# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Grains alone on one rank and on many: a collapsing column (A13), the same without friction, and a bed at rest that is tilted."""

import math
import statistics
from pathlib import Path

from foamCase import BoxCase
from sameGrains import BUILD, G, ROOT, SKINS, byId, checkEveryStep, checkSameBits, checkSamePaths, homes, runCut, wallForces

FINE = "solver { tolerance 1e-9; displacementTolerance 1e-10; deadBand 0; overlapTolerance 0.1; maxSweeps 100000; }"


def last(case, name):
    return [case.report()[name + axis][-1] for axis in "XYZ"]


# A13: the column of tutorials/grains/columnCollapse at half its size, so a quarter of its discs

DT = 1e-3
CORNER = (0, 0.25)
RUBBING = "friction 0.5; restitution 0.5;"
STEPS = 40
# Standard deviations at the end of 10 serial runs (run collapseScatter): what the solver's tolerance leaves open on one rank.
SCATTER = {"massCenterX": 5.2e-6, "massCenterY": 7.6e-6, "kineticEnergy": 2.0e-5}
CUTS = {(2, 1, 1): "through the axis of the column", (3, 1, 1): "all in the middle part, none beside", (1, 3, 1): "three layers",
        (2, 2, 1): "a corner inside the column"}


def columnRows(halfWidth, height):
    with open(ROOT/"tutorials/grains/columnCollapse/constant/column.dat") as file:
        rows = [tuple(map(float, line.split())) for line in file if line[0] != "#"]
    return [row for row in rows if abs(row[0]) + row[3]/2 < halfWidth and row[1] + row[3]/2 < height]


def column(name, rows, steps, contacts, solver="", sign=1, top=0.5):
    """The column about x = 0, or its mirror image; corners of four parts lie at the middle of the mesh."""
    case = BoxCase(BUILD/name, (-1, 0, -1e-3), (1, top, 1e-3), (40, 20, 1), dict.fromkeys(("xMin", "xMax", "yMax"), "patch") | {
        "yMin": "wall", "zMin": "empty", "zMax": "empty"})
    case.gravity((0, -G, 0))
    case.table([(sign*x, y, z, d) for x, y, z, d in rows])
    case.grains("materials { stone { density 2500; } } contacts { default { %s } } patches { \"(xMin|xMax|yMax)\" { type exit; } }\n"
                "fluid none; %s grains { type table; file \"grains.dat\"; }" % (contacts, solver))
    case.control(DT, steps*DT, 0.01, "writeFormat binary;")
    return case


def collapseScatter(verdict):
    """Serial runs that differ in the order of their sweeps alone: mirror images, and pairs listed up to other distances."""
    rows, runs = columnRows(0.054, 0.34), []
    for sign in (1, -1):
        for skin in SKINS:
            case = column("collapse-serial", rows, STEPS, RUBBING, "solver { skin %g; }" % skin, sign).run()
            runs.append((sign*last(case, "massCenter")[0], last(case, "massCenter")[1], case.report()["kineticEnergy"][-1]))
    for key, values in zip(SCATTER, zip(*runs)):
        print("%s: standard deviation %.2g, mean %.6g" % (key, statistics.stdev(values), statistics.mean(values)))


def checkCorner(verdict, case, cut):
    """The corner of four parts lies within one grain after another."""
    found = set()
    for time in case.times()[1:]:
        diameters = byId(case, time, "d")
        found |= {grain for grain, x in byId(case, time, "position").items() if math.dist(x[:2], CORNER) < diameters[grain]/2}
    verdict.below(cut.label + ": grains over the corner, two of them lacking", max(0, 2 - len(found)), 0, "%d of them" % len(found))


def collapse(verdict):
    """Friction and rebounds let what a solve leaves open grow; a run on ranks is one more of the serial ones. Bar: 5 standard deviations of
    a difference."""
    case = column("collapse", columnRows(0.054, 0.34), STEPS, RUBBING).run()
    alone = case.report()
    for parts, what in CUTS.items():
        cut = runCut(case, parts)
        print("%s: %s" % (cut.label, what))
        checkEveryStep(verdict, case, cut, False)
        for key, deviation in SCATTER.items():
            there = cut.report()[key][-1]
            verdict.below("%s: %s at the end" % (cut.label, key), abs(there - alone[key][-1]), 5*math.sqrt(2)*deviation,
                          "%.6g for %.6g" % (there, alone[key][-1]))
        first, later = homes(cut, case.times()[1]), homes(cut, case.times()[-1])
        print("     %d of %d grains crossed a cut" % (sum(first[grain] != later[grain] for grain in first), len(first)))
        if parts == (2, 2, 1):
            checkCorner(verdict, case, cut)
            checkSameBits(verdict, case, cut, parts)


def smoothCollapse(verdict):
    """No friction, no rebounds, no dead band: each step then has one solution, which depends on positions without jumps."""
    case = column("smooth", columnRows(0.03, 0.08), 30, "friction 0;", FINE, top=0.1).run()
    for parts in ((2, 1, 1), (3, 1, 1), (2, 2, 1)):
        cut = runCut(case, parts)
        checkEveryStep(verdict, case, cut, False)
        checkSamePaths(verdict, case, cut, case.times()[-1], 1e-8)


# Streams that pass one another along a period: loads stay even while the ranks' grains mix

STREAM_DT, STREAM_STEPS = 4e-3, 100
STREAM = "%s { type lattice; box (0 %g 0) (0.4 %g 0.005); count (60 5 1); diameter 5e-3; jitter 0.5; velocity (%g 0 0); }"


def streams(verdict):
    """Each stream moves by half the period. Log: the grains were shared out anew for it, and not in every look (one in ten steps)."""
    case = BoxCase(BUILD/"streams", (0, 0, 0), (0.4, 0.08, 0.005), (40, 8, 1), dict(yMin="wall", yMax="wall", zMin="empty", zMax="empty"))
    case.gravity((0, 0, 0))
    case.grains("materials { stone { density 2500; } } contacts { default { friction 0.3; } } fluid none; grains { %s %s }"
                % (STREAM % ("lower", 0.002, 0.038, 0.5), STREAM % ("upper", 0.042, 0.078, -0.5)))
    case.control(STREAM_DT, STREAM_STEPS*STREAM_DT, extra="writeFormat binary;")
    case.run()
    for parts in ((2, 1, 1), (4, 1, 1)):
        cut = runCut(case, parts)
        checkEveryStep(verdict, case, cut, False)
        checkSamePaths(verdict, case, cut, case.times()[-1], 1e-9)
        shared = (Path(cut.folder)/"log.ranks").read_text().count("grains had mixed")
        verdict.below(cut.label + ": shared out anew for mixing, 1 to 4 times", abs(shared - 2.5), 1.5, "%d times" % shared)


# A bed at rest, tilted

D = 2e-3
TOLERANCE = 1e-4
TILT = math.radians(5)
SETTLED, RESTED = 0.9, 1.3


def bedProperties(friction, tolerance):
    return ("materials { stone { density 2500; } } contacts { default { friction %g; } } patches { zMax { type exit; } } fluid none;\n"
            "solver { tolerance %g; displacementTolerance %g; maxSweeps 100000; sleep off; }\n"
            "grains { type lattice; box (0 0 0) (0.02 0.02 0.016); count (8 8 6); diameter %g; spread 0.1; jitter 0.9; seed 5; }"
            % (friction, tolerance, min(3e-4, tolerance), D))


def settledBed():
    """Settled without friction, so that every grain lies in a hollow: none will roll away, and the tilt has one answer."""
    case = BoxCase(BUILD/"bed", (0, 0, 0), (0.02, 0.02, 0.02), (10, 10, 10), dict.fromkeys(("xMin", "xMax", "yMin", "yMax", "zMin"), "wall") | {
        "zMax": "patch"})
    case.gravity((0, 0, -G))
    for tolerance, end in ((1e-2, 0.2), (TOLERANCE, SETTLED)):
        case.grains(bedProperties(0, tolerance))
        case.control(DT, end, 0.1, "writeFormat binary;")
        case.run()
    return case


def tilted(case):
    case.grains(bedProperties(0.5, TOLERANCE))
    case.gravity((G*math.sin(TILT), 0, -G*math.cos(TILT)))
    case.control(DT, RESTED, 0.1, "writeFormat binary;")
    return case


def singleForces(case, other):
    """Largest difference of the force on one wall."""
    mine, theirs = wallForces(case, "%g" % RESTED, DT), wallForces(other, "%g" % RESTED, DT)
    return max(math.dist(force, theirs.get(region, (0, 0, 0))) for region, force in mine.items())


def checkTilted(verdict, case, cut, weight):
    """Bars: a solve leaves at most tolerance g dt of speed, of random sign from step to step, so tolerance g dt^2 sqrt(steps) of the mass
    center; at rest 3e-3 of the tolerance (src/nscd), so that of the weight.
    Friction leaves the share of each wall open: by up to friction times 0.16 of the weight, which a side wall carries here; a tenth of that."""
    steps = round((RESTED - SETTLED)/DT)
    verdict.below(cut.label + ": grains", abs(cut.report()["grains"][-1] - case.report()["grains"][-1]), 0)
    # A sphere that spins about the normal of its only contact does so for ever: here as in serial.
    energies = [run.report()["kineticEnergy"][-1]/(weight*D) for run in (cut, case)]
    verdict.below(cut.label + ": kinetic energy at rest / m g d", abs(energies[0] - energies[1]), 1e-10)
    verdict.below(cut.label + ": mass center [m]", math.dist(last(case, "massCenter"), last(cut, "massCenter")),
                  TOLERANCE*G*DT**2*math.sqrt(steps))
    verdict.below(cut.label + ": force on all walls / weight", math.dist(last(case, "wallForce"), last(cut, "wallForce"))/weight, 3e-3*TOLERANCE)
    verdict.below(cut.label + ": force on each wall / weight", singleForces(case, cut)/weight, 0.1*0.5*0.16)


def tilt(verdict):
    case = settledBed()
    before, start = last(case, "massCenter"), ("0", "%g" % SETTLED)
    weight = case.report()["grainVolume"][-1]*2500*G
    cuts = [runCut(tilted(case), parts, start) for parts in ((2, 1, 1), (1, 1, 3), (2, 2, 1), (2, 2, 2))]
    tilted(case).run()
    print("bed: the mass center moved by %.3g m" % math.dist(before, last(case, "massCenter")))
    for cut in cuts:
        checkTilted(verdict, case, cut, weight)
