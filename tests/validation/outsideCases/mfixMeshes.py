# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Meshes of the cases of MFiX that are no plain boxes."""

from foamCase import MeshedCase, vec


class BlocksCase(MeshedCase):
    """Plane blocks side by side, from z = 0 (or `back`) to `front` in `layers` cells. A block is four corners (x, y), counter-clockwise from the lower left, and cells
    along x and y; `edges` gives each patch's edges as pairs of corners. What is left over is the patch walls; frontAndBack is `sides`."""

    def __init__(self, folder, blocks, edges, front, back=0.0, layers=1, sides="empty"):
        super().__init__(folder, {**{name: "patch" for name in edges if name != "floor"}, **({"floor": "wall"} if "floor" in edges else {}),
                                  "walls": "wall", "frontAndBack": sides})
        self.blocks, self.edges, self.front, self.back, self.layers = blocks, edges, front, back, layers
        self.writeMesh()

    def writeMesh(self):
        corners = sorted({corner for block, _ in self.blocks for corner in block})
        number = {corner: k for k, corner in enumerate(corners)}
        n = len(corners)
        vertices = "\n".join(vec((x, y, z)) for z in (self.back, self.front) for x, y in corners)
        hexes = "".join("hex (%s) (%d %d %d) simpleGrading (1 1 1)\n"
                        % (" ".join(str(number[c] + shift) for shift in (0, n) for c in block), *cells, self.layers) for block, cells in self.blocks)
        faces = {name: [self.edgeFace(number, n, edge) for edge in edges] for name, edges in self.edges.items()}
        faces["walls"] = [self.edgeFace(number, n, edge) for edge in self.freeEdges()]
        faces["frontAndBack"] = [" ".join(str(number[c] + shift) for c in block) for block, _ in self.blocks for shift in (0, n)]
        boundary = "".join("%s { type %s; faces (%s); }\n" % (name, self.types[name], " ".join("(%s)" % face for face in each)) for name, each in faces.items())
        self.write("system/blockMeshDict", "vertices\n(\n%s\n);\nblocks\n(\n%s);\nboundary\n(\n%s);" % (vertices, hexes, boundary))

    def edgeFace(self, number, n, edge):
        a, b = (number[corner] for corner in edge)
        return "%d %d %d %d" % (a, b, b + n, a + n)

    def freeEdges(self):
        """Of one block alone and of no named patch."""
        named = {frozenset(edge) for edges in self.edges.values() for edge in edges}
        all_ = [frozenset((block[k], block[(k + 1) % 4])) for block, _ in self.blocks for k in range(4)]
        return [tuple(edge) for edge in dict.fromkeys(all_) if all_.count(edge) == 1 and edge not in named]


class JetBedCase(BlocksCase):
    """A bed one cell thick with a jet through the middle cell of its floor; patches floor, jet, top and walls."""

    def __init__(self, folder, width, height, thickness, cells):
        self.jetWidth = dx = width/cells[0]
        x = [0, cells[0]//2*dx, (cells[0]//2 + 1)*dx, width]
        blocks = [(((a, 0), (b, 0), (b, height), (a, height)), (n, cells[1])) for a, b, n in zip(x, x[1:], (cells[0]//2, 1, cells[0]//2))]
        edges = {"floor": [((x[0], 0), (x[1], 0)), ((x[2], 0), (x[3], 0))], "jet": [((x[1], 0), (x[2], 0))],
                 "top": [((a, height), (b, height)) for a, b in zip(x, x[1:])]}
        super().__init__(folder, blocks, edges, thickness)
