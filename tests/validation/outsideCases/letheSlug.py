# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Lethe's dense pneumatic conveying (examples/unresolved-cfd-dem): a slug of grains that air pushes through a periodic pipe."""

import math
import re
from pathlib import Path

from outsideCase import BUILD, G, CylinderCase, diFelice, hinderedGradient, shown

RADIUS, LENGTH, CORE, LAYER = 0.042, 1.0, 0.5, 0.021      # of the pipe, the slug's core and the height of the layer before it [m]
D, IN_PARCEL, RHO_P, RHO_F, NU = 5e-3, 8, 890, 1.205, 1.5e-5
PARCEL = D*IN_PARCEL**(1/3)
SLICES = 200                                              # along the pipe, a grain long, as in the original's script


def densePneumaticConveying(verdict):
    """Lethe's dense-pneumatic-conveying: 32 194 spheres of 5 mm in a periodic pipe 1 m long and 84 mm wide, a slug between slopes of 45 degrees, 0.5 m long, and a layer
    of a fifth of the section before it, on 16 x 90 x 3 cells of two diameters; Di Felice's drag, Saffman's lift, rolling friction 0.2. Parcels of 8 grains, steps of 1 ms.

    As there: friction with the wall is 2*0.3*0.4/0.7, the harmonic mean that Lethe makes of grains' 0.3 and wall's 0.4, and void fraction and what is exchanged are
    smoothed by 1 - L^2 laplace, L = 10 mm, which has the variance of a Gaussian 33 mm wide.

    What is held there is 3 m/s as the mean of u over the fluid, a volume flux of 1.9 m/s with this many grains; here it is a flux of 3 m/s, as with less the slug of parcels
    dies away (README.md). Judged is what does not depend on the flow: the slug lasts, and is faster than its grains as Lethe has it, by Lavrinec et al.
    2020, u_slug = 0.967 u_grains + 0.5 sqrt(g D); the original's own speeds are shown."""
    flux, start, end = 3, 0.5, 1
    plugDrop(verdict, flux)
    dry = settledSlug(verdict)
    case = pipe("slug", "meanFlow (0 0 %g);\nforces { drag { law DiFelice; } saffmanLift on; }\nvoidFraction { diffusion %.4g; }\n%s"
                % (flux, 2*math.sqrt(4*math.log(2))*0.01/PARCEL, 'grains { type time; case "../slugSettled"; time latestTime; }'), end)
    case.run()
    dry.remove()
    states = [Slug(case, time) for time in case.times() if float(time) >= start - 1e-9]
    report = case.report()
    verdict.near("densePneumaticConveying: parcels", report["grains"][-1], report["grains"][0], 0)
    verdict.below("densePneumaticConveying: length of the slug at the end, 0.4 over it", 0.4/states[-1].length, 1)
    grains = sum(state.speed for state in states)/len(states)
    slug = travelled(states)/(float(states[-1].time) - float(states[0].time))
    verdict.near("densePneumaticConveying: speed of the slug, by that of its grains [m/s]", slug, 0.967*grains + 0.5*math.sqrt(G*2*RADIUS), 0.1)
    shown("densePneumaticConveying: speed of the slug [m/s]", slug, 1.30)
    shown("densePneumaticConveying: speed of grains in it [m/s]", grains, 0.83)
    verdict.below("densePneumaticConveying: overlap, in diameters", max(report["overlapMax"]), 0.01)
    case.remove()


def plugDrop(verdict, flux):
    """Held grains, each for itself, that fill a tenth of the pipe to its roof: the drop is that of the law for their mean fluid fraction."""
    length = LENGTH/10
    packed = packedPipe("plugPacked", length, "packing { solidFraction 0.6; } diameter %g;" % D)
    case = pipe("plug", "meanFlow (0 0 %g);\nmotion fixed;\nforces { drag { law DiFelice; } }\ngrains { type time; case \"../plugPacked\"; time latestTime; }" % flux,
                0.02, length=length)
    case.run()
    packed.remove()
    gradient = (Path(case.folder)/case.times()[-1]/"uniform/meanFlowGradient").read_text()
    alpha = 1 - len(case.cloud("d"))*math.pi/6*D**3/(case.area()*length)
    verdict.near("densePneumaticConveying: gradient in a plug that is held [Pa/m]", -float(re.search(r"value\s+\(\S+ \S+ ([^)]*)\)", gradient).group(1)),
                 hinderedGradient(diFelice, alpha, flux, D, RHO_F, RHO_F*NU), 0.05)
    case.remove()


