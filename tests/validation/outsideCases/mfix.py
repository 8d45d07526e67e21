# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases of MFiX (tutorials/dem of 21.3), with its meshes, steps and constants. Springs and dashpots there, rigid grains with the same restitution and
friction here; gas of constant density for the ideal gas there."""

import math

from foamCase import BoxCase
from outsideCase import BUILD, FIXED_FLUX, G, OUTLET, meanBetween, shown, valuesOf
from mfixMeshes import JetBedCase
from surfaces import box, revolved, turned, writeStl

AIR, AIR_MU = 1.205, 1.8e-5


def volumeOf(d):
    return math.pi/6*d**3


def judgeGrains(verdict, name, report, overlap):
    """What holds in every case: grains that came, from the start on, are inside or out; contacts are solved, and grains do not overlap."""
    came = [entered + report["grains"][0] + report["exited"][0] - report["entered"][0] for entered in report["entered"]]
    verdict.below(name + ": grains that came less inside and out, at most of all steps",
                  max(abs(a - b - c) for a, b, c in zip(came, report["grains"], report["exited"])), 0)
    verdict.below(name + ": share of steps that end at the cap of sweeps", sum(report["atCap"])/len(report["atCap"]), 0.01)
    verdict.below(name + ": overlap, in diameters, mean of all steps", sum(report["overlapMax"])/len(report["overlapMax"]), overlap)


def fluidBed2d(verdict):
    """MFiX's fluid_bed_2d, which is Tsuji et al. 1993: 2400 spheres of 4 mm on 15 x 45 cells one grain thick, a jet of 42 m/s through one cell, Gidaspow's drag, 1 s
    in steps of 0.5 ms.

    The grains start on a lattice there; here they are laid likewise. The floor carries what the gas does not: over 0.2 s to 1 s the pressure
    on it, the grains' force on it and the momentum of the jet are weight and momentum that the bed has won."""
    d, rhoP, number, U, width, height = 4e-3, 2700, 2400, 42, 0.15, 0.9
    case = JetBedCase(BUILD/"fluidBed2d", width, height, d, (15, 45))
    case.fluid(AIR, AIR_MU, (0, -G, 0), U=(0, 2.8, 0), sides={"jet": superficial(U), "top": OUTLET}, pressureSides={"jet": FIXED_FLUX})
    case.grains("materials { grain { density %g; } side {} }\ncontacts { default { friction 0.1; restitution 0.9; } grain-side { friction 0.1; restitution 1; } }\n"
                "wallMaterial side;\nshape sphere;\nforces { drag { law Gidaspow; } }\npatches { jet { type wall; } top { type exit; } }\n"
                "grains { type lattice; box (0.0065 0.001 0) (0.1455 0.353 %g); count (30 80 1); diameter %g; }" % (rhoP, d, d))
    case.control(5e-4, 1, 0.5, extra=meanPressures("floor", "jet"))
    report = case.run().report()
    name = "fluidBed2d"
    verdict.near(name + ": grains", report["grains"][-1], number, 0)
    judgeGrains(verdict, name, report, 1e-3)
    verdict.near(name + ": upward forces and momentum over weight and momentum won, from 0.2 s on", *bedBalance(case, report, 0.2, rhoP, U, width*d), 0.05)
    case.remove()


def superficial(U):
    """An inlet where the flux counts, whatever grains lie there: along y."""
    return 'type exprFixedValue; valueExpr "vector(0, %.17g, 0)/alpha.fluid"; value uniform (0 %.17g 0);' % (U, U)


