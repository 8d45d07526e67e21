# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases of MFiX (tutorials/dem of 21.3) where grains pass through: a loop seal, a cyclone, a conveyor; as mfix.py has the others."""

import math

from foamCase import SCHEMES, SOLUTION, vec
from mfix import AIR, AIR_MU, granularBox, judgeGrains, massThrough, withoutFluid, superficial, volumeOf
from mfixMeshes import BlocksCase, CycloneCase, SpoutCase
from outsideCase import BUILD, FIXED_FLUX, G, OUTLET, valuesOf
from surfaces import plates, writeStl


def loopSeal(verdict):
    """MFiX's loop_seal_pseudo_2d: spheres of 3 mm between plates 10 mm apart in a riser, a downcomer and what joins them; air at 5 m/s from below the riser, 1 g/s of it
    at a point of the downcomer, 0.1 kg/s of grains through its roof, and a leg to the outlet. 0.25 s of 5, steps of 0.5 ms.

    The point source is one of alpha.fluid in the cell there, with the velocity of the air around it (there: 0.1 m/s). Meshes of 7.5 mm as there, along the walls here.
    All of the air has to leave by the outlet; its volume with that of the grains that leave is what has come."""
    d, rhoP, half, seconds = 3e-3, 3000, 5e-3, 0.25
    case = BlocksCase(BUILD/"loopSeal", *loopSealBlocks(), half, -half, 2, "wall")
    inflow, source = 5*0.05*2*half, 1e-3/AIR
    case.fluid(AIR, AIR_MU, (0, -G, 0), sides={"inlet": superficial(5), "roof": "type noSlip;", "outlet": OUTLET},
               pressureSides={"inlet": FIXED_FLUX, "roof": FIXED_FLUX})
    # Gauss's gradients on the leg's cells, sheared by 45 degrees, leave a momentum error of 1.6 %, in cells of right angles less than a third of that.
    case.write("system/fvSchemes", SCHEMES.replace("gradSchemes          { default Gauss linear; }", "gradSchemes { default leastSquares; }"))
    case.write("constant/fvOptions", aeration(source, (0.12, 1e-6, 1e-6)))
    fill = "%s { type filling; region { type box; box (%g %g -0.005) (%g %g 0.005); } packing { solidFraction 0.4; } diameter %g; }\n"
    case.grains("materials { grain { density %g; } }\ncontacts { default { friction 0.1; restitution 0.7; } }\nforces { drag { law SyamlalOBrien; } }\n"
                "patches { inlet { type wall; } roof { type wall; } outlet { type exit; } }\ngrains\n{\n%s%s%s"
                "roof { type entering; region { type box; box (0.077 0.134 -0.0034) (0.123 0.138 0.0034); } massRate 0.1; diameter %g; velocity (0 -0.667 0); }\n}"
                % (rhoP, fill % ("riser", -0.025, -0.149, 0.025, 0.05, d), fill % ("below", 0.025, -0.135, 0.075, -0.085, d),
                   fill % ("downcomer", 0.075, -0.149, 0.125, 0.13, d), d))
    case.control(5e-4, seconds, extra="functions { %s }" % fluxThrough("outlet"))
    report = case.run().report()
    name = "loopSeal"
    judgeGrains(verdict, name, report, 2e-3)
    verdict.near(name + ": mass that came through the roof [kg]", report["enteredMass"][-1] + report["waitingMass"][-1], 0.1*seconds, 0.002)
    verdict.below(name + ": mass that found no room, over that", report["waitingMass"][-1]/(0.1*seconds), 0.02)
    flux = [value for _, value in valuesOf(case, "outlet")]
    left = report["exited"][-1]*volumeOf(d)/seconds     # grains that enter take the place of air that is gone, those that leave go with the air
    verdict.near(name + ": air that leaves, mean, and grains that do, over air that enters", (sum(flux)/len(flux) + left)/(inflow + source), 1, 0.002)
    verdict.below(name + ": momentum error from 0.1 s on", max(report["momentumError"][200:]), 0.01)
    verdict.below(name + ": no grain has left, 1", float(report["exited"][-1] == 0), 0)
    case.remove()


def fluxThrough(patch):
    """A function object named as the patch."""
    return ("%s { type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name %s; operation sum; fields (phi); writeFields no; log no; }\n"
            % (patch, patch))


