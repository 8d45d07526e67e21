# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Random scenes for nscdGrains, within what its documents say can be had: any sizes, masses, laws, solvers, walls."""

import math
from dataclasses import dataclass, field

from movingWalls import beltWall, bladeWall, lidWall, shakerWall, trayWall


def vector(values):
    return "(" + " ".join("%.17g" % value for value in values) + ")"


@dataclass
class DryScene:
    """A scene, and what a judge needs to know of it. Lengths in m; `up` is the axis against gravity."""
    dimensions: int
    size: float             # largest diameter
    ratio: float            # largest over smallest diameter
    step: float             # [s]
    half: int               # steps up to the restart, and as many after it
    gravity: list
    high: list              # upper corner of the tray, whose lower one is the origin
    densities: list
    laws: dict
    solver: dict
    periodic: list = field(default_factory=list)
    isClosed: bool = True   # the tray has a lid
    arm: float = 0.0        # of clumps of two balls: distance of their centers; 0: none
    walls: list = field(default_factory=list)
    grains: str = ""

    @property
    def up(self):
        return self.dimensions - 1

    @property
    def axes(self):
        return range(self.dimensions)

    def text(self, steps):
        """The scene as nscdGrains reads it, of so many steps."""
        across = "".join("%s (0 %.17g); " % ("xyz"[axis], self.high[axis]) for axis in self.periodic)
        materials = " ".join("m%d { density %.17g; }" % one for one in enumerate(self.densities))
        return "\n".join((
            "deltaT %.17g; endTime %.17g; writeInterval %.17g;" % (self.step, self.step*steps, self.step*self.half),
            "dimensions %d; gravity %s;" % (self.dimensions, vector(self.gravity)),
            "periodic { %s}" % across if across else "",
            "materials { %s }" % materials,
            "contacts { default { %s } }" % entries(self.laws),
            "wallMaterial m0;",
            "grains { bed { %s } }" % self.grains,
            "walls\n{\n%s\n}" % "\n".join(wall.text for wall in self.walls),
            "solver { %s }" % entries(self.solver)))


def entries(values):
    return " ".join("%s %s;" % one for one in values.items())


def randomScene(rng):
    dimensions = 2 if rng.random() < 0.35 else 3
    size, ratio = 10**rng.uniform(-4, -1), rng.choice([1, 1, 2, 5, 10])
    g = rng.choice([0, 9.81, 9.81, 100])
    step = 10**rng.uniform(-5, -2)
    # Some scenes fall several diameters a step; most keep to steps that a user could want.
    if g and rng.random() < 0.9:
        step = min(step, math.sqrt(0.1*size/ratio/g))
    # Grains may fall asleep in the long ones.
    half = rng.randint(10, 25) if rng.random() < 0.9 else rng.randint(100, 150)
    scene = DryScene(dimensions, size, ratio, step, half, gravity=[0, 0, 0], high=[0, 0, 0],
                     densities=[10**rng.uniform(1, 4) for _ in range(rng.choice([1, 1, 2]))], laws={}, solver={})
    scene.gravity = gravity(rng, scene, g)
    hasClumps = rng.random() < 0.15
    scene.laws = laws(rng, scene, hasClumps)
    fillTray(rng, scene, hasClumps)
    scene.solver = solver(rng, scene)
    return scene


def gravity(rng, scene, g):
    """Down, or tilted."""
    tilt = rng.choice([0, 0.3])
    direction = [rng.gauss(0, tilt) if axis in scene.axes else 0 for axis in range(3)]
    direction[scene.up] = -1
    return [g*part for part in direction]


