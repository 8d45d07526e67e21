# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Boxes of cells that are good, far from orthogonal, or a hundred times as wide as high."""

from foamCase import BoxCase, MeshedCase, vec

# Of a prism's triangle, width over height, where the lines between centers are 70 degrees off the normals of the slanted and of the flat sides.
SLANT = 5.5


class PrismCase(MeshedCase):
    """Bricks, numbered along x, y, then z, each cut along its diagonal in (x, z) into a prism below and one above it."""

    def __init__(self, folder, lower, upper, bricks, types):
        super().__init__(folder, types)
        self.lower, self.bricks = lower, bricks
        self.size = [(b - a)/n for a, b, n in zip(lower, upper, bricks)]
        self.writeMesh()

    def cornersOfCells(self):
        """Of each cell the corners of its triangle at its lower y, as steps along (x, y, z)."""
        for k in range(self.bricks[2]):
            for j in range(self.bricks[1]):
                for i in range(self.bricks[0]):
                    yield (i, j, k), (i + 1, j, k), (i + 1, j, k + 1)
                    yield (i, j, k), (i + 1, j, k + 1), (i, j, k + 1)

    def place(self, step):
        return tuple(a + n*h for a, n, h in zip(self.lower, step, self.size))

    def centersOfCells(self):
        return [self.place([sum(corner[axis] for corner in triangle)/3 + 0.5*(axis == 1) for axis in range(3)]) for triangle in self.cornersOfCells()]

    def writeMesh(self):
        cellsOf = {}    # by the set of its corners: a face as its first cell sees it from outside, and its cells
        for cell, triangle in enumerate(self.cornersOfCells()):
            far = [(i, j + 1, k) for i, j, k in triangle]
            faces = [triangle, far[::-1]] + [(triangle[a], far[a], far[a - 2], triangle[a - 2]) for a in range(3)]
            for face in faces:
                cellsOf.setdefault(frozenset(face), (face, []))[1].append(cell)
        inside = sorted((face for face in cellsOf.values() if len(face[1]) == 2), key=lambda face: face[1])
        sides = {side: [face for face in cellsOf.values() if len(face[1]) == 1 and self.side(face[0]) == side] for side in self.types}
        self.writeParts(inside, sides)

    def side(self, face):
        for axis, name in enumerate("xyz"):
            steps = {corner[axis] for corner in face}
            if len(steps) == 1 and steps <= {0, self.bricks[axis]}:
                return name + ("Max" if steps == {self.bricks[axis]} else "Min")
        return None

    def writeParts(self, inside, sides):
        folder = "constant/polyMesh/"
        points = [(i, j, k) for k in range(self.bricks[2] + 1) for j in range(self.bricks[1] + 1) for i in range(self.bricks[0] + 1)]
        numbers = {point: number for number, point in enumerate(points)}
        faces = inside + [face for side in sides.values() for face in side]

        def put(name, foamClass, lines):
            self.write(folder + name, "%d\n(\n%s\n)" % (len(lines), "\n".join(lines)), foamClass)

        put("points", "vectorField", [vec(self.place(point)) for point in points])
        put("faces", "faceList", ["%d(%s)" % (len(face), " ".join(str(numbers[corner]) for corner in face)) for face, _ in faces])
        put("owner", "labelList", [str(cells[0]) for _, cells in faces])
        put("neighbour", "labelList", [str(cells[1]) for _, cells in inside])
        start, entries = len(inside), []
        for name, side in sides.items():
            entries.append("%s { type %s; nFaces %d; startFace %d; }" % (name, self.types[name], len(side), start))
            start += len(side)
        put("boundary", "polyBoundaryMesh", entries)


SCHEMES = """
ddtSchemes           { default Euler; }
gradSchemes          { default Gauss linear; }
divSchemes           { default Gauss linear; div(phi,U) Gauss linearUpwindV grad(U); }
laplacianSchemes     { default Gauss linear limited corrected 0.5; }
interpolationSchemes { default linear; }
snGradSchemes        { default limited corrected 0.5; }
"""


class Mesh:
    """Cells of a box and their centers' heights; `good`: numbers of cells of the good mesh along x and y."""

    def __init__(self, kind, lower, upper, good):
        self.kind, self.lower, self.upper = kind, lower, upper
        width, height = upper[0] - lower[0], upper[2] - lower[2]
        self.cells = {"good cells": (*good, round(good[0]*height/width)),
                      "prisms of 70 degrees": (2, good[1], round(2*height/width*SLANT)),
                      "cells of aspect 100": (1, 1, round(100*height/width))}[kind]

    def case(self, folder, types):
        kind = PrismCase if self.kind.startswith("prisms") else BoxCase
        case = kind(folder, self.lower, self.upper, self.cells, types)
        case.write("system/fvSchemes", SCHEMES)
        return case

    def heights(self, case):
        if isinstance(case, PrismCase):
            return [center[2] for center in case.centersOfCells()]
        perLayer, layers = case.cells[0]*case.cells[1], case.cells[2]
        return [self.lower[2] + (k//perLayer + 0.5)*(self.upper[2] - self.lower[2])/layers for k in range(perLayer*layers)]


MESHES = ("good cells", "prisms of 70 degrees", "cells of aspect 100")
