# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A plain scene in Yade, which runs this: yade -n -x -j1 yadeScene.py INPUT, where plainScene.described wrote INPUT.

Hertz, Mindlin's stiffness without slip, Coulomb. Damping is by the restitution (Thornton, Cummins and Cleary 2013, eq. B6 and B7, a fit). Tried by hand, a sphere of
2 mm that meets a plane at 1 m/s in steps of a twentieth of the impact, at 1e5 and 1e7 Pa, leaves with 0.301 and 0.299 for 0.3, 0.503 and 0.501 for 0.5,
0.902 and 0.901 for 0.9, 0.098 and 0.096 for 0.1. No damping acts along contacts that slide. Velocities are those of half a step before."""

import json
import math
import sys

from yade import (Bo1_Sphere_Aabb, Bo1_Wall_Aabb, ForceResetter, FrictMat, Ig2_Sphere_Sphere_ScGeom, Ig2_Wall_Sphere_ScGeom, InsertionSortCollider,
                  InteractionLoop, Ip2_FrictMat_FrictMat_MindlinPhys, Law2_ScGeom_MindlinPhys_Mindlin, MatchMaker, NewtonIntegrator, O, utils)

# Radii that lists of neighbors reach beyond contact. In W2's bed, landing and landed, 0.05, 0.1, 0.2 and 0.5 took 11, 12, 13 and 14 ms a step, 200 steps
# each beside other work: the first two are not told apart.
VERLET = 0.1


def addMaterials(given):
    """Of each kind of grain, and the last of walls."""
    for _ in range(len(given["scene"]["friction"]) + 1):
        O.materials.append(FrictMat(young=given["modulus"], poisson=given["poisson"], density=given["scene"]["density"], frictionAngle=0.0))


def frictionAngles(friction):
    """Of each pair of materials: that of the one which comes first, and walls after all."""
    return MatchMaker(matches=[(a, b, math.atan(friction[a])) for a in range(len(friction)) for b in range(a, len(friction) + 1)])


def addBodies(scene):
    for plane in scene["planes"]:
        O.bodies.append(utils.wall(plane["place"], axis=plane["axis"], sense=plane["side"], material=len(scene["friction"])))
    spheres = []
    for grain in scene["grains"]:
        number = O.bodies.append(utils.sphere(grain["x"], grain["radius"], material=grain["material"]))
        O.bodies[number].state.vel, O.bodies[number].state.angVel = grain["v"], grain["omega"]
        spheres.append(O.bodies[number])
    return spheres


def addEngines(given):
    scene = given["scene"]
    loop = InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(hertzian=True)],
                           [Ip2_FrictMat_FrictMat_MindlinPhys(frictAngle=frictionAngles(scene["friction"]), en=scene["restitution"])],
                           [Law2_ScGeom_MindlinPhys_Mindlin()])
    O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=-VERLET), loop,
                 NewtonIntegrator(damping=0.0, gravity=scene["gravity"])]
    O.dt = given["deltaT"]


def write(spheres, path):
    with open(path, "w") as file:
        for state in (sphere.state for sphere in spheres):
            file.write(" ".join("%.17g" % value for value in (*state.pos, *state.vel, *state.angVel)) + "\n")


def main():
    with open(sys.argv[1]) as file:
        given = json.load(file)
    addMaterials(given)
    spheres = addBodies(given["scene"])
    addEngines(given)
    for k, step in enumerate(given["steps"]):
        if step > O.iter:
            O.run(step - O.iter, True)
        write(spheres, "%s.%d" % (given["prefix"], k + 1))


main()
