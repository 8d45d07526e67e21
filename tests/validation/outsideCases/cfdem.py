# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases of CFDEMcoupling, with its meshes, steps and constants."""

import math

from foamCase import BoxCase
from outsideCase import (BUILD, FIXED_FLUX, G, OUTLET, SLIP, CylinderCase, dallaValle, diFelice, ergunGradient, fallSpeed, hinderedGradient, lawOverLayers,
                         meanBetween, meanPressureAt, terminalSpeed, valuesOf)


def settlingTestMPI(verdict):
    """CFDEMcoupling's cfdemSolverPiso/settlingTestMPI: one sphere of 0.1 mm falls for 0.15 s through 320 cells, model B, Di Felice's drag: 0.1286 m/s."""
    d, rhoP, rhoF, nu = 1e-4, 3000, 10, 1e-5
    for model in ("A", "B"):
        case = BoxCase(BUILD/("settlingTestMPI" + model), (0.045, 0, 0.045), (0.055, 0.05, 0.055), (4, 20, 4),
                       {"xMin": "wall", "xMax": "wall", "yMin": "patch", "yMax": "patch", "zMin": "wall", "zMax": "wall"})
        case.fluid(rhoF, rhoF*nu, (0, -G, 0))
        case.table([(0.05, 0.025, 0.05, d)])
        case.grains("materials { m { density %g; } } contacts { default { friction 0.5; restitution 0.3; } } wallMaterial m;\n"
                    "forces { model %s; drag { law DiFelice; } }\ngrains { type table; file grains.dat; }\n"
                    "patches { yMin { type exit; } yMax { type exit; } }" % (rhoP, model))
        case.control(1e-3, 0.15)
        speed = fallSpeed(case)
        verdict.near("settlingTestMPI, model %s: speed [m/s]" % model, speed, terminalSpeed(dallaValle, d, rhoP, rhoF, rhoF*nu), 0.005)
        case.remove()


def ergunTestMPI_cgs(verdict):
    """CFDEMcoupling's cfdemSolverPiso/ErgunTestMPI_cgs: 10 000 spheres of 0.1 cm in a cylinder of radius 1.385 cm on 4608 cells, in cm, g and s.

    They fall at 100 cm/s, for 0.1 s without a fluid; then gas flows, for 10 ms each at 0.2, 0.4 ... 2 cm/s, with Di Felice's drag. The
    original draws Ergun's law beside its drop, and the drop at which that law lifts the bed, which is the weight. From 1.6 cm/s on the
    drop by Di Felice's law, 0.85 of Ergun's, is above the weight too. Last, ten steps give the same in units that are powers of two of
    these, so that no number in the solver has a unit (otherUnits beside this folder). In m and kg numbers round otherwise, which contacts
    at rest with friction answer by 1 % of the drop of single steps."""
    filling = ergunCase("ergunFilling", "fluid none;\ngrains { type filling; region { type cylinder; axis (0 0 0) (0 0 5.5); radius 1.2; } number 10000; "
                        "diameter 0.1; velocity (0 0 -100); }")
    filling.control(1e-3, 0.1)
    filling.run()
    bed = ergunCase("ergunTestMPI_cgs", 'grains { type time; case "../ergunFilling"; time latestTime; }')
    bed.control(1e-3, 0.1, 0.01, extra=meanPressureAt("bottom"))
    drop = valuesOf(bed.run(), "inletPressure")
    filling.remove()
    d, rho, mu = 0.1, 0.01, 0.01*1.5
    for time in 0.02, 0.05:
        U, found = 20*time, meanBetween(drop, time - 0.005, time)
        verdict.near("ergunTestMPI_cgs: drop at %g cm/s, Di Felice's law [Ba]" % U, found,
                     lawOverLayers(bed, lambda alpha: hinderedGradient(diFelice, alpha, U, d, rho, mu), "%g" % time), 0.03)
        verdict.near("ergunTestMPI_cgs: drop at %g cm/s, Ergun's law [Ba]" % U, found,
                     lawOverLayers(bed, lambda alpha: ergunGradient(alpha, U, d, rho, mu), "%g" % time), 0.25)
    weight = 10000*math.pi/6*d**3*(2 - rho)*981/bed.area()
    verdict.near("ergunTestMPI_cgs: drop once lifted, weight over area [Ba]", meanBetween(drop, 0.095, 0.1), weight, 0.02)
    positions = bed.cloud("position", "0.05")
    bed.remove()
    cgs, others = (pressuresIn(cm, gram, positions) for cm, gram in ((1, 1), (2**-6, 2**-10)))
    verdict.below("ergunTestMPI_cgs: drop in other units over that in cgs", max(abs(other*2**4/drop - 1) for other, drop in zip(others, cgs)), 1e-12)


def pressuresIn(cm, gram, positions):
    """Of the first ten steps at 0.2 cm/s of a bed whose grains lie in these places [cm], in a system of units with that centimeter and gram."""
    case = ergunCase("ergunInUnits", "grains { type table; file grains.dat; }", cm, gram)
    case.table([(x*cm, y*cm, z*cm, 0.1*cm) for x, y, z in positions])
    case.control(1e-3, 0.01, extra=meanPressureAt("bottom"))
    drop = [value for _, value in valuesOf(case.run(), "inletPressure")]
    case.remove()
    return drop


def ergunCase(name, grains, cm=1.0, gram=1.0):
    density = gram/cm**3
    case = CylinderCase(BUILD/name, 1.385*cm, 0, 5.53*cm, 8, 4, 24)
    case.fluid(0.01*density, 0.01*1.5*gram/cm, (0, 0, -981*cm), sides={"bottom": RAMP % (0.2*cm), "top": OUTLET, "walls": SLIP},
               pressureSides={"bottom": FIXED_FLUX})
    case.grains("materials { grain { density %.17g; } }\ncontacts { default { friction 0.5; restitution 0.3; } }\n"
                "forces { drag { law DiFelice; } }\npatches { bottom { type wall; } top { type exit; } }\n%s" % (2*density, grains))
    return case