def aeration(source, place):
    """fvOptions: a volume flux [m3/s] in the cell at a place."""
    return ("air { type scalarSemiImplicitSource; volumeMode absolute; selectionMode points; points (%s); injectionRateSuSp { alpha.fluid (%.17g 0); } }\n"
            % (vec(place), source))


def loopSealBlocks():
    """(blocks, edges): leg, riser, what joins it to the downcomer, and that; leg walls lie at y = x - 0.020355 and y = x + 0.050355."""
    low, high = -0.020355, 0.050355
    left, right, down, end = -0.025, 0.025, 0.075, 0.125
    riser = [-0.149, -0.135, -0.085, left + low, left + high, 0.05]
    downcomer = [-0.149, -0.135, -0.085, 0.14]

    def column(x0, x1, heights, cells, width):
        return [(((x0, a), (x1, a), (x1, b), (x0, b)), (width, n)) for a, b, n in zip(heights, heights[1:], cells)]

    leg = ((-0.1, -0.1 + low), (left, left + low), (left, left + high), (-0.1, -0.1 + high))
    blocks = [(leg, (10, 9)), *column(left, right, riser, (2, 6, 5, 9, 3), 7), *column(right, down, riser[1:3], (6,), 7), *column(down, end, downcomer, (2, 6, 27), 7)]
    return blocks, {"inlet": [((left, riser[0]), (right, riser[0]))], "outlet": [(leg[3], leg[0])], "roof": [((down, 0.14), (end, 0.14))]}


def conveyor(verdict):
    """MFiX's conveyor_3d: spheres of 100 mm fall onto a belt in a trough, 3 m/s from 4 s on, whose end throws them down a chute onto a second one, which starts and stops
    every 5 s; 32.4 kg/s come in, of which 20 s of 60 are run in steps of 2 ms, no gas.

    Belts are surfaces that move in themselves, the housing is plates. What comes is the rate times the time; what leaves, leaves at the end of
    the second belt, while it runs."""
    d, rhoP, rate, seconds = 0.1, 1000, 0.3*0.2*0.6*0.9*1000, 20
    case = granularBox("conveyor", (-6, -2.98, -2.7), (2, 0.45, 6), (50, 20, 50))
    case.types["xMin"] = "patch"
    case.writeMesh()
    writeStl(case, "housing.stl", plates(housing()))
    writeStl(case, "upper.stl", plates(trough((0.3876, 1.3582), (-0.1083, -0.2047), (-1.5, 6), along="z")))
    writeStl(case, "lower.stl", plates(trough((-2.6082, -1.9227), (-2.8619, -2.9583), (-6, 2), along="x")))
    belt = "%s { type stl; file \"%s.stl\"; surfaceVelocity table (%s); }\n"
    speeds = "(0 (0 0 0)) (2 (0 0 0)) (4 (0 0 -3)) (60 (0 0 -3))", " ".join("(%g (%g 0 0))" % (t, -u) for t, u in
              ((0, 0), (4, 0), (5, 5), (9, 5), (10, 0), (14, 0), (15, 5), (19, 5), (20, 0), (60, 0)))
    withoutFluid(case, "materials { grain { density %g; } }\ncontacts { default { friction 0.1; restitution 0.1; } }\npatches { xMin { type exit; } }\n"
              "walls { housing { type stl; file \"housing.stl\"; }\n%s%s}\n"
              "grains { pour { type entering; region { type box; box (0.65 0.3 5.05) (1.15 0.4 5.85); } massRate %.17g; diameter %g; velocity (0 -0.2 0); } }"
              % (rhoP, belt % ("upper", "upper", speeds[0]), belt % ("lower", "lower", speeds[1]), rate, d), 2e-3, seconds, 1)
    report = case.run().report()
    name = "conveyor"
    judgeGrains(verdict, name, report, 2e-3)
    verdict.below(name + ": lowest grain below the second belt [m]", -2.9583 - min(y for _, y, _ in case.cloud("position")), 0)
    verdict.near(name + ": mass that came [kg]", report["enteredMass"][-1], rate*seconds, 2*rhoP*volumeOf(d)/(rate*seconds))
    case.remove()


