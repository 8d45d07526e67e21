# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W8: a bed of 2160 grains (C17, tutorials/coupled/rampFluidization) under an inflow of air that grows from 0.5 to 0.95 m/s in 0.45 s, from one packed
state: error of the pressure drop, rms over the ramp and over the weight of the bed, and of the inflow that lifts it, against the code's own drag law
on the solid fraction that the bed has at the start, up to the weight; rmse against sediFoam's pressure drops at three inflows (its law is
SyamlalOBrien, its ramp 25 times slower); and run time, of nscdDEMFoam by time step and drag law and OpenFOAM's DPMFoam by time step and Young's
modulus [Pa] (0: rigid).

One round; pressures are means over 10 ms."""

import math
import sys
from pathlib import Path

import numpy

from dpmfoamCase import SOLUTION, copyParts, setFields, setGrains
from pinnedRun import pinned
from results import BUILD, Table, pyplot, savePicture
from foamCase import BoxCase

CASES = BUILD/"cases/W8"
BED = BUILD/"W8/bed"
G, D, DENSITY, RHO, MU = 9.8, 1.5e-3, 2000.0, 1.2, 1.8e-5
BOX, CELLS = (0.04, 0.0075, 0.2), (16, 1, 80)
AREA = BOX[0]*BOX[1]
SLOWEST, RATE, END = 0.5, 1.0, 0.45     # inflow at the start [m/s], its growth [m/s2], time [s]
FIRST = 0.6                            # inflow from which errors count [m/s]: grains that are soft sink in until then
# Xiao and Sun 2011, as sediFoam keeps it for its own test, on the way up: inflow [m/s], pressure drop [Pa].
SEDIFOAM = ((0.616, 139.7), (0.741, 190.3), (0.824, 230.3))
OURS = [("ErgunWenYu", dt) for dt in (1e-3, 3e-4, 1e-4)] + [("SyamlalOBrien", 1e-3)]
THEIRS = [(1e5, 1e-3), (1e6, 1e-3)]


def packedBed():
    """Centers of the grains [m], settled once and for all."""
    if not BED.with_suffix(".txt").exists():
        case = oursOn(BED, "grains { type filling; region { type box; box (0 0 0) (0.04 0.0075 0.05); } number 2160; diameter 1.5e-3; }", "SyamlalOBrien", "0", 1e-3, 0.5)
        pinned("nscdDEMFoam", case.folder)
        numpy.savetxt(BED.with_suffix(".txt"), case.cloud("position"), fmt="%.17g")
    return numpy.loadtxt(BED.with_suffix(".txt"))


def box(folder, ends):
    """Sides that DPMFoam's grains are stopped at by their radius are walls to it."""
    case = BoxCase(folder, (0, 0, 0), BOX, CELLS, dict(xMin="wall", xMax="wall", yMin="wall", yMax="wall", zMin=ends, zMax=ends))
    case.gravity((0, 0, -G))
    return case


def control(case, measured, deltaT, end):
    case.control(deltaT, end, None, "writeFormat binary; functions { pressureDrop { writeFields no; log no; %s } }" % measured)
    case.call("blockMesh")


def velocitySides(fraction, superficial, flux):
    slip = "type slip;"
    inlet = 'type exprFixedValue; variables ("superficial = %s"); valueExpr "vector(0, 0, superficial)/%s"; value uniform (0 0 0);' % (superficial, fraction)
    return {"yMin": slip, "yMax": slip, "zMin": inlet, "zMax": "type pressureInletOutletVelocity; %s value uniform (0 0 0);" % flux}


def oursOn(folder, grains, law, superficial, deltaT, end):
    case = box(folder, "patch")
    case.fluid(RHO, MU, (0, 0, -G), sides=velocitySides("alpha.fluid", superficial, ""),
               pressureSides={"zMin": "type fixedFluxPressure; value uniform 0;"})
    case.write("system/fvSolution", SOLUTION)
    case.grains("materials { grain { density %g; } smooth {} }\ncontacts { grain-grain { friction 0.15; restitution 0.785; } grain-smooth { friction 0; "
                "restitution 0.785; } }\nwallMaterial smooth; patches { zMin { type wall; } zMax { type exit; } }\nforces { drag { law %s; } }\n%s" % (DENSITY, law, grains))
    control(case, "type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name zMin; operation areaAverage; fields (p_rgh);", deltaT, end)
    return case


RAMP = "%g + %g*time()" % (SLOWEST, RATE)


