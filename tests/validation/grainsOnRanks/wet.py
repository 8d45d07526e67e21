# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Grains in a fluid on one rank and on many: thrown over a corner, far from those who own them, a settling depot (C33), a fluidized bed."""

import math
import os
import statistics

from foamCase import BoxCase
from ranks import command, differ, gathered
from sameGrains import BUILD, G, SKINS, byId, checkEveryStep, checkSameBits, checkSamePaths, homes, runCut

FINE = "solver { tolerance 1e-9; displacementTolerance 1e-10; deadBand 0; overlapTolerance 0.1; maxSweeps 100000; }"
ROUGH = """
solvers
{
    "p_rgh.*" { solver PCG; preconditioner DIC; tolerance 1e-7; relTol 1e-3; }
    "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-8; relTol 1e-3; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 2; pRefCell 0; pRefValue 0; }
"""
CLOSED = {"xMin": "wall", "xMax": "wall", "yMin": "wall", "yMax": "wall"}
FLAT = dict(CLOSED, zMin="empty", zMax="empty")


def properties(density, contacts, source, more=""):
    return ("materials { m { density %g; } } contacts { default { %s } }\n%s\ngrains { type lattice; %s }" % (density, contacts, more, source))


# Motion that a fine solve determines: no friction, no rebounds, no dead band

def checkFine(verdict, case, cuts):
    case.run()
    done = []
    for parts in cuts:
        cut = runCut(case, parts)
        checkEveryStep(verdict, case, cut, True)
        checkSamePaths(verdict, case, cut, case.times()[-1], 1e-8)
        done.append(cut)
    return done


def thrown(verdict):
    """Discs thrown through the corner of four parts, onto one another and the far walls."""
    case = BoxCase(BUILD/"thrown", (0, 0, 0), (0.1, 0.1, 0.005), (10, 10, 1), FLAT)
    case.fluid(100, 1e-3, (0, -G, 0))
    case.grains(properties(2500, "friction 0;", "box (0.01 0.01 0) (0.048 0.048 0.005); count (6 6 1); diameter 5e-3; jitter 0.5;"
                           "velocity (1.2 1.4 0);", FINE))
    case.control(1e-3, 0.06, 0.006, "writeFormat binary;")
    cuts = [(2, 1, 1), (1, 3, 1), (2, 2, 1)]
    corner = checkFine(verdict, case, cuts)[-1]
    crossed = throughCorner(corner)
    verdict.below(corner.label + ": grains through the corner, one lacking", max(0, 1 - len(crossed)), 0, "%d of them" % len(crossed))
    checkSameBits(verdict, case, corner, cuts[-1])


def throughCorner(cut):
    """Grains that lay over the corner and whose home went to the part across it."""
    over, times = set(), sorted((name for name in os.listdir(os.path.join(cut.folder, "processor0")) if name[0] == "0" and name != "0"), key=float)
    for time in times:
        over |= {grain for grain, x in byId(cut, time, "position").items() if math.dist(x[:2], (0.05, 0.05)) < 2.5e-3}
    first, last = homes(cut, times[0]), homes(cut, times[-1])
    return [grain for grain in over if (first[grain], last[grain]) == (0, 3)]


def pool(name, source, deltaT=2e-3):
    case = BoxCase(BUILD/name, (0, 0, 0), (0.04, 0.04, 0.08), (4, 4, 8), dict(CLOSED, zMin="wall", zMax="wall"))
    case.fluid(1000, 1e-3)
    case.grains(properties(2500, "friction 0;", source, FINE))
    case.control(deltaT, 40*deltaT, extra="writeFormat binary;")
    return case


def farFromOwners(verdict):
    """All grains in the cells of the lowest of four ranks; all own some."""
    case = pool("lowest", "box (0 0 0) (0.04 0.04 0.019); count (5 5 2); diameter 6e-3; jitter 0.8;")
    for cut in checkFine(verdict, case, ((1, 1, 4),)):
        outside = [rank for rank in homes(cut, case.times()[-1]).values() if rank != 0]
        verdict.below(cut.label + ": grains not in the lowest part", len(outside), 0)


