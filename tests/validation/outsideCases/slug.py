# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Lethe's dense pneumatic conveying: a slug of grains that air pushes through a pipe, over a layer at rest."""

import math

from foamCase import SOLUTION
from outsideCase import BUILD, G, CylinderCase, meanBetween

RADIUS, LENGTH, CORE = 0.042, 0.5, 0.26      # of the pipe, and of the part that is filled densely [m]
D, GRAINS = 5e-3, 16097


def densePneumaticConveying(verdict):
    """Lethe's dense-pneumatic-conveying: grains of 5 mm in a horizontal pipe of 84 mm, periodic, with air of 3 m/s in the mean over the fluid; Di Felice's
    drag, Saffman's lift. The pipe is 0.5 m for 1 m, with half of the 32 194 grains; steps are 2 ms for 0.5 ms, 2 s for 5 s.

    Grains fill half of the pipe and lie loosely in the other, as many as make a slug with slopes of 45 degrees and a layer of 21 mm there,
    settle for 0.2 s, and go with the air; its gradient acts on grains too, as there. As there a slug is where the void fraction of slices
    5 mm wide, a mean of five, is below 0.55; its front goes at 1.30 m/s, and the grains in it at 0.83 m/s, in the last second; and the
    front's speed is 0.967 times theirs and sqrt(g D)/2 (Lavrinec et al. 2020)."""
    filling = pipe("slugFilling", "fluid none;\ngrains { %s }" % " ".join(sources()))
    filling.control(1e-3, 0.2)
    grains = int(filling.run().report()["grains"][-1])
    verdict.near("densePneumaticConveying: grains", grains, GRAINS, 0.05)
    superficial = 3*(1 - grains*math.pi/6*D**3/(filling.area()*LENGTH))
    case = pipe("densePneumaticConveying", "meanFlow (0 0 %g);\nforces { drag { law DiFelice; } saffmanLift on; }\n"
                'grains { type time; case "../slugFilling"; time latestTime; }' % superficial)
    case.control(2e-3, 2, 0.05)
    case.run()
    filling.remove()
    fronts, speeds = [], []
    for time in case.times()[1:]:
        rear, front = slugOf(case, time)
        front += LENGTH*round((fronts[-1][1] + 0.06 - front)/LENGTH) if fronts else 0
        fronts.append((float(time), front))
        speeds.append((float(time), meanSpeed(case, time, rear, front)))
    slug, inSlug = slope([row for row in fronts if row[0] > 0.999]), meanBetween(speeds, 1, 2)
    verdict.near("densePneumaticConveying: speed of the slug's front [m/s]", slug, 1.30, 0.15)
    verdict.near("densePneumaticConveying: speed of the grains in it [m/s]", inSlug, 0.83, 0.15)
    verdict.near("densePneumaticConveying: front by the speed of the grains [m/s]", slug, 0.967*inSlug + 0.5*math.sqrt(2*G*RADIUS), 0.1)
    case.remove()


def sources():
    """Dense in the middle, and loosely beside it what is left of the number."""
    within = RADIUS*math.cos(math.pi/16)
    dense = round(0.58*math.pi*within**2*CORE/(math.pi/6*D**3))
    for name, lower, upper, amount in (("slug", -CORE/2, CORE/2, "packing { solidFraction 0.58; }"), ("rear", -LENGTH/2, -CORE/2, None), ("front", CORE/2, LENGTH/2, None)):
        yield ("%s { type filling; material grain; region { type cylinder; axis (0 0 %g) (0 0 %g); radius %.17g; } %s diameter %g; }"
               % (name, lower, upper, within, amount or "number %d;" % ((GRAINS - dense)/2), D))


def pipe(name, settings):
    case = CylinderCase(BUILD/name, RADIUS, -LENGTH/2, LENGTH/2, 4, 2, 45, ends="cyclic")
    case.write("system/fvSolution", SOLUTION % (1e-8, 1e-9))
    case.fluid(1.205, 1.205*1.5e-5, (0, -G, 0))
    case.grains("materials { grain { density 890; } pipe {} }\nwallMaterial pipe;\ncontacts { default { friction 0.3; restitution 0.3; rollingFriction 0.2; } "
                "grain-pipe { friction 0.4; restitution 0.3; rollingFriction 0.2; } }\n%s" % settings)
    return case


def slugOf(case, time):
    """Rear and front of the longest part of the pipe, which is periodic, that grains fill; the front may be beyond the end."""
    count = round(LENGTH/D)
    solid = [0.0]*count
    for _, _, z in case.cloud("position", time):
        for k in range(int((z - D/2 + LENGTH/2)//D), int((z + D/2 + LENGTH/2)//D) + 1):
            solid[k % count] += volumeBelow(-LENGTH/2 + (k + 1)*D, z, D) - volumeBelow(-LENGTH/2 + k*D, z, D)
    filled = [sum(solid[(k + shift) % count] for shift in range(-2, 3))/(5*D*case.area()) >= 0.45 for k in range(count)]
    start, length = max(((k, runFrom(filled, k)) for k in range(count)), key=lambda run: run[1])
    return -LENGTH/2 + start*D, -LENGTH/2 + (start + length)*D


def runFrom(filled, start):
    return next((length for length in range(len(filled)) if not filled[(start + length) % len(filled)]), len(filled))


def volumeBelow(z, center, d):
    """Of the part of a sphere below the height z."""
    h = min(max(z - center + d/2, 0), d)
    return math.pi*h**2*(d/2 - h/3)


def meanSpeed(case, time, rear, front):
    """Of the grains between."""
    inside = [u for (_, _, z), u in zip(case.cloud("position", time), case.cloud("U", time)) if (z - rear) % LENGTH <= (front - rear) % LENGTH]
    return math.sqrt(sum((sum(u[axis] for u in inside)/len(inside))**2 for axis in range(3)))


def slope(rows):
    """Of the line through (time, position)."""
    t, x = (sum(values)/len(rows) for values in zip(*rows))
    return sum((time - t)*(place - x) for time, place in rows)/sum((time - t)**2 for time, _ in rows)


CASES = (densePneumaticConveying,)
