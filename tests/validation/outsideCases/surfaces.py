# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Triangulated surfaces of the cases of other solvers: bodies of revolution, prisms, boxes and plates, written as ASCII STL."""

import math
import os


def revolved(profile, around="y", center=(0, 0), sides=48, drop=lambda angle, radius, height: False):
    """Triangles of the surface that a profile ((height, radius) ...) sweeps around an axis; `drop` says which panels are left out, by the angle,
    radius and height of their middle."""
    panels = []
    for (h0, r0), (h1, r1) in zip(profile, profile[1:]):
        for k in range(sides):
            a, b = 2*math.pi*k/sides, 2*math.pi*(k + 1)/sides
            if not drop((a + b)/2, (r0 + r1)/2, (h0 + h1)/2):
                panels.append([point(around, center, h, r, angle) for h, r, angle in ((h0, r0, a), (h1, r1, a), (h1, r1, b), (h0, r0, b))])
    return plates(panels)


def point(around, center, height, radius, angle):
    """At an angle from x about y or z."""
    a, b = center[0] + radius*math.cos(angle), center[1] + radius*math.sin(angle)
    return (a, height, b) if around == "y" else (a, b, height)


def plates(panels):
    """Triangles of flat convex panels, fanned out from their first corners; what has no area is left out."""
    triangles = [(panel[0], panel[k], panel[k + 1]) for panel in panels for k in range(1, len(panel) - 1)]
    return [corners for corners in triangles if area(corners) > 1e-14]


def area(corners):
    a, b, c = corners
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    return 0.5*math.sqrt(sum((u[i]*v[j] - u[j]*v[i])**2 for i, j in ((0, 1), (1, 2), (2, 0))))


def box(lower, upper):
    """Triangles of a box's six sides."""
    corner = [tuple((lower, upper)[k >> axis & 1][axis] for axis in range(3)) for k in range(8)]
    return plates([[corner[k] for k in side] for side in ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))])


def turned(triangles, angle):
    """About z."""
    c, s = math.cos(angle), math.sin(angle)
    return [tuple((c*x - s*y, s*x + c*y, z) for x, y, z in corners) for corners in triangles]


def writeStl(case, name, triangles):
    """To constant/triSurface of a case."""
    folder = os.path.join(case.folder, "constant/triSurface")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name), "w") as file:
        file.write("solid %s\n" % name)
        for corners in triangles:
            file.write("facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n" % "".join("vertex %.9g %.9g %.9g\n" % corner for corner in corners))
        file.write("endsolid\n")
