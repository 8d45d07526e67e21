# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A porous piston, the upper end of the mesh, presses a suspension together: a cake of free grains grows before it (constant-rate cake filtration)."""

from foamCase import BoxCase, vec

D, SPEED, RHO, MU = 1e-3, 0.01, 1000, 1e-3
SIDE, HEIGHT, CELLS = 5e-3, 0.03, (2, 2, 16)
LOOSE = 0.25          # solid fraction of the suspension
PACKED = 0.5          # a layer of cells above this is part of the cake
TIMES = ("0.9", "1.2")   # when the cake is 7 and 10 diameters high; one of 5, at 0.6 s, has no inner part to speak of (10 and 13 % off)


def run(folder, stretching):
    """Grains as heavy as water, without weight. The floor is closed: what the grains of the cake take with them flows back through it, and out
    through the piston."""
    case = BoxCase(folder, (0, 0, 0), (SIDE, SIDE, HEIGHT), CELLS, {"zMin": "wall", "zMax": "patch"})
    case.fluid(RHO, MU, (0, 0, 0), sides={"zMin": "type noSlip;", "zMax": "type zeroGradient;"},
               pressureSides={"zMax": "type fixedValue; value uniform 0;"})
    down = "type uniformFixedValue; uniformValue table ((0 (0 0 0)) (10 %s)); value uniform (0 0 0);" % vec((0, 0, -10*SPEED))
    stretching(case, {}, {"cyclic": "type cyclic;", "wall": "type fixedValue; value uniform (0 0 0);", "patch": down})
    case.grains("materials { plastic { density %g; } }\ncontacts { default { friction 0.4; } }\npatches { zMax { type wall; } }\n"
                "forces { drag { law Ergun; } }\ngrains { type filling; region { type box; box (0 0 0) %s; } diameter %g; solidFraction %g; seed 1; }"
                % (RHO, vec((SIDE, SIDE, HEIGHT)), D, LOOSE))
    case.control(0.01, 1.2, 0.3)
    return case.run()


def ergun(solid):
    """Pressure gradient [Pa/m] at the superficial velocity of the piston (Ergun 1952)."""
    porosity = 1 - solid
    return 150*MU*SPEED*solid**2/(porosity**3*D**2) + 1.75*RHO*SPEED**2*solid/(porosity**3*D)


def layers(case, name, time):
    """Means of a field over the layers of cells, from the floor up."""
    values = case.fieldValues(name, time)
    number = CELLS[0]*CELLS[1]
    return [sum(values[k*number:(k + 1)*number])/number for k in range(CELLS[2])]


def inCake(solid):
    """Layers within the cake: not that of its front, and not that at the piston, where no grain's center is near the end."""
    first = max(k for k, value in enumerate(solid[:-1]) if value < PACKED) + 1
    return range(first, len(solid) - 1)


def cakeLaw(case, time):
    """Pressure drop between the lowest and the highest layer within the cake: found, and by Ergun's law; mean solid fraction between."""
    solid = [1 - alpha for alpha in layers(case, "alpha.fluid", time)]
    pressure = layers(case, "p_rgh", time)
    cake = inCake(solid)
    thickness = (HEIGHT - SPEED*float(time))/CELLS[2]
    law = sum(0.5*thickness*(ergun(solid[k]) + ergun(solid[k + 1])) for k in cake[:-1])
    return pressure[cake[0]] - pressure[cake[-1]], law, sum(solid[k] for k in cake)/len(cake)


def filtration(packed, time):
    """Pressure under the cake [Pa]: Ergun's gradient over the height to which a piston that keeps all grains back has piled them up.
    Equation: height = c V t/(phi - c), c of the suspension, phi of the cake (Ruth 1935: in proportion to the volume filtered)"""
    return ergun(packed)*LOOSE*SPEED*time/(packed - LOOSE)


def judge(verdict, case):
    report = case.report()
    for time in TIMES:
        found, law, packed = cakeLaw(case, time)
        verdict.near("press at %s s: pressure drop within the cake, over Ergun's" % time, found, law, 0.1)
        under = layers(case, "p_rgh", time)[0]
        verdict.near("press at %s s: pore pressure under the cake, over that of cake filtration" % time, under, filtration(packed, float(time)), 0.1)
        row = min(range(len(report["time"])), key=lambda k: abs(report["time"][k] - float(time)))
        verdict.near("press at %s s: stress of grains on the piston, over the pore pressure under the cake" % time,
                     report["wallForceZ"][row]/SIDE**2, under, 0.01)
    verdict.below("press: deepest overlap, over a diameter", max(report["overlapMax"]), 1e-2)