def laws(rng, scene, hasClumps):
    found = {"friction": rng.choice([0, 0.1, 0.3, 0.5, 1, 2]), "restitution": rng.choice([0, 0, 0.3, 0.9, 1])}
    if not hasClumps and rng.random() < 0.2:
        found["rollingFriction"] = "%.3g" % rng.uniform(0, 0.5)
        found["spinningFriction"] = "%.3g" % rng.uniform(0, 0.3)
    if not hasClumps and rng.random() < 0.15:
        weight = 2500*scene.size**3*9.81
        found["cohesion"] = "%.3g" % (weight*10**rng.uniform(-6, 0))
        found["cohesionRange"] = "%.3g" % (scene.size*rng.choice([0, 1e-3, 1e-2]))
    return found


def fillTray(rng, scene, hasClumps):
    """A lattice of up to 200 grains, a tray around it, and at times something in it that moves."""
    count = [rng.randint(1, 7) if axis in scene.axes else 1 for axis in range(3)]
    while math.prod(count) > 200:
        count[rng.randrange(3)] = 1
    pitch = scene.size*rng.uniform(1.05, 2)
    bed = [pitch*n if axis in scene.axes else 0 for axis, n in enumerate(count)]
    # Periods below four diameters jam grains against their own images: a limit that is documented.
    scene.periodic = [axis for axis in range(scene.up) if rng.random() < 0.25 and bed[axis] > 4.6*scene.size]
    moving = rng.choice(["none", "none", "lid", "shaker", "belt", "blade"])
    floor = 1.5*scene.size if moving == "blade" else 0
    scene.high = list(bed)
    scene.high[scene.up] = floor + 1.5*bed[scene.up] + 2*scene.size
    scene.isClosed = rng.random() < 0.8
    scene.walls = [trayWall(scene), *movingWall(rng, scene, moving, floor + bed[scene.up])]
    low, high = [0, 0, 0], list(bed)
    low[scene.up], high[scene.up] = floor, floor + bed[scene.up]
    scene.grains = lattice(rng, scene, low, high, count, hasClumps)


def movingWall(rng, scene, moving, top):
    if moving == "lid":
        return [lidWall(scene, top)]
    if moving == "shaker":
        return [shakerWall(scene)]
    if moving == "belt":
        return [beltWall(scene, rng.choice([0.01, 0.1]))]
    return [bladeWall(scene, rng.choice([0, 0.05]))] if moving == "blade" and scene.dimensions == 3 else []


def lattice(rng, scene, low, high, count, hasClumps):
    spread = 0 if hasClumps else (scene.ratio - 1)/(scene.ratio + 1)
    diameter = scene.size/(1 + spread)
    small = scene.size/scene.ratio
    # At the start up to some small diameters a step, seldom more than a tenth of one.
    speed = rng.choice([0, 0.005, 0.05, 0.05, 1])*small/scene.step
    moves = [rng.gauss(0, speed) if axis in scene.axes else 0 for axis in range(3)]
    spins = [rng.gauss(0, rng.choice([0, 10])) if scene.dimensions == 3 or axis == 2 else 0 for axis in range(3)]
    text = "type lattice; box %s %s; count %s; diameter %.17g; spread %.17g; jitter %g; seed %d; material m%d; velocity %s; omega %s;" % (
        vector(low), vector(high), vector(count), diameter, spread, rng.choice([0, 0.5, 1]), rng.randint(1, 10**6),
        rng.randrange(len(scene.densities)), vector(moves), vector(spins))
    if hasClumps:
        ball = scene.size/2
        scene.arm = ball*rng.uniform(0.3, 0.9)
        text += " clump { members ((0 0 0) (%.17g 0 0)); diameter %.17g; orientation %s; }" % (
            scene.arm, ball, rng.choice(["random", "asGiven"]))
    return text


def solver(rng, scene):
    """NLGS, which users get; at times another one, where it takes the scene's laws."""
    takesAll = scene.arm or "rollingFriction" in scene.laws or rng.random() < 0.7
    return {"type": "NLGS" if takesAll else rng.choice(["NNCG", "APG", "queue", "direct"]), "sleep": rng.choice(["on", "off"]),
            "accelerate": rng.choice(["on", "on", "off"]), "vectorPath": rng.choice(["auto", "portable"])}