def fewerThanRanks(verdict):
    checkFine(verdict, pool("three", "box (0 0 0) (0.04 0.04 0.02); count (3 1 1); diameter 6e-3; velocity (0.1 0.05 -0.3);"),
              ((2, 2, 1), (2, 2, 2)))


# C33: 1500 discs in a box of 0.4 x 0.6 m, which fall 0.45 m; here 240 that fall 0.14 m, with time steps ten times as long (S11) and sizes 10 % apart,
# for equal discs slide along their rows long after they landed. A drag law without jumps: with Gidaspow's, which triples at alpha 0.8, a difference of 1e-5 m
# between two runs moved three discs by a step's braking, and the heap while falling by 4e-4 m.

DEPOT_DT, DEPOT_FALLING, DEPOT_END = 1e-2, 0.8, 3
DENSITY, WATER = 2450, 1000
# Standard deviations of two sets of 8 serial runs in which pairs are listed up to other distances (run depotScatter; 3.0e-6 and 9.1e-6, 5.8e-5 and 4.3e-5,
# 4.2e-5 and 1.5e-5): what solves leave open grows, for the discs overturn while they fall. The force is a mean of the last 20 steps.
DEPOT_SCATTER = {"height falling [m]": 6.8e-6, "height at the end [m]": 5.1e-5, "floor force / submerged weight": 3.2e-5}


def depot(name, solver=""):
    case = BoxCase(BUILD/name, (0, 0, 0), (0.16, 0.2, 0.005), (8, 10, 1), FLAT)
    case.write("system/fvSolution", ROUGH)
    case.fluid(WATER, 1e-3, (0, -G, 0))
    case.grains(properties(DENSITY, "friction 0.3;", "box (0 0.137 0) (0.16 0.2 0.005); count (24 10 1); diameter 5e-3; spread 0.1; jitter 0.5;",
                           "forces { drag { law DiFelice; } } voidFraction { minFluidFraction 0.2; } " + solver))
    case.control(DEPOT_DT, DEPOT_END, extra="writeFormat binary;")
    return case


def depotFigures(case):
    report = case.report()
    weight = report["grainVolume"][-1]*(DENSITY - WATER)*G
    values = report["massCenterY"][round(DEPOT_FALLING/DEPOT_DT)], report["massCenterY"][-1], -statistics.mean(report["wallForceY"][-20:])/weight
    return dict(zip(DEPOT_SCATTER, values))


def depotScatter(verdict):
    runs = [depotFigures(depot("depot-serial", "solver { skin %g; }" % skin).run()) for skin in SKINS + (0.12, 0.15, 0.2)]
    for key in DEPOT_SCATTER:
        print("%s: standard deviation %.2g, mean %.6g" % (key, statistics.stdev(run[key] for run in runs), statistics.mean(run[key] for run in runs)))


def settling(verdict):
    case = depot("depot").run()
    alone = depotFigures(case)
    for parts in ((2, 1, 1), (1, 3, 1), (2, 2, 1)):
        cut = runCut(case, parts)
        checkEveryStep(verdict, case, cut, True)
        for key, value in depotFigures(cut).items():
            verdict.below("%s: %s" % (cut.label, key), abs(value - alone[key]), 5*math.sqrt(2)*DEPOT_SCATTER[key],
                          "%.6g for %.6g" % (value, alone[key]))
        energy = cut.report()["kineticEnergy"]
        verdict.below(cut.label + ": kinetic energy at the end / largest", energy[-1]/max(energy), 1e-3)
    return case