def bedBalance(case, report, start, rhoP, U, area):
    """[N] upwards, and its reference, means from a time to the end: pressure on floor and jet, walls on grains, momentum of the jet less that at the top;
    weight less buoyancy, and the momentum that grains win a second."""
    steps = [k for k, time in enumerate(report["time"]) if time > start]
    mass, time, y = rhoP*report["grainVolume"][0], report["time"], report["massCenterY"]
    span = time[steps[-1]] - time[steps[0]]
    speeds = [(y[k] - y[k - 1])/(time[k] - time[k - 1]) for k in (steps[0], steps[-1])]
    pressure = sum(meanBetween(valuesOf(case, patch), start, time[-1]) for patch in ("floor", "jet"))
    walls = -sum(report["wallForceY"][k] for k in steps)/len(steps)
    jet = case.front*case.jetWidth
    return pressure + walls + AIR*U**2*jet*(1 - jet/area), mass*(1 - AIR/rhoP)*G + mass*(speeds[1] - speeds[0])/span


def meanPressures(*patches):
    return "functions { %s }" % "".join("%s { type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name %s; operation areaIntegrate; "
                                        "fields (p_rgh); writeFields no; log no; }\n" % (patch, patch) for patch in patches)


def withoutFluid(case, grains, deltaT, endTime, interval=None, extra=""):
    """Settings and times of a case of grains alone."""
    case.gravity((0, -G, 0))
    case.grains("fluid none;\n" + grains)
    case.control(deltaT, endTime, interval or endTime, extra=extra)
    return case


