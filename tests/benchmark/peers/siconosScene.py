# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A plain scene in Siconos, which runs this: /usr/bin/python3 siconosScene.py INPUT, where plainScene.described wrote INPUT.

Rigid spheres and Coulomb's friction with Newton's restitution, Moreau-Jean's time stepping with theta 0.5, NSGS, and Siconos' own search for spheres
and planes (SpaceFilter). Lengths are in radii of the smallest grain: cells of the search are a whole number of units wide. That search takes the law of a
contact from a group that Python cannot set, so each material is a simulation of its own, one after another: right for grains of one material, or
that do not meet. The search with Bullet can tell groups apart, but Debian's Bullet is in single precision: of W3's grains of 0.5 mm on 2 m, after 8 steps
of 1 ms, speeds were off by 70 % (the plane as one box), or by 1 to 4 % after 20 to 30 s (a box under each grain), and by nothing, in 1 s, here."""

import json
import math
import sys

import numpy
import siconos.kernel as kernel
import siconos.numerics as numerics
from siconos.mechanics.collision.bodies import SphereNEDS
from siconos.mechanics.collision.native import SpaceFilter

CELL, REACH = 4, 1          # of the search: width of a cell, and what grains are looked for within, in radii
THETA, TOLERANCE, SWEEPS = 0.5, 1e-8, 10000
CLOSED = 1e-6               # gaps that count as closed, in radii: at 0, its default, grains at rest let go when rounding lifts them, fall, and bounce


def bodyOf(grain, density, gravity, unit):
    radius = grain["radius"]/unit
    mass = density*4/3*math.pi*radius**3
    lengths = [value/unit for value in (*grain["x"], *grain["v"], *gravity)]
    body = SphereNEDS(radius, mass, 0.4*mass*radius**2*numpy.eye(3), [*lengths[:3], 1.0, 0.0, 0.0, 0.0], [*lengths[3:6], *grain["omega"]])
    body.setFExtPtr(mass*numpy.array(lengths[6:]))
    return body


def searchOf(planes, law, unit):
    rows = [[plane["side"]*float(axis == plane["axis"]) for axis in range(3)] + [-plane["side"]*plane["place"]/unit] for plane in planes]
    search = SpaceFilter(REACH, CELL, numpy.array(rows))
    search.insertNonSmoothLaw(law, 0, 0)
    return search


def frictionProblem(count):
    solver = kernel.solver_options_create(numerics.SICONOS_FRICTION_3D_NSGS)
    solver.iparam[numerics.SICONOS_IPARAM_MAX_ITER] = SWEEPS
    solver.dparam[numerics.SICONOS_DPARAM_TOL] = TOLERANCE
    problem = kernel.FrictionContact(3, solver)
    problem.setMStorageType(numerics.NM_SPARSE_BLOCK)
    problem.setMaxSize(3*8*count)
    problem.setKeepLambdaAndYState(True)
    return problem


def simulationOf(bodies, deltaT, steps):
    system = kernel.NonSmoothDynamicalSystem(0.0, (steps + 1)*deltaT)
    for body in bodies:
        system.insertDynamicalSystem(body)
    simulation = kernel.TimeStepping(system, kernel.TimeDiscretisation(0.0, deltaT))
    integrator = kernel.MoreauJeanOSI(THETA)
    integrator.setConstraintActivationThreshold(CLOSED)
    simulation.insertIntegrator(integrator)
    simulation.insertNonSmoothProblem(frictionProblem(len(bodies)))
    simulation.setNewtonOptions(kernel.SICONOS_TS_LINEAR)
    return simulation


def inWorld(q, a):
    """Of a vector in the frame of a body whose quaternion is q: spins are there."""
    axis = q[1:]
    return a + 2*numpy.cross(axis, numpy.cross(axis, a) + q[0]*a)


def rowOf(body, unit):
    q, twist = numpy.array(body.q()), numpy.array(body.twist())
    return [*(q[:3]*unit), *(twist[:3]*unit), *inWorld(q[3:], twist[3:])]


def moved(given, material, unit):
    """Rows of its grains at each count of steps."""
    scene, counts = given["scene"], given["steps"]
    bodies = [bodyOf(grain, scene["density"], scene["gravity"], unit) for grain in scene["grains"] if grain["material"] == material]
    law = kernel.NewtonImpactFrictionNSL(scene["restitution"], 0.0, scene["friction"][material], 3)
    simulation = simulationOf(bodies, given["deltaT"], counts[-1])
    simulation.insertInteractionManager(searchOf(scene["planes"], law, unit))
    found = []
    for step in range(1, counts[-1] + 1):
        simulation.computeOneStep()
        simulation.nextStep()
        found += [[rowOf(body, unit) for body in bodies]]*counts.count(step)
    return found


def main():
    with open(sys.argv[1]) as file:
        given = json.load(file)
    grains = given["scene"]["grains"]
    unit = min(grain["radius"] for grain in grains)
    found = {material: moved(given, material, unit) for material in {grain["material"] for grain in grains}}
    for k in range(len(given["steps"])):
        rows = {material: iter(times[k]) for material, times in found.items()}
        with open("%s.%d" % (given["prefix"], k + 1), "w") as file:
            file.writelines(" ".join("%.17g" % value for value in next(rows[grain["material"]])) + "\n" for grain in grains)


main()
