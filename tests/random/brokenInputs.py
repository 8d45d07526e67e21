# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What is broken: whole scenes and cases with every keyword, as files by name, and one of them broken in one place."""

import sys
from dataclasses import dataclass
from pathlib import Path

from dictionaryText import entriesOf
from entryBreaks import ENTRY_BREAKS
from fileBreaks import FIELD_BREAKS, FILE_BREAKS, NO_FILE, TABLE_BREAKS, TOKEN_BREAKS
from program import find, fresh, run, write

sys.path.insert(0, str(Path(__file__).resolve().parents[1]/"validation/resources"))
from foamCase import BoxCase

INPUTS = Path(__file__).resolve().parent/"inputs"
SCENES = ("allKeywords", "clumps", "discs")
CASES = ("channel", "slice")


def tetrahedron(low, high):
    """An STL surface of two facets, which is all that a wall needs."""
    corners = [(low[0], low[1], low[2]), (high[0], low[1], low[2]), (low[0], high[1], low[2]), (high[0], high[1], high[2])]
    facets = "".join("facet normal 0 0 1\nouter loop\n%sendloop\nendfacet\n" % "".join("vertex %g %g %g\n" % corners[k] for k in three)
                     for three in ((0, 2, 1), (0, 1, 3)))
    return ("solid mixer\n%sendsolid mixer\n" % facets).encode()


def scene(name):
    files = {path.name: path.read_bytes() for path in (INPUTS/name).iterdir()}
    if name == "allKeywords":
        files["mixer.stl"] = tetrahedron((0.03, 0.03, 0.02), (0.05, 0.05, 0.04))
    return files


def case(name, folder):
    """Of nscdDEMFoam, with its mesh, made in a folder."""
    if name == "channel":
        box = BoxCase(folder, (0, 0, 0), (0.02, 0.02, 0.06), (5, 5, 15),
                      {**dict.fromkeys(("xMin", "xMax", "yMin", "yMax"), "wall"), "zMin": "patch", "zMax": "patch"})
        box.fluid(1000, 0.01, sides={"zMin": "type fixedValue; value uniform (0 0 0.01);"},
                  pressureSides={"zMin": "type fixedFluxPressure; value uniform 0;"})
        box.control(1e-3, 0.005)
        write(Path(folder)/"constant/triSurface/mixer.stl", tetrahedron((0.004, 0.004, 0.035), (0.012, 0.012, 0.040)))
    else:
        box = BoxCase(folder, (0, 0, 0), (0.02, 0.01, 0.02), (5, 1, 5), {"yMin": "empty", "yMax": "empty", "zMin": "wall", "zMax": "wall"})
        box.fluid(1000, 0.01)
        box.control(1e-3, 0.005, extra="adjustTimeStep yes; maxCo 0.5; maxDeltaT 2e-3;")
    box.grains((INPUTS/"cases"/name).read_text())
    for file in ("loose.dat", "others"):
        write(Path(folder)/"constant"/file, (INPUTS/"cases"/file).read_bytes())
    if run([find("blockMesh")], folder, 60).status != 0:
        sys.exit(f"blockMesh fails in {folder}")
    return {str(path.relative_to(folder)): path.read_bytes() for path in Path(folder).rglob("*") if path.is_file()}


@dataclass
class Broken:
    files: dict     # name: bytes
    file: str       # the broken one
    kind: str
    place: str      # the entry's name, or empty

    @property
    def isOurs(self):
        """Whether the dictionary is read by code of this project alone."""
        return self.file in ("scene", "constant/grainProperties")

    def __str__(self):
        return " ".join(part for part in (self.kind, self.place, "in", self.file) if part)


def kindsOf(file):
    """Those that a file can have."""
    kinds = dict(FILE_BREAKS)
    if file.startswith("constant/polyMesh"):
        return kinds
    if file.endswith((".txt", ".dat", ".stl", "positions", "others")):
        return {**kinds, **TABLE_BREAKS}
    if file.startswith("0/"):
        kinds.update(FIELD_BREAKS)
    return {**kinds, **TOKEN_BREAKS, **ENTRY_BREAKS}


def break_(files, kind, candidates, rng):
    """One of the candidates broken in this way, or None if none of them can be."""
    for file in rng.sample(candidates, len(candidates)):
        change = kindsOf(file).get(kind)
        for _ in range(20 if change else 0):
            entry = rng.choice(entriesOf(files[file])) if kind in ENTRY_BREAKS else None
            text = change(files[file], entry, rng) if entry else change(files[file], rng)
            if text is NO_FILE:
                return Broken({name: old for name, old in files.items() if name != file}, file, kind, "")
            if text is not None and text != files[file]:
                return Broken({**files, file: text}, file, kind, entry.name if entry else "")
    return None


def put(files, folder):
    fresh(folder)
    for name, content in files.items():
        write(folder/name, content)
