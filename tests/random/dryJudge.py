# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What is wrong with a run of a random scene of nscdGrains: laws that hold in every step, whatever the scene.

Momentum: P' = P + dt (M g - force on the walls), to round-off, whether a step converged or not.
Energy: contacts only take from what the free motion has, T' <= T + dt g.P + M (g dt)^2/2 + work of moving walls, within the tolerance
of the solve: the work of an impulse r is r.(u^- + u')/2, u^- the free velocity."""

import math

from reports import notFinite, readTable, wrongContacts
from vtpFile import readArray

SLACK = 0.05        # [largest diameters] a center may be outside of the walls: overlaps are another finding
MOMENTUM = 1e-9     # share of all impulses: round-off
SLEEP = 2e-3        # share of the weight that sleeping grains may be out of balance by: twice what grainSleep.hpp allows
FIRST_LOOK = 32     # steps until some may sleep
ENERGY = 1e-2       # share of the energies in a step: `tolerance` of the solver


def examine(folder, scene):
    """Findings by kind, and figures."""
    rows = readTable(folder/"results/report.csv")
    broken = notFinite(rows)
    if broken:
        return {"not finite": broken}, {}
    files = sorted((folder/"results/grains").glob("*.vtp"))
    found = {**wrongCounts(scene, rows, files), **wrongContacts(rows)}
    figures = {"steps": len(rows), "atCap": sum(row["atCap"] for row in rows), "overlap": max(row["overlapMax"] for row in rows)}
    if "steps missing" in found:
        return found, figures
    momenta, error = momentum(scene, rows, files)
    figures["momentum"] = error
    maySleep = scene.solver["sleep"] == "on" and scene.half >= FIRST_LOOK
    if error > MOMENTUM + (SLEEP if maySleep else 0):
        found["momentum, at the cap" if figures["atCap"] else "momentum"] = f"off by {error:.2g} of all impulses"
    if "cohesion" not in scene.laws:    # its attraction has an energy of its own
        found.update(energyGrowth(scene, rows, momenta, folder, kineticEnergyAtStart(scene, files[0])))
    return found, figures


def wrongCounts(scene, rows, files):
    """Steps, and grains: their numbers, and whether they are where walls hold them."""
    found = {}
    if len(rows) != 2*scene.half or len(files) != 3:
        found["steps missing"] = f"{len(rows)} steps and {len(files)} files, for {2*scene.half} and 3"
    lost = {len(readArray(path, "id")) for path in files} | {row["grains"] for row in rows}
    outside = sum(isOutside(scene, point) for path in files[1:] for point in readArray(path, "position"))
    if len(lost) != 1 or outside:
        found["grain lost"] = f"{outside} outside of the walls, numbers of grains {sorted(lost)}"
    return found


def isOutside(scene, point):
    slack = SLACK*scene.size
    above = point[scene.up] > scene.high[scene.up] + slack
    if above and not scene.isClosed:
        return False
    return above or any(not -slack < point[axis] < scene.high[axis] + slack for axis in scene.axes if axis != scene.up) or (
        point[scene.up] < -slack)


def clumpVolume(scene):
    """Of two equal balls, or discs of length 1, less what they share."""
    r, half = scene.size/4, scene.arm/2
    if scene.dimensions == 2:
        return 2*math.pi*r*r - 2*(r*r*math.acos(half/r) - half*math.sqrt(r*r - half*half))
    return 8/3*math.pi*r**3 - math.pi/12*(4*r + 2*half)*(2*r - 2*half)**2


def masses(scene, path):
    """Of the rows of a file; members of a clump have half of it each."""
    density = [scene.densities[number] for number in readArray(path, "material")]
    if scene.arm:
        return [rho*clumpVolume(scene)/2 for rho in density]
    volume = (lambda d: math.pi/6*d**3) if scene.dimensions == 3 else (lambda d: math.pi/4*d*d)
    return [rho*volume(d) for rho, d in zip(density, readArray(path, "d"))]


def momentumOf(scene, path):
    """In a file, and the sum of its sizes."""
    weighted = [[m*part for part in u] for m, u in zip(masses(scene, path), readArray(path, "U"))]
    return [sum(column) for column in zip(*weighted)], sum(math.hypot(*p) for p in weighted)


def momentum(scene, rows, files):
    """That after each step, from the forces on walls, and how far the last one is off that of the last file."""
    mass = sum(masses(scene, files[0]))
    now, sizes = momentumOf(scene, files[0])
    all_ = [now]
    for row in rows:
        impulse = [row["deltaT"]*(mass*g - row["wallForce" + axis]) for g, axis in zip(scene.gravity, "XYZ")]
        sizes += row["deltaT"]*(mass*math.hypot(*scene.gravity) + math.hypot(*(row["wallForce" + axis] for axis in "XYZ")))
        all_.append([p + i for p, i in zip(all_[-1], impulse)])
    end, sizeAtEnd = momentumOf(scene, files[-1])
    sizes = max(sizes, sizeAtEnd)
    return all_, math.dist(end, all_[-1])/sizes if sizes > 0 else 0.0


def kineticEnergyAtStart(scene, path):
    """Of what moves on, and of spins: those of clumps, which are not spheres, are taken as if their mass were at the members' rims."""
    kappa = 1 if scene.arm else 0.4 if scene.dimensions == 3 else 0.5
    reach = scene.arm if scene.arm else 0
    energy = 0.0
    for m, d, u, spin in zip(masses(scene, path), readArray(path, "d"), readArray(path, "U"), readArray(path, "omega")):
        energy += m/2*(sum(part*part for part in u) + kappa*(d/2 + reach)**2*sum(part*part for part in spin))
    return energy


def wallWork(scene, row, forces):
    def triple(wall, what):
        return [forces["%s.%s%s" % (wall.text.split()[0], what, axis)] for axis in "XYZ"]
    return sum(wall.work(triple(wall, "force"), triple(wall, "torque"), row["time"] - row["deltaT"], row["time"]) for wall in scene.walls)


def kindOfGrowth(scene, row):
    if not row["converged"]:
        return "energy growth, unconverged"
    return "energy growth, clumps" if scene.arm and scene.laws["restitution"] > 0 else "energy growth"


def energyGrowth(scene, rows, momenta, folder, before):
    """Steps in which contacts give energy, the first of each kind."""
    found, mass = {}, sum(masses(scene, sorted((folder/"results/grains").glob("*.vtp"))[0]))
    for row, forces, p in zip(rows, readTable(folder/"results/walls.csv"), momenta):
        fall = row["deltaT"]*sum(g*part for g, part in zip(scene.gravity, p))
        fromRest = mass/2*sum((g*row["deltaT"])**2 for g in scene.gravity)
        driven = wallWork(scene, row, forces)
        gain = row["kineticEnergy"] - before - fall - fromRest - driven
        slack = ENERGY*(before + abs(fall) + fromRest + abs(driven))
        if gain > slack + 1e-12*row["kineticEnergy"]:
            kind = kindOfGrowth(scene, row)
            text = f"{gain:.2g} J at {row['time']:.3g} s, {gain/slack if slack else math.inf:.2g} times what may be"
            found.setdefault(kind, text)
        before = row["kineticEnergy"]
    return found
