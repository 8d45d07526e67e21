# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases of Lethe (examples/unresolved-cfd-dem), with its meshes, steps and constants."""

import math

from foamCase import BoxCase
from outsideCase import (BUILD, FIXED_FLUX, G, OUTLET, SLIP, CylinderCase, dallaValle, ergunGradient, fallSpeed, hinderedGradient, inlet, lawOverLayers,
                         lawOverSharedLayers, meanBetween, meanPressureAt, rong, shown, terminalSpeed, valuesOf)


def singleParticleSedimentation(verdict):
    """Lethe's single-particle-sedimentation: one bead of alginate falls in water through cells of its own diameter, Rong's drag, 5 ms steps.

    Rong's law for a sphere alone is Di Felice's. The bead acts on the fluid, and samples its own wake."""
    d, rhoP, rhoF, nu = 2.663e-3, 1029, 996.7775, 8.379e-7
    walls = {side: "type slip;" for side in ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax")}
    case = BoxCase(BUILD/"singleParticleSedimentation", (-10*d, 0, -10*d), (10*d, 40*d, 10*d), (20, 40, 20), {side: "wall" for side in walls})
    case.fluid(rhoF, rhoF*nu, (0, -G, 0), sides=walls)
    case.table([(0, 36*d, 0, d)])
    case.grains("materials { m { density %g; } } contacts { default { friction 0.3; } } wallMaterial m;\n"
                "forces { drag { law Rong; } }\ngrains { type table; file grains.dat; }" % rhoP)
    case.control(5e-3, 1.5)
    verdict.near("singleParticleSedimentation: speed [m/s]", fallSpeed(case), terminalSpeed(dallaValle, d, rhoP, rhoF, rhoF*nu), 0.03)
    case.remove()


def cylindricalPackedBed(verdict):
    """Lethe's cylindrical-packed-bed: air at 0.2 m/s through 10 000 spheres of 1 mm in a cylinder of 20 mm, on 80 x 64 cells as there: Rong's drag, model B.

    They fall onto a floor that air passes, with the friction, rolling friction and restitution of the original, and are held then, as
    there. Its script draws Ergun's law for a fluid fraction of 0.4 beside the result, which is shown; judged are Rong's and Ergun's law for
    the bed's own, layer by layer. Air prefers the loose cells at the wall, which a layer's mean does not know: the drop if it could do so freely is shown."""
    d, number, rhoP, rhoF, nu, U = 1e-3, 10000, 2500, 1, 1e-5, 0.2

    def stage(name, settings, deltaT, endTime):
        case = CylinderCase(BUILD/name, 0.01, -0.1, 0.1, 4, 4, 64)
        case.fluid(rhoF, rhoF*nu, (0, 0, -9.8), sides={"bottom": inlet(U), "top": OUTLET, "walls": SLIP},
                   pressureSides={"bottom": FIXED_FLUX})
        case.grains("materials { grain { density %g; } }\ncontacts { default { friction 0.1; restitution 0.2; rollingFriction 0.2; } }\n"
                    "patches { bottom { type wall; } top { type exit; } }\nplanes { floor { point (0 0 -0.01); normal (0 0 1); } }\n%s" % (rhoP, settings))
        case.control(deltaT, endTime, extra="" if settings.startswith("fluid none") else meanPressureAt("bottom"))
        return case

    inner = stage("cylindricalPacking", "", 1, 1).innerRadius()
    packing = stage("cylindricalPacking", "fluid none;\ngrains { type filling; region { type cylinder; axis (0 0 -0.01) (0 0 0.06); radius %.17g; } number %d; diameter %g; }"
                    % (inner, number, d), 5e-4, 0.2)
    packing.run()
    case = stage("cylindricalPackedBed", "motion fixed;\nforces { model B; drag { law Rong; } }\n"
                 'grains { type time; case "../cylindricalPacking"; time latestTime; }', 5e-3, 0.2)
    drop = valuesOf(case.run(), "inletPressure")[-1][1]
    packing.remove()
    verdict.near("cylindricalPackedBed: grains", len(case.cloud("d")), number, 0)
    verdict.near("cylindricalPackedBed: drop, Rong's law [Pa]", drop,
                 lawOverLayers(case, lambda alpha: hinderedGradient(rong, alpha, U, d, rhoF, rhoF*nu)), 0.03)
    verdict.near("cylindricalPackedBed: drop, Ergun's law [Pa]", drop,
                 lawOverLayers(case, lambda alpha: ergunGradient(alpha, U, d, rhoF, rhoF*nu)), 0.15)
    shown("cylindricalPackedBed: drop, Rong's law, air that finds the loose cells [Pa]", drop,
          lawOverSharedLayers(case, lambda alpha, u: hinderedGradient(rong, alpha, u, d, rhoF, rhoF*nu), U))
    height = number*math.pi/6*d**3/(0.6*math.pi*0.01**2)
    shown("cylindricalPackedBed: drop, Ergun's law for a fluid fraction of 0.4 [Pa]", drop, ergunGradient(0.4, U, d, rhoF, rhoF*nu)*height)
    case.remove()


def gasSolidFluidizedBed(verdict):
    """Lethe's gas-solid-fluidized-bed: spheres of 1 mm in a square column of 5 mm cells, 200 mm high, into which air comes at once, at 2 m/s, three times
    what fluidizes them; Di Felice's drag, model B, steps of 1 ms, 1 s. 7500 for 30 000, in a column of 20 mm for 40 mm, so that the bed is as deep.

    It has no figures but an animation. Air lifts the bed as a plug; a part of it gets to the top, where only air leaves, and is held there.
    Judged is the balance of forces: the mean drop carries the grains and what they push the walls up with, and gives air that leaves
    between grains at the top its momentum, some Pa."""
    d, number, rhoP, rhoF, nu, U, side = 1e-3, 7500, 1500, 1, 1e-5, 2, 0.02
    sides = ("xMin", "xMax", "yMin", "yMax")

    def stage(name, settings, endTime, extra=""):
        case = BoxCase(BUILD/name, (-side/2, -side/2, -0.1), (side/2, side/2, 0.1), (4, 4, 40), {"zMin": "patch", "zMax": "patch", **dict.fromkeys(sides, "wall")})
        case.fluid(rhoF, rhoF*nu, sides={"zMin": inlet(U), "zMax": OUTLET, **dict.fromkeys(sides, SLIP)}, pressureSides={"zMin": FIXED_FLUX})
        case.grains("materials { grain { density %g; } wall {} }\nwallMaterial wall;\n"
                    "contacts { default { friction 0.1; restitution 0.2; rollingFriction 0.2; } grain-wall { friction 0.1; restitution 0.2; rollingFriction 0.3; } }\n"
                    "patches { zMin { type wall; } zMax { type wall; } }\nplanes { floor { point (0 0 -0.06); normal (0 0 1); } }\n%s" % (rhoP, settings))
        case.control(1e-3, endTime, extra=extra)
        return case

    filling = stage("gasSolidFilling", "fluid none;\ngrains { type filling; region { type box; box (-0.01 -0.01 -0.06) (0.01 0.01 -0.03); } number %d; diameter %g; }"
                    % (number, d), 0.05)
    filling.run()
    case = stage("gasSolidFluidizedBed", 'forces { model B; drag { law DiFelice; } }\ngrains { type time; case "../gasSolidFilling"; time latestTime; }',
                 1, meanPressureAt("zMin"))
    report = case.run().report()
    filling.remove()
    verdict.near("gasSolidFluidizedBed: grains", report["grains"][-1], number, 0)
    weight = number*math.pi/6*d**3*(rhoP - rhoF)*G
    push = meanBetween(list(zip(report["time"], report["wallForceZ"])), 0.5, 1)
    drop = meanBetween(valuesOf(case, "inletPressure"), 0.5, 1)
    verdict.near("gasSolidFluidizedBed: drop from 0.5 s on, by the forces on the grains [Pa]", drop, (weight + push)/side**2, 0.03)
    shown("gasSolidFluidizedBed: drop, weight over area [Pa]", drop, weight/side**2)
    verdict.below("gasSolidFluidizedBed: overlap, in diameters", max(report["overlapMax"]), 0.01)
    case.remove()


def gasSolidFluidizedCylinderBed(verdict):
    """Lethe's gas-solid-fluidized-cylinder-bed: spheres of 0.5 mm in a cylinder, on 2.5 mm high cells, through which air flows at 0.02, 0.04 ... 0.3 m/s, 0.05 s
    each; Di Felice's drag, model A. 10 000 for 200 000, in 10 mm for 20 mm, a fifth as deep; steps of 0.5 ms for 0.2 ms.

    The original means the drop over the last 25 ms of each velocity; its plateau is the weight less buoyancy over the area. It is reached
    between Re = U 0.02 m/nu = 300 and 400 there, with 270 by Wen and Yu and 294 by Noda: where the drop comes to 0.97 of it, to a step of 40."""
    d, number, rhoP, rhoF, nu = 5e-4, 10000, 1000, 1, 1e-5

    def stage(name, settings, endTime, extra=""):
        case = CylinderCase(BUILD/name, 0.005, -0.22, -0.1, 3, 2, 48)
        case.fluid(rhoF, rhoF*nu, sides={"bottom": STEPS, "top": OUTLET, "walls": SLIP}, pressureSides={"bottom": FIXED_FLUX})
        case.grains("materials { grain { density %g; } }\ncontacts { default { friction 0.1; restitution 0.9; rollingFriction 0.1; } }\n"
                    "patches { bottom { type wall; } top { type exit; } }\nplanes { floor { point (0 0 -0.18); normal (0 0 1); } }\n%s" % (rhoP, settings))
        case.control(5e-4, endTime, extra=extra)
        return case

    filling = stage("cylinderFilling", "fluid none;\ngrains { type filling; region { type cylinder; axis (0 0 -0.18) (0 0 -0.145); radius 0.0048; } number %d; diameter %g; }"
                    % (number, d), 0.1)
    filling.run()
    case = stage("gasSolidFluidizedCylinderBed", 'forces { drag { law DiFelice; } }\ngrains { type time; case "../cylinderFilling"; time latestTime; }',
                 0.75, meanPressureAt("bottom"))
    report = case.run().report()
    filling.remove()
    rows = valuesOf(case, "inletPressure")
    drops = [meanBetween(rows, 0.05*k + 0.025, 0.05*k + 0.05) for k in range(15)]
    plateau = number*math.pi/6*d**3*(rhoP - rhoF)*G/case.area()
    print("     drops over the plateau at 0.02, 0.04 ... 0.3 m/s: " + " ".join("%.3f" % (drop/plateau) for drop in drops))
    verdict.near("gasSolidFluidizedCylinderBed: grains", report["grains"][-1], number, 0)
    verdict.near("gasSolidFluidizedCylinderBed: mean drop from 0.2 m/s on, weight over area [Pa]", sum(drops[9:])/6, plateau, 0.05)
    reached = next(k for k, drop in enumerate(drops) if drop > 0.97*plateau)
    verdict.near("gasSolidFluidizedCylinderBed: Re where it fluidizes", 0.02*(reached + 1)*0.02/nu, 335, 65, relative=False)
    case.remove()


# U at the inlet, which no grain touches: 0.02 m/s more each 0.05 s.
STEPS = ('type exprFixedValue; variables ("U = 0.02*(1 + floor((time() - 1e-6)/0.05))"); valueExpr "vector(0, 0, U)"; value uniform (0 0 0);')

CASES = (singleParticleSedimentation, cylindricalPackedBed, gasSolidFluidizedBed, gasSolidFluidizedCylinderBed)