def granularBox(name, lower, upper, cells):
    """MFiX's background mesh, whose sides are walls; what grains meet within is a surface."""
    return BoxCase(BUILD/name, lower, upper, cells, {side: "wall" for side in ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax")})


def hopper3d(verdict):
    """MFiX's hopper_3d: 8887 spheres of 20 mm, laid at 0.2 in a cylinder of 1 m, fall into a cone with a hole of ten diameters and on into a bin, 3.2 s of 5 in steps of 1 ms,
    no gas.

    The flow through the hole, the mean from the first to the third quarter that has left, is that of Beverloo's law, 0.58 rho_b sqrt(g) (D - 1.4 d)^2.5, at least, since
    a cone helps, and at most (tan 39.8 tan phi)^-0.35 of it (Rose and Tanaka 1959) with phi = 15 degrees, the friction of a bed of spheres whose own is 0.1. That
    factor was measured for 30 degrees and more: it gives 1.69, for 30 degrees 1.29; found is 1.23."""
    d, rhoP, number = 0.02, 2500, 8887
    case = granularBox("hopper3d", (-0.5, -2, -0.5), (0.5, 0.45, 0.5), (25, 60, 25))
    cone, bottom = -0.5 - 0.6*(1 - 0.1/0.5), -1.995
    writeStl(case, "hopper.stl", revolved([(0.45, 0.5), (-0.5, 0.5), (cone, 0.1), (-1.395, 0.1), (-1.395, 0.25), (bottom, 0.25), (bottom, 0)]))
    withoutFluid(case, "materials { grain { density %g; } }\ncontacts { default { friction 0.1; restitution 0.5; } }\nwalls { hopper { type stl; file \"hopper.stl\"; } }\n"
              "grains { type filling; region { type cylinder; axis (0 -0.5 0) (0 -0.25 0); radius 0.49; } number %d; diameter %g; }" % (rhoP, number, d), 1e-3, 3.2,
                 extra="functions { flux { type grainFlux; planes { hole { point (0 %g 0); normal (0 -1 0); } } } }" % cone)
    report = case.run().report()
    name = "hopper3d"
    verdict.near(name + ": grains", report["grains"][-1], number, 0)
    judgeGrains(verdict, name, report, 1e-3)
    mass = rhoP*volumeOf(d)
    times, through = massThrough(case, "hole")
    verdict.near(name + ": mass through the hole at the end over that of all grains", through[-1]/(number*mass), 1, 0.01)
    quarter = [next(t for t, m in zip(times, through) if m > part*through[-1]) for part in (0.25, 0.75)]
    rate, flat = 0.5*through[-1]/(quarter[1] - quarter[0]), 0.58*0.6*rhoP*math.sqrt(G)*(0.2 - 1.4*d)**2.5
    verdict.below(name + ": Beverloo's law for a flat floor over the rate", flat/rate, 1)
    verdict.below(name + ": the rate over that law for a cone, 15 degrees", rate/(flat*coneFactor(15)), 1)
    shown(name + ": rate, that law for a cone, 30 degrees [kg/s]", rate, flat*coneFactor(30))
    case.remove()


def coneFactor(friction, slope=0.5/0.6):
    """Rose and Tanaka 1959; of a cone's half angle only the tangent matters."""
    return (slope*math.tan(math.radians(friction)))**-0.35


def massThrough(case, plane):
    """Times, and the mass that has come through a plane of grainFlux until then."""
    table = case.series("flux/grainFlux.dat")
    return table["Time"], [forward - backward for forward, backward in zip(table[plane + ".massForward"], table[plane + ".massBackward"])]


def mixer3d(verdict):
    """MFiX's mixer_3d: 2000 spheres of 10 mm in a drum of 0.2 m that lies, two hubs with four blades each turn in it against each other, a turn a second, 1 s, no gas.

    MFiX begins with a bed at rest; here the grains are laid beside the blades and fall for 0.3 s. Which half, left or right, a grain
    is then in is its color: Lacey's index of mixing, over 6 x 6 x 6 cells, has to grow from each quarter of a second to the next until it is above 0.8,
    and be above 0.5 after the turn."""
    d, rhoP, number, omega, rest = 0.01, 1000, 2000, 2*math.pi, 0.3
    case = granularBox("mixer3d", (-0.1, -0.1, -0.1), (0.1, 0.1, 0.1), (10, 10, 10))
    writeStl(case, "drum.stl", revolved([(-0.1, 0.1), (0.1, 0.1)], around="z", sides=64))
    for side, low in ("front", 0.03), ("back", -0.07):
        blades = [turned(box((0.015, -0.0039, low + 0.004), (0.095, 0.0039, low + 0.036)), k*math.pi/2) for k in range(4)]
        writeStl(case, side + ".stl", sum(blades, revolved([(low, 0), (low, 0.02), (low + 0.04, 0.02), (low + 0.04, 0)], around="z", sides=32)))
    wall = "%s { type stl; file \"%s.stl\"; motion { type rotation; origin (0 0 0); axis (0 0 1); omega table ((0 0) (%g 0) (%g %.17g)); } }\n"
    part = "%s { type filling; region { type box; box (-0.07 -0.07 %g) (0.07 0.0547 %g); } packing { solidFraction 0.5; } diameter %g; }\n"
    withoutFluid(case, "materials { grain { density %g; } }\ncontacts { default { friction 0.1; restitution 0.9; } }\nwalls { drum { type stl; file \"drum.stl\"; }\n%s%s}\n"
              "grains\n{\n%s%s%s}" % (rhoP, wall % ("front", "front", rest, rest + 1e-3, omega), wall % ("back", "back", rest, rest + 1e-3, -omega),
                                     part % ("left", -0.1, -0.07, d), part % ("middle", -0.03, 0.03, d), part % ("right", 0.07, 0.1, d)),
              5e-4, rest + 1, 0.05)
    report = case.run().report()
    name = "mixer3d"
    verdict.near(name + ": grains at the start", report["grains"][0], number, 0.005)
    judgeGrains(verdict, name, report, 2e-3)
    colors = dict(zip(case.cloud("origId", "0.3"), (x < 0 for x, _, _ in case.cloud("position", "0.3"))))
    mixed = [lacey(case, colors, "%g" % time) for time in (0.3, 0.55, 0.8, 1.05, 1.3)]
    print("     mixer3d: Lacey's index each quarter of a second", " ".join("%.3f" % index for index in mixed))
    verdict.below(name + ": largest fall of Lacey's index below 0.8 in a quarter of a second", max(0.0, *(min(a, 0.8) - b for a, b in zip(mixed, mixed[1:]))), 0)
    verdict.below(name + ": 1 less Lacey's index after a turn", 1 - mixed[-1], 0.5)
    case.remove()


def lacey(case, colors, time, side=0.2/6):
    """1: as mixed as grains thrown at random, 0: apart; cells with fewer than 4 grains do not count."""
    cells = {}
    for grain, place in zip(case.cloud("origId", time), case.cloud("position", time)):
        cells.setdefault(tuple(int((x + 0.1)/side) for x in place), []).append(colors[grain])
    cells = [each for each in cells.values() if len(each) >= 4]
    total = sum(map(len, cells))
    p = sum(map(sum, cells))/total
    spread = sum(len(each)*(sum(each)/len(each) - p)**2 for each in cells)/total
    apart, random = p*(1 - p), p*(1 - p)*len(cells)/total
    return (apart - spread)/(apart - random)


def hopperMassinflow(verdict):
    """MFiX's hopper_massinflow_psd: a closed hopper of 125 mm with 1 % of its volume spheres of 2 mm, normal sizes, takes in lighter ones of 4.1 mm, log-normal, through its
    roof: a tenth of its area, 0.1 m/s, in steps of 1 ms, no gas. 0.35 s of 0.5 s.

    Sizes are taken by number. What comes in is the rate times the time, to a grain; the mean volume of a grain is that of the sizes."""
    seconds, rate = 0.35, 0.1*0.1*1000*math.pi*0.0625**2
    case = granularBox("hopperMassinflow", (0, -0.013, 0), (0.125, 0.16, 0.125), (25, 25, 25))
    profile = [(-0.013, 0), (-0.013, 0.0125), (0, 0.0125), (0.035, 0.0625), (0.16, 0.0625), (0.16, 0)]
    writeStl(case, "hopper.stl", revolved(profile, center=(0.0625, 0.0625)))
    withoutFluid(case, "materials { first { density 2500; } second { density 1000; } wall {} }\nwallMaterial wall;\ncontacts { default { friction 0.5; restitution 0.5; } }\n"
              "walls { hopper { type stl; file \"hopper.stl\"; } }\ngrains\n{\n"
              "first { type filling; material first; region { type stl; file \"hopper.stl\"; } solidFraction 0.01;\n"
              "sizes { type normal; by number; mean 2e-3; deviation 2e-4; min 1e-3; max 3e-3; } }\n"
              "second { type entering; material second; region { type cylinder; axis (0.0625 0.145 0.0625) (0.0625 0.156 0.0625); radius 0.058; }\n"
              "massRate %.17g; velocity (0 -0.1 0); sizes { type logNormal; by number; mean 4.1e-3; deviation 1e-3; min 2e-3; max 8e-3; } }\n}" % rate, 1e-3, seconds)
    report = case.run().report()
    name = "hopperMassinflow"
    judgeGrains(verdict, name, report, 2e-3)
    largest = 1000*volumeOf(8e-3)
    verdict.near(name + ": mass that came [kg]", report["enteredMass"][-1], rate*seconds, largest/(rate*seconds))
    mean = report["enteredMass"][-1]/report["entered"][-1]
    verdict.near(name + ": mean mass of those that came [kg]", mean, 1000*math.pi/6*meanCube(4.1e-3, 1e-3, 2e-3, 8e-3), 0.06)
    hull = 0.0125**2*math.pi*0.013 + math.pi/3*0.035*(0.0125**2 + 0.0125*0.0625 + 0.0625**2) + math.pi*0.0625**2*0.125
    verdict.near(name + ": volume of the first ones over that of the hopper", report["grainVolume"][0]/hull, 0.01, 0.05)
    case.remove()


def meanCube(mean, deviation, low, high, steps=2000):
    """Of a log-normal size between bounds."""
    variance = math.log(1 + (deviation/mean)**2)
    middle = math.log(mean) - variance/2
    total = weight = 0.0
    for k in range(steps):
        d = low + (high - low)*(k + 0.5)/steps
        density = math.exp(-(math.log(d) - middle)**2/(2*variance))/d
        total += density*d**3
        weight += density
    return total/weight


CASES = (fluidBed2d, hopper3d, mixer3d, hopperMassinflow)