def trough(across, heights, ends, along, panels=8):
    """Panels of a belt whose cross-section is an arc: its edges at the first height, its middle at the second."""
    half, sag, middle = (across[1] - across[0])/2, heights[0] - heights[1], sum(across)/2
    radius = (half**2 + sag**2)/(2*sag)
    angles = [(2*k/panels - 1)*math.asin(half/radius) for k in range(panels + 1)]
    arc = [(middle + radius*math.sin(angle), heights[1] + radius*(1 - math.cos(angle))) for angle in angles]
    put = (lambda side, y, end: (side, y, end)) if along == "z" else (lambda side, y, end: (end, y, side))
    return [[put(*a, ends[0]), put(*b, ends[0]), put(*b, ends[1]), put(*a, ends[1])] for a, b in zip(arc, arc[1:])]


def housing():
    """Panels: a duct around the upper belt, a chute from its end down, which goes aside below, and a duct around the lower belt."""
    x0, x1, z0, z1 = 0.375, 1.375, -2.625, -1.916
    chute = [(0.5, -1.5), (-0.5, -1.5), (-1.5, z1), (-2, z1), (-2, z0), (-0.914, z0), (0.215, -2.256)]
    sides = [[(x, y, z) for y, z in chute] for x in (x0, x1)]
    plates = [[(x0, *a), (x1, *a), (x1, *b), (x0, *b)] for a, b in zip(chute, chute[1:] + chute[:1]) if a != (-2, z1) and a != (0.5, -1.5)]
    duct = [[(x, -0.5, -1.5), (x, 0.5, -1.5), (x, 0.5, 6), (x, -0.5, 6)] for x in (x0, x1)] + [[(x0, -0.5, -1.5), (x1, -0.5, -1.5), (x1, -0.5, 6), (x0, -0.5, 6)]]
    aside = [[(x0, -2, z), (x1, -2, z), (x1 - 0.5, -2.5, z), (x0 - 0.5, -2.5, z)] for z in (z0, z1)]
    aside += [[(x, -2, z0), (x, -2, z1), (x - 0.5, -2.5, z1), (x - 0.5, -2.5, z0)] for x in (x0, x1)]
    lower = [[(-6, -2.98, z), (2, -2.98, z), (2, -2.5, z), (-6, -2.5, z)] for z in (z0, z1)]
    lower += [[(a, -2.5, z0), (b, -2.5, z0), (b, -2.5, z1), (a, -2.5, z1)] for a, b in ((-6, x0 - 0.5), (x1 - 0.5, 2))]
    return sides + plates + duct + aside + lower


def cycloneSms(verdict):
    """MFiX's cyclone_sms_3d: spheres of 5 mm with air at 2 m/s, 1 % of it, through a duct into a cyclone of 0.3 m with a finder and a pipe below, both open; cells of 12 mm,
    Syamlal and O'Brien's drag, 1 s.

    Meshed by snappyHexMesh on that background, in steps of 1 ms. Grains of 5 mm fall at 11 m/s in such air: none may leave upwards, all that come are
    inside or have left below, and gas that enters leaves."""
    d, rhoP, U, seconds = 5e-3, 2500, 2, 1
    case = CycloneCase(BUILD/"cycloneSms")
    case.fluid(AIR, AIR_MU, (0, -9.80665, 0), sides={"inlet": "type fixedValue; value uniform (0 0 %g);" % -U, "top": OUTLET, "bottom": OUTLET},
               pressureSides={"inlet": FIXED_FLUX})
    case.write("system/fvSolution", SOLUTION % (1e-6, 1e-8))
    case.grains("materials { grain { density %g; } }\ncontacts { default { friction 0.1; restitution 0.9; } }\nforces { drag { law SyamlalOBrien; } }\n"
                "patches { inlet { type wall; } top { type exit; } bottom { type exit; } }\n"
                "grains { dust { type entering; region { type patch; patch inlet; by area; } massRate %.17g; diameter %g; velocity (0 0 %g); } }"
                % (rhoP, 0.01*U*rhoP*case.inletArea, d, -U))
    fluxes = "".join(map(fluxThrough, ("inlet", "top", "bottom")))
    case.control(1e-3, seconds, extra="functions { flux { type grainFlux; planes { finder { point (0 0.88 0); normal (0 1 0); }\n"
                 "pipe { point (0 0.02 0); normal (0 -1 0); } } }\n%s}" % fluxes)
    report = case.run().report()
    name = "cycloneSms"
    judgeGrains(verdict, name, report, 2e-3)
    mass = 0.01*U*rhoP*case.inletArea*seconds
    verdict.near(name + ": mass that came [kg]", report["enteredMass"][-1] + report["waitingMass"][-1], mass, 2*rhoP*volumeOf(d)/mass)
    verdict.below(name + ": mass through the finder over that", massThrough(case, "finder")[1][-1]/mass, 0)
    print("     cycloneSms: share that has left below %.3f" % (massThrough(case, "pipe")[1][-1]/mass))
    rates = {side: [value for _, value in valuesOf(case, side)] for side in ("inlet", "top", "bottom")}
    net = sum(map(sum, rates.values()))/len(rates["inlet"]) + report["exited"][-1]*volumeOf(d)/seconds
    verdict.below(name + ": gas and grains that leave less gas that enters, mean, over that", abs(net)/(U*case.inletArea), 0.002)
    verdict.below(name + ": momentum error from 0.1 s on", max(report["momentumError"][100:]), 0.01)
    case.remove()