def sameFractions(verdict, case):
    """The fluid fraction of the same grains: those of the settled depot, held. Some cells would have less fluid than minFluidFraction, so solid moves
    between cells, and between those of several ranks."""
    end = case.times()[-1]
    positions, diameters = byId(case, end, "position"), byId(case, end, "d")
    still = depot("fractions")
    still.table([positions[grain] + (diameters[grain],) for grain in sorted(positions)])
    still.grains("materials { m { density %g; } } contacts { default { friction 0; } } motion fixed; voidFraction { minFluidFraction 0.2; }\n"
                 "grains { type table; file \"grains.dat\"; }" % DENSITY)
    still.control(DEPOT_DT, DEPOT_DT)
    still.run()
    time = still.times()[-1]
    alpha = still.fieldValues("alpha.fluid", time)
    verdict.below("fractions: |least alpha.fluid - minFluidFraction|", abs(min(alpha) - 0.2), 1e-12, "in %d cells" % sum(a < 0.2 + 1e-9 for a in alpha))
    for parts in ((2, 1, 1), (1, 3, 1), (2, 2, 1)):
        cut = runCut(still, parts)
        verdict.below(cut.label + ": alpha.fluid", differ(alpha, gathered(cut, "alpha.fluid", cut.ranks, time)), 1e-12, "least %.3g" % min(alpha))
        command(cut, "reconstructPar")
        verdict.below(cut.label + ": alpha.fluid by reconstructPar", differ(alpha, cut.fieldValues("alpha.fluid", time)), 1e-12)


def depotOnRanks(verdict):
    sameFractions(verdict, settling(verdict))


# A fluidized bed

BED_D, BED_SPEED, BED_DT, BED_START, BED_END = 2.5e-3, 3, 2e-3, 0.2, 1.2
BLOCKS = 10
DROP = ("functions { drop { type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name zMin; operation areaAverage; "
        "fields (p_rgh); writeFields false; log false; } } writeFormat binary;")


def fluidizedBed():
    """Four diameters deep: between periodic sides two diameters apart grains jam against their own images."""
    size = (10*BED_D, 4*BED_D, 32*BED_D)
    case = BoxCase(BUILD/"fluidized", (0, 0, 0), size, (5, 2, 16), {"xMin": "wall", "xMax": "wall", "zMin": "patch", "zMax": "patch"})
    case.write("system/fvSolution", ROUGH)
    inflow = "type fixedValue; value uniform (0 0 %g);" % BED_SPEED
    case.fluid(1.2, 1.8e-5, sides={"zMin": inflow, "zMax": "type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0);"},
               pressureSides={"zMin": "type fixedFluxPressure; value uniform 0;"}, U=(0, 0, BED_SPEED))
    case.grains(properties(1000, "friction 0.1; restitution 0.9;", "box (0 0 0) (%g %g %g); count (8 3 6); diameter %g; jitter 0.5;"
                           % (size[0], size[1], 8*BED_D, BED_D), "patches { zMin { type wall; } zMax { type wall; } } forces { drag { law Gidaspow; } }"))
    case.control(BED_DT, BED_END, extra=DROP)
    return case


def average(values):
    """Mean and its standard error by block averages."""
    size = len(values)//BLOCKS
    means = [statistics.mean(values[k*size:(k + 1)*size]) for k in range(BLOCKS)]
    return statistics.mean(means), statistics.stdev(means)/math.sqrt(BLOCKS)


def averages(case):
    report = case.report()
    _, drop = case.series("drop/surfaceFieldValue.dat").values()
    skip = round(BED_START/BED_DT)
    return {"mass center [m]": average(report["massCenterZ"][skip:]), "kinetic energy [J]": average(report["kineticEnergy"][skip:]),
            "pressure drop [Pa]": average(drop[skip:])}


def fluidized(verdict):
    case = fluidizedBed().run()
    alone = averages(case)
    print("fluidized, 1 rank: " + "; ".join("%s %.5g +- %.2g" % ((key,) + value) for key, value in alone.items()))
    for parts in ((2, 1, 1), (2, 1, 2)):
        cut = runCut(case, parts)
        checkEveryStep(verdict, case, cut, True)
        for key, (mean, error) in averages(cut).items():
            verdict.below("%s: %s" % (cut.label, key), abs(mean - alone[key][0]), 4*math.hypot(error, alone[key][1]),
                          "%.5g +- %.2g for %.5g +- %.2g" % ((mean, error) + alone[key]))
