# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Walls of random scenes, and the work that they do."""

import math
from dataclasses import dataclass

ZERO = (0.0, 0.0, 0.0)


@dataclass
class Wall:
    """`text` of a scene; `walk(t)`: displacement [m]; `slides`: velocity of a belt [m/s]; `spin` [rad/s]."""
    text: str
    walk: object = None
    slides: tuple = ZERO
    spin: tuple = ZERO

    def work(self, force, torque, before, after):
        """On the grains in a step from one time to another [J], force and torque being those of the grains on the wall."""
        moves = tuple(b - a for a, b in zip(self.walk(before), self.walk(after))) if self.walk else ZERO
        length = after - before
        return -sum(f*(m + s*length) + t*w*length for f, m, s, t, w in zip(force, moves, self.slides, torque, self.spin))


def along(scene, length):
    """A vector up."""
    return tuple(length if axis == scene.up else 0.0 for axis in range(3))


def vector(values):
    return "(" + " ".join("%.17g" % value for value in values) + ")"


def trayWall(scene):
    sides = [axis + end for k, axis in enumerate("xyz"[:scene.dimensions]) if k not in scene.periodic for end in ("Min", "Max")
             if scene.isClosed or k != scene.up or end == "Min"]
    return Wall("tray { type box; box (0 0 0) %s; sides (%s); }" % (vector(scene.high), " ".join(sides)))


def lidWall(scene, top):
    """Comes down in the run by a fifth of what is free above the grains."""
    speed = -0.2*(scene.high[scene.up] - top)/(2*scene.half*scene.step)
    return Wall("lid { type plane; point %s; normal %s; motion { type translation; velocity %s; } }" % (
        vector(along(scene, 0.98*scene.high[scene.up])), vector(along(scene, -1)), vector(along(scene, speed))),
        walk=lambda t: along(scene, speed*t))


def shakerWall(scene):
    """Below the floor of the tray, and up to it ten steps a period."""
    amplitude, frequency = 0.05*scene.size, 0.1/scene.step
    return Wall("shaker { type plane; point %s; normal %s; motion { type oscillation; amplitude %s; frequency %.17g; } }" % (
        vector(along(scene, -0.04*scene.size)), vector(along(scene, 1)), vector(along(scene, amplitude)), frequency),
        walk=lambda t: along(scene, amplitude*math.sin(2*math.pi*frequency*t)))


def beltWall(scene, diameters):
    """On the floor, by so many diameters a step."""
    slides = (diameters*scene.size/scene.step, 0.0, 0.0)
    return Wall("belt { type plane; point (0 0 0); normal %s; surfaceVelocity %s; }" % (vector(along(scene, 1)), vector(slides)),
                slides=slides)


def bladeWall(scene, angle):
    """A tilted plate below the grains, at rest or turning by so much a step [rad], where it has room."""
    middle = [scene.high[0]/2, scene.high[1]/2, 0.7*scene.size]
    width = min(scene.high[:2])
    angle = angle if width > 3*scene.size else 0
    corners = [(middle[0] + a*0.3*width, middle[1] + b*0.2*width, middle[2] + a*0.4*scene.size)
               for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    spin = (0.0, 0.0, angle/scene.step)
    motion = "motion { type rotation; origin %s; axis (0 0 1); omega %.17g; }" % (vector(middle), spin[2]) if angle else ""
    return Wall("blade { type polygon; vertices (%s); %s }" % (" ".join(map(vector, corners)), motion), spin=spin)