def spoutedBedPseudo2d(verdict):
    """MFiX's spouted_bed_pseudo_2d: 5244 spheres of 3 mm between plates 16.7 mm apart, in a flat bed with a draft tube, air at 25 m/s through a channel of 15 mm; cells of
    5 x 7.5 x 3.3 mm, Syamlal and O'Brien's drag, 0.6 s of 5.

    The gas is an ideal one there, at a pressure that changes by 2 %; a file that asks for that is refused here, and its density is constant.
    The grains of the cone are laid above it. A spout shows: grains rise through the tube faster than others sink; gas that enters leaves."""
    d, rhoP, U, seconds, half = 3e-3, 3000, 25, 0.6, 0.025/3
    case = SpoutCase(BUILD/"spoutedBedPseudo2d")
    case.fluid(AIR, AIR_MU, (0, -G, 0), sides={"inlet": superficial(U), "top": OUTLET}, pressureSides={"inlet": FIXED_FLUX})
    fill = "%s { type filling; region { type box; box (%g -0.0985 %g) (%g 0.02 %g); } packing { solidFraction 0.485; } diameter %g; }\n"
    case.grains("materials { grain { density %g; } }\ncontacts { default { friction 0.1; restitution 0.7; } }\nforces { drag { law SyamlalOBrien; } }\n"
                "patches { inlet { type wall; } top { type exit; } }\ngrains\n{\n%s%s}"
                % (rhoP, fill % ("left", -0.05, -half, -0.0113, half, d), fill % ("right", 0.0113, -half, 0.05, half, d)))
    case.control(5e-4, seconds, extra="functions { %s }" % fluxThrough("top"))
    report = case.run().report()
    name = "spoutedBedPseudo2d"
    judgeGrains(verdict, name, report, 2e-3)
    verdict.near(name + ": grains", report["grains"][0], 5244, 0.01)
    flux = [value for _, value in valuesOf(case, "top")]
    left = report["exited"][-1]*volumeOf(d)/seconds
    verdict.near(name + ": gas that leaves, mean, and grains that do, over gas that enters", (sum(flux)/len(flux) + left)/(U*0.015*2*half), 1, 0.002)
    rising = [v for (x, y, _), (_, v, _) in zip(case.cloud("position"), case.cloud("U")) if abs(x) < 0.0075 and -0.15 < y < -0.05]
    around = [v for (x, y, _), (_, v, _) in zip(case.cloud("position"), case.cloud("U")) if abs(x) > 0.0113 and -0.15 < y < -0.05]
    print("     spoutedBedPseudo2d: %d grains in the tube at %.3g m/s, %d beside it at %.3g m/s" % (len(rising), mean(rising), len(around), mean(around)))
    verdict.below(name + ": 1 less the speed [m/s] of grains in the tube", 1 - mean(rising), 0)
    verdict.below(name + ": speed [m/s] of those beside it, upwards", mean(around), 0)
    verdict.below(name + ": momentum error from 0.1 s on", max(report["momentumError"][200:]), 0.01)
    case.remove()


def mean(values):
    return sum(values)/max(1, len(values))


CASES = (loopSeal, conveyor, cycloneSms, spoutedBedPseudo2d)