def periodicChannel(verdict):
    """CFDEMcoupling's cfdemSolverPiso/periodicChannel: gas at 10 m/s through a channel that is periodic along x, 0.4 x 0.1 x 0.1 m in 2048 cells, with 1000
    spheres of 1 mm that fall to its ceiling (g is upwards there), Koch and Hill's drag, 10 steps of 1 ms.

    It starts at rest, and a uniform gradient holds the mean superficial velocity; there it is a source. Its script draws the volume
    fluxes through inlet and outlet beside what is asked for, and that through the walls, which is none."""
    d, rhoP, rhoF, nu, U = 1e-3, 2000, 1.3, 1.5e-4, 10

    def stage(name, settings, endTime, extra=""):
        case = BoxCase(BUILD/name, (0, 0, 0), (0.4, 0.1, 0.1), (32, 8, 8), {side: "wall" for side in ("yMin", "yMax", "zMin", "zMax")})
        case.fluid(rhoF, rhoF*nu, (0, 0, G))
        case.grains("materials { grain { density %g; } }\ncontacts { default { friction 0.5; restitution 0.3; } }\n%s" % (rhoP, settings))
        case.control(1e-3, endTime, extra=extra)
        return case

    filling = stage("channelFilling", "fluid none;\ngrains { type filling; region { type box; box (0 0 0) (0.4 0.1 0.1); } number 1000; diameter %g; velocity (0 0 1); }" % d,
                    0.1)
    filling.run()
    fluxes = "".join("%s { type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name %s; operation sum; fields (phi); writeFields no; log no; }\n"
                     % (side, side) for side in ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax"))
    case = stage("periodicChannel", 'meanFlow (%g 0 0);\nforces { drag { law KochHill; } }\ngrains { type time; case "../channelFilling"; time latestTime; }' % U,
                 0.01, "functions { %s }" % fluxes)
    report = case.run().report()
    filling.remove()
    rates = {side: [value for _, value in valuesOf(case, side)] for side in ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax")}
    verdict.near("periodicChannel: grains", report["grains"][-1], 1000, 0)
    verdict.below("periodicChannel: flux out of the outlet over 0.1 m3/s, less 1, in any step", max(abs(rate/0.1 - 1) for rate in rates["xMax"]), 1e-3)
    verdict.below("periodicChannel: fluxes of inlet and outlet together over 0.1 m3/s", max(abs(a + b)/0.1 for a, b in zip(rates["xMin"], rates["xMax"])), 1e-12)
    verdict.below("periodicChannel: flux through walls over 0.1 m3/s", max(abs(rate)/0.1 for side in ("yMin", "yMax", "zMin", "zMax") for rate in rates[side]), 1e-15)
    verdict.below("periodicChannel: momentum error", max(report["momentumError"]), 1e-2)
    case.remove()


def voidfractionTest(verdict):
    """CFDEMcoupling's cfdemSolverPiso/voidfractionTest: 1000 spheres of 3 mm move with 0.3 m/s through cells of 10 mm, without gravity or drag, for 0.2 s.

    Its script draws the solid volume in the cells over that of the spheres, and how fast the void fraction changes. Spheres that move as
    one go 3 cells in 0.1 s: what the void fraction was has to come back 3 cells further. Weights are trilinear there; here the exact
    volume in each cell, the same smoothed over a cell's width, or all of it in the cell of the center."""
    d, number, speed = 3e-3, 1000, 0.3
    for method in ("exact", "exact; diffusion 3.3", "centroid"):
        case = BoxCase(BUILD/"voidfractionTest", (0, 0, 0), (0.1, 0.1, 1), (10, 10, 100), {"xMin": "wall", "xMax": "wall", "yMin": "wall", "yMax": "patch",
                                                                                     "zMin": "wall", "zMax": "wall"})
        case.fluid(1, 1e-5, (0, 0, 0))
        case.grains("materials { grain { density 3000; } }\ncontacts { default { friction 0.5; restitution 0.3; } }\n"
                    "forces { drag { law none; } pressureGradient off; viscous off; }\nvoidFraction { method %s; }\n"
                    "grains { type filling; region { type box; box (0 0 0.53) (0.1 0.1 1); } number %d; diameter %g; velocity (0 0 %g); }\n"
                    "patches { yMax { type exit; } }" % (method, number, d, -speed))
        case.control(1e-3, 0.2, 0.1)
        report = case.run().report()
        name = "voidfractionTest, %s: " % method
        volume = number*math.pi/6*d**3
        verdict.below(name + "solid volume in cells over that of grains, less 1, in any step", max(abs(solid/volume - 1) for solid in report["solidVolume"]), 1e-9)
        before, after = case.fieldValues("alpha.fluid", "0.1"), case.fieldValues("alpha.fluid", "0.2")
        moved = after[:97*100]
        verdict.below(name + "alpha after another 3 cells less that before", max(abs(b - a) for a, b in zip(before[3*100:], moved)), 1e-6)
        verdict.near(name + "largest solid fraction", 1 - min(after), 1 - min(before), 1e-3)
        case.remove()


# Superficial velocity in steps of 10 ms, over the fluid fraction at the inlet, where grains lie.
RAMP = ('type exprFixedValue; variables ("superficial = %.17g*(1 + floor((time() - 0.0005)/0.01))"); '
        'valueExpr "vector(0, 0, superficial)/alpha.fluid"; value uniform (0 0 0);')

CASES = (settlingTestMPI, ergunTestMPI_cgs, periodicChannel, voidfractionTest)