def ours(law, deltaT, end):
    case = oursOn(CASES/"ours", "grains { type table; file grains.dat; }", law, RAMP, deltaT, end)
    case.table([(*center, D) for center in packedBed()])
    return pinned("nscdDEMFoam", case.folder).cpu, pressureDrop(case)


def theirs(young, deltaT, end):
    case = box(CASES/"theirs", "wall")
    copyParts(case, RHO, MU)
    setGrains(case, D, DENSITY, packedBed(), ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"))
    cloud = CASES/"theirs/constant/kinematicCloudProperties"
    text = cloud.read_text()
    for before, after in (("youngsModulus  1e8;", "youngsModulus  %g;" % young), ("youngsModulus            1e8;", "youngsModulus            %g;" % young),
                          ("mu                       0.10;", "mu                       0.15;"), ("mu                       0.09;", "mu                       0;")):
        if before not in text:
            sys.exit("%s lacks '%s', which this is to change" % (cloud, before))
        text = text.replace(before, after)
    cloud.write_text(text)
    setFields(case, "(0 0 0)", velocitySides("alpha.air", RAMP, "phi phi.air;"), {"zMax": "type fixedValue; value uniform 0;"})
    places = ["(%g %g %g)" % ((column + 0.5)*BOX[0]/CELLS[0], BOX[1]/2, (layer + 0.5)*BOX[2]/CELLS[2]) for layer in (0, 1) for column in range(CELLS[0])]
    control(case, "type probes; libs (sampling); fields (p); probeLocations (%s);" % " ".join(places), deltaT, end)
    return pinned("DPMFoam", case.folder).cpu, theirPressureDrop(case)


def pressureDrop(case):
    """Of ours at the inlet: (inflow [m/s], pressure drop [Pa])."""
    return inMeans(numpy.loadtxt(Path(case.folder)/"postProcessing/pressureDrop/0/surfaceFieldValue.dat", ndmin=2))


def theirPressureDrop(case):
    """Drawn out from the lowest two layers of cells, since DPMFoam's pressure at the inlet lacks the drag of half a cell; less what the fluid weighs."""
    table = numpy.loadtxt(Path(case.folder)/"postProcessing/pressureDrop/0/p", ndmin=2)
    lowest, next_ = table[:, 1:1 + CELLS[0]].mean(axis=1), table[:, 1 + CELLS[0]:].mean(axis=1)
    return inMeans(numpy.stack((table[:, 0], RHO*(1.5*lowest - 0.5*next_) - RHO*G*BOX[2]), axis=1))


def inMeans(rows):
    """Over 10 ms."""
    t, p = rows.T
    window = max(1, round(0.01/(t[1] - t[0]))) if len(t) > 1 else 1
    t, p = (x[:len(x)//window*window].reshape(-1, window).mean(axis=1) for x in (t, p))
    return SLOWEST + RATE*t, p


WEIGHT = 2160*math.pi/6*D**3*(DENSITY - RHO)*G/AREA


def ergunWenYu(alpha, U):
    """Pressure gradient [Pa/m] at a superficial velocity."""
    phi, Re = 1 - alpha, RHO*U*D/MU
    if alpha < 0.8:
        return 150*phi**2*MU*U/(alpha**3*D**2) + 1.75*phi*RHO*U**2/(alpha**3*D)
    return 18*phi*MU*U/D**2*(1 + 0.15*Re**0.687)*alpha**-3.65/alpha if phi > 0 else 0.0


def syamlalOBrien(alpha, U):
    """The same of Syamlal and O'Brien 1987, as ours has it."""
    phi, Re = 1 - alpha, RHO*U/alpha*D/MU
    if phi <= 0:
        return 0.0
    A, B = alpha**4.14, 0.8*alpha**1.28 if alpha <= 0.85 else alpha**2.65
    vr = 0.5*(A - 0.06*Re + math.sqrt((0.06*Re)**2 + 0.12*Re*(2*B - A) + A*A))
    cd = (0.63 + 4.8/math.sqrt(Re/vr))**2
    beta = 0.75*cd*phi*alpha*RHO*(U/alpha)/(vr*vr*D)
    return beta*(U/alpha)/alpha


LAWS = {"ErgunWenYu": ergunWenYu, "SyamlalOBrien": syamlalOBrien}


def solidFractions(layers=24, top=0.06, slices=50):
    """Of the packed bed, in layers as high as the cells, and their height [m]: a law is one of means over more than a diameter."""
    step = top/layers/slices
    z = (numpy.arange(layers*slices) + 0.5)*step
    parts = numpy.clip(D*D/4 - (z[:, None] - packedBed()[:, 2])**2, 0, None).sum(axis=1)
    return math.pi*parts.reshape(layers, slices).mean(axis=1)/AREA, top/layers


def lawsDrop(law, bed, U):
    """Of the bed at rest, and its weight at most [Pa]."""
    phi, step = bed
    return min(WEIGHT, sum(LAWS[law](1 - part, U)*step for part in phi))


def lift(inflow, p):
    """Inflow at which the line of the resting bed, until it carries 0.8 of its weight, gets to the weight: quadratic in the inflow."""
    rest = (inflow > FIRST) & (numpy.arange(len(p)) < numpy.argmax(p > 0.8*WEIGHT))
    a, b = numpy.linalg.lstsq(numpy.stack((inflow[rest], inflow[rest]**2), axis=1), p[rest], rcond=None)[0]
    return (-a + math.sqrt(a*a + 4*b*WEIGHT))/(2*b)


def figures(curve, law, bed):
    """Errors of the pressure drop [% of the weight] and of the inflow that lifts the bed [%], and the rms distance from sediFoam's [Pa]."""
    inflow, p = curve
    counts = inflow > FIRST
    exact = numpy.array([lawsDrop(law, bed, U) for U in inflow])
    own = math.sqrt(((p - exact)[counts]**2).mean())
    published = [numpy.interp(U, inflow, p) - drop for U, drop in SEDIFOAM]
    return 100*own/WEIGHT, 100*(lift(inflow, p)/lift(inflow, exact) - 1), math.sqrt(sum(e*e for e in published)/len(published))


def measure(table):
    bed = solidFractions()
    for number in range(max(len(OURS), len(THEIRS))):
        if number < len(OURS):
            law, deltaT = OURS[number]
            add(table, "nscdDEMFoam", law, 0.0, deltaT, bed, lambda end: ours(law, deltaT, end))
        if number < len(THEIRS):
            young, deltaT = THEIRS[number]
            add(table, "DPMFoam", "ErgunWenYu", young, deltaT, bed, lambda end: theirs(young, deltaT, end))


def add(table, code, law, young, deltaT, bed, simulate):
    """A run, and one of a step, whose cost is that of starting up."""
    startUp = simulate(deltaT)[0]
    cost, curve = simulate(END)
    CURVES[code, law, young, deltaT] = curve
    table.add(code, law, young, deltaT, *figures(curve, law, bed), cost - startUp)
    table.save()


CURVES = {}


def draw(table):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.5))
    inflow = numpy.linspace(SLOWEST, SLOWEST + RATE*END, 60)
    for law, color in (("ErgunWenYu", "k"), ("SyamlalOBrien", "gray")):
        left.plot(inflow, [lawsDrop(law, solidFractions(), U) for U in inflow], color=color, linewidth=3, alpha=0.4, label="%s on the bed" % law)
    for (code, law, young, deltaT), curve in CURVES.items():
        left.plot(*curve, "-" if code == "nscdDEMFoam" else "--", linewidth=0.8, label="%s, %s, %sdt %g s" % (code, law, "E %g Pa, " % young if young else "", deltaT))
    left.plot(*zip(*SEDIFOAM), "ko", markerfacecolor="none", label="sediFoam, SyamlalOBrien")
    for code, law, young, mark in (("nscdDEMFoam", "ErgunWenYu", 0.0, "o-"), ("nscdDEMFoam", "SyamlalOBrien", 0.0, "o--"), ("DPMFoam", "ErgunWenYu", 1e5, "x-"),
                                   ("DPMFoam", "ErgunWenYu", 1e6, "+")):
        where = dict(code=code, law=law, young=young)
        right.loglog(table.column("seconds", **where), table.column("errorPercent", **where), mark, label="%s, %s%s" % (code, law, ", E %g Pa" % young if young else ""))
    left.set_xlabel("superficial velocity [m/s]")
    left.set_ylabel("pressure drop [Pa]")
    right.set_xlabel("processor time less start-up [s]")
    right.set_ylabel("error of the pressure drop, rms [% of the weight]")
    left.legend(fontsize=6)
    right.legend(fontsize=6)
    savePicture(figure, "W8")


COLUMNS = ["code", "law", "young", "dt", "errorPercent", "liftErrorPercent", "rmsToSediFoamPa", "seconds"]
if __name__ == "__main__":
    draw(Table("W8", COLUMNS, larger=("errorPercent", "seconds")).inRounds(measure, 1))