def packedPipe(name, length, what):
    """Packed densely, at random, as far as a round pipe within the cross-section reaches."""
    return pipe(name, "fluid none;\ngrains { type filling; region { type cylinder; axis (0 0 %g) (0 0 %g); radius %.9g; } %s }"
                % (-length/2, length/2, RADIUS*math.cos(math.pi/16), what), 1e-5, 1e-5, length).run()


def pipe(name, settings, endTime, deltaT=1e-3, length=LENGTH):
    case = CylinderCase(BUILD/name, RADIUS, -length/2, length/2, 4, 2, round(90*length), "cyclic")
    case.fluid(RHO_F, RHO_F*NU, (0, -G, 0))
    case.grains("materials { grain { density %g; } wall {} }\nwallMaterial wall;\ncontacts { grain-grain { friction 0.3; restitution 0.3; rollingFriction 0.2; } "
                "grain-wall { friction %.6g; restitution 0.3; rollingFriction 0.2; } }\n%s" % (RHO_P, 2*0.3*0.4/0.7, settings))
    case.control(deltaT, endTime, min(endTime, 0.05))
    return case


def settledSlug(verdict):
    """A pipe packed densely, of which the grains below the slug's surface are kept and fall together for 0.15 s; the original pours them in from one end."""
    packed = packedPipe("slugPacked", LENGTH, "packing { solidFraction 0.61; } diameter %g; coarseGraining %.15g;" % (D, PARCEL/D))
    kept = [(x, y, z, D) for x, y, z in packed.cloud("position") if y + PARCEL/2 <= surfaceHeight(z) + 0.3*PARCEL]
    packed.remove()
    verdict.near("densePneumaticConveying: grains in parcels", IN_PARCEL*len(kept), 32194, 0.1)
    settled = pipe("slugSettled", "fluid none;\ngrains { type table; file grains.dat; coarseGraining %.15g; }" % (PARCEL/D), 0.15)
    settled.table(kept)
    return settled.run()


def surfaceHeight(z):
    """Of the grains at the start: the roof, slopes of 45 degrees, the layer."""
    return min(RADIUS, max(LAYER - RADIUS, RADIUS - (abs(z) - CORE/2)))


class Slug:
    """Where the void fraction of slices, meaned over five, is at most 0.55, as the original's script has it; the front is where the largest such part ends."""

    def __init__(self, case, time):
        self.time = time
        places, speeds = [x[2] for x in case.cloud("position", time)], [u[2] for u in case.cloud("U", time)]
        slices = [int((z/LENGTH + 0.5)*SLICES) % SLICES for z in places]
        count = [0]*SLICES
        for k in slices:
            count[k] += 1
        solid = math.pi/6*PARCEL**3*SLICES/(LENGTH*case.area())
        full = [solid*sum(count[(k + j) % SLICES] for j in range(-2, 3))/5 >= 0.45 for k in range(SLICES)]
        self.length = sum(full)*LENGTH/SLICES
        self.front = max((runBefore(full, k), k + 1) for k in range(SLICES))[1]*LENGTH/SLICES if self.length else 0.0
        inside = [u for k, u in zip(slices, speeds) if full[k]]
        self.speed = sum(inside)/len(inside) if inside else 0.0


def runBefore(full, last):
    """How many slices up to and with `last` are full in a row."""
    return next((n for n in range(len(full)) if not full[last - n]), len(full))


def travelled(states):
    """By the front, which goes through the periodic ends forwards."""
    return sum((after.front - before.front) % LENGTH for before, after in zip(states, states[1:]))


CASES = (densePneumaticConveying,)
