# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Meshes of the cases of MFiX that are no plain boxes."""

import math

from foamCase import MeshedCase, vec
from surfaces import plates, revolved, writeStl


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


class CycloneCase(MeshedCase):
    """A cyclone of radius 0.15 m about y, cone from 0.2 to 0.4 m, roof at 0.8 m, a finder of 0.05 m that dips to 0.5 m with a wall of 30 mm, a duct of 0.2 m height tangential
    to it; cut off at y = 0 (bottom), y = 0.9 m (top) and z = 0.25 m (inlet). snappyHexMesh on cells of 12 mm."""

    FIRST = math.radians(110)       # where the duct meets the cylinder; it ends at 180 degrees

    def __init__(self, folder):
        super().__init__(folder, {"inlet": "patch", "top": "patch", "bottom": "patch", "cyclone": "wall"})
        self.inletArea = 0.15*(1 + math.cos(self.FIRST))*0.2
        self.writeMesh()
        writeStl(self, "cyclone.stl", self.surface())
        self.write("system/snappyHexMeshDict", SNAPPY)
        self.control(1, 1)
        self.call("blockMesh")
        self.call("snappyHexMesh", "-overwrite")

    def surface(self):
        profile = [(-0.05, 0.05), (0.2, 0.05), (0.4, 0.15), (0.58, 0.15), (0.78, 0.15), (0.8, 0.15), (0.8, 0.08), (0.5, 0.08), (0.5, 0.05), (0.95, 0.05)]
        body = revolved(profile, sides=72, drop=lambda angle, radius, height: self.FIRST < angle < math.pi and radius > 0.1 and 0.58 < height < 0.78)
        angles = [self.FIRST + k*(math.pi - self.FIRST)/14 for k in range(15)]
        arc = [(0.15*math.cos(angle), 0.15*math.sin(angle)) for angle in angles]
        duct = [[(a[0], y, a[1]), (b[0], y, b[1]), (b[0], y, 0.3), (a[0], y, 0.3)] for y in (0.58, 0.78) for a, b in zip(arc, arc[1:])]
        duct += [[(x, 0.58, z), (x, 0.78, z), (x, 0.78, 0.3), (x, 0.58, 0.3)] for x, z in (arc[0], arc[-1])]
        return body + plates(duct)

    def writeMesh(self):
        """The background: its sides are the openings, where they are cut, and go elsewhere."""
        x, y, z = (-0.16, 0.16), (0, 0.9), (-0.16, 0.25)
        vertices = " ".join(vec((x[i], y[j], z[k])) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)))
        self.write("system/blockMeshDict", "vertices (%s);\nblocks (hex (0 1 2 3 4 5 6 7) (26 70 34) simpleGrading (1 1 1));\nboundary\n(\n"
                   "bottom { type patch; faces ((0 1 5 4)); } top { type patch; faces ((3 7 6 2)); } inlet { type patch; faces ((4 5 6 7)); }\n"
                   "rest { type wall; faces ((0 4 7 3) (1 2 6 5) (0 3 2 1)); }\n);" % vertices)


SNAPPY = """
castellatedMesh true; snap true; addLayers false; mergeTolerance 1e-6;
geometry { cyclone { type triSurfaceMesh; file "cyclone.stl"; } }
castellatedMeshControls
{
    maxLocalCells 1000000; maxGlobalCells 2000000; minRefinementCells 0; nCellsBetweenLevels 1; features ();
    refinementSurfaces { cyclone { level (0 0); patchInfo { type wall; } } }
    resolveFeatureAngle 30; refinementRegions {} locationInMesh (0.1013 0.6517 0.0021); allowFreeStandingZoneFaces false;
}
snapControls { nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; nFeatureSnapIter 10; implicitFeatureSnap true; explicitFeatureSnap false; multiRegionFeatureSnap false; }
addLayersControls { layers {} relativeSizes true; expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1; nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1;
    nSmoothNormals 3; nSmoothThickness 10; maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 10; }
meshQualityControls { maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-13; minTetQuality 1e-15; minArea -1; minTwist 0.02;
    minDeterminant 0.001; minFaceWeight 0.05; minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75; }
"""


class SpoutCase(BlocksCase):
    """A flat spouted bed of 0.1 m above a cone, with a channel of 15 mm from below and a draft tube above it whose walls, 3.75 mm, stand from -0.15 to -0.05 m. Where the
    cone meets the channel its last 15 mm, less than 7.5 mm wide, are left out."""

    def __init__(self, folder):
        channel, tube, wide = 0.0075, 0.01125, 0.05
        levels, rows = (-0.199, -0.17, -0.15, -0.1, -0.05, 0.099), (4, 3, 7, 7, 20)
        wall = {-0.17: 0.015, -0.15: 0.025, -0.1: wide, -0.05: wide, 0.099: wide}
        blocks = []
        for low, high, n in zip(levels, levels[1:], rows):
            strips = [((-channel, -channel), (channel, channel), 3)]
            if low > levels[0]:
                strips.append(((tube, tube), (wall[low], wall[high]), 4))
            if low in (-0.17, -0.05):
                strips.append(((channel, channel), (tube, tube), 1))
            blocks += [quad(low, high, left, right, (cells, n)) for left, right, cells in strips]
            blocks += [quad(low, high, tuple(-x for x in right), tuple(-x for x in left), (cells, n)) for left, right, cells in strips[1:]]
        top = [((block[0][3], block[0][2])) for block in blocks if block[0][3][1] == levels[-1]]
        super().__init__(folder, blocks, {"inlet": [((-channel, levels[0]), (channel, levels[0]))], "top": top}, 0.025/3, -0.025/3, 5, "wall")


def quad(low, high, left, right, cells):
    """A block between two heights, its sides given at both."""
    return ((left[0], low), (right[0], low), (right[1], high), (left[1], high)), cells
