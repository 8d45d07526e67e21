# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases read back, and small ones in a box written and run, for validation programs and tutorials."""

import csv
import glob
import os
import re
import shutil
import struct
import subprocess
import sys

SCHEMES = """
ddtSchemes           { default Euler; }
gradSchemes          { default Gauss linear; }
divSchemes           { default Gauss linear; div(phi,U) Gauss linearUpwindV grad(U); }
laplacianSchemes     { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes        { default corrected; }
"""

SOLUTION = """
solvers
{
    "p_rgh.*|meanFlowPotential.*" { solver PCG; preconditioner DIC; tolerance %g; relTol 0; }
    "U.*" { solver PBiCGStab; preconditioner DILU; tolerance %g; relTol 0; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 3; pRefCell 0; pRefValue 0; }
"""

FACES = {"xMin": "(0 4 7 3)", "xMax": "(1 2 6 5)", "yMin": "(0 1 5 4)", "yMax": "(3 7 6 2)", "zMin": "(0 3 2 1)", "zMax": "(4 5 6 7)"}
OPPOSITE = {"xMin": "xMax", "xMax": "xMin", "yMin": "yMax", "yMax": "yMin", "zMin": "zMax", "zMax": "zMin"}


def vec(values):
    return "(%.17g %.17g %.17g)" % tuple(values)


def rowsOfTable(lines):
    """Names and rows of a table whose names stand in its last line of comments."""
    lines = list(lines)
    names = ([line for line in lines if line.startswith("#")] or [""])[-1].lstrip("#").split()
    return [[name.split("[")[0] for name in names]] + [line.split() for line in lines if line.strip() and not line.startswith("#")]


def whenStarted(path):
    """Order of tables in postProcessing/NAME/START: by time, then as they were written."""
    return float(path.split("/")[-2]), os.path.getmtime(path)


class CaseFolder:
    """A case that ran, read back."""

    def __init__(self, folder):
        self.folder = os.path.abspath(folder)

    def report(self):
        """Columns of report.csv as lists of floats: of the run and the restarts that continued it, one after another."""
        return self.columns("grains/report.csv", lambda lines: list(csv.reader(line for line in lines if not line.startswith("#"))))

    def series(self, table):
        """The same of a table of a function object, NAME/FILE, by the names in its last line of comments, units left out."""
        return self.columns(table, rowsOfTable)

    def columns(self, table, rowsOf):
        """Columns by names of a table NAME/FILE in postProcessing/NAME/START; rowsOf: names and rows, of its lines. Time is the first column.

        Where a run starts again at the same time OpenFOAM leaves FILE alone, and writes FILE_START beside it."""
        name, file = table.split("/")
        rows = []
        for path in sorted(glob.glob("%s/postProcessing/%s/*/%s" % (glob.escape(self.folder), name, file.replace(".", "*."))), key=whenStarted):
            with open(path) as lines:
                names, *words = rowsOf(lines) or [[]]
            # A run that was stopped may leave half a row.
            added = [dict(zip(names, map(float, row))) for row in words if len(row) == len(names)]
            if added:   # a run started at its end writes no row
                rows = [row for row in rows if row[names[0]] < added[0][names[0]]] + added
        return {key: [row[key] for row in rows] for key in rows[0]}

    def log(self, program="nscdDEMFoam"):
        """Of the last run."""
        with open(os.path.join(self.folder, "log." + program)) as file:
            return file.read()

    def times(self):
        return sorted((name for name in os.listdir(self.folder) if re.fullmatch(r"[0-9.e+-]+", name)), key=float)

    def cloud(self, name, time=None, cloud="grains"):
        """A field of lagrangian/grains (or contacts) at a written time (the last one): list of floats or of triples."""
        return readList(os.path.join(self.folder, time or self.times()[-1], "lagrangian", cloud, name))

    def fieldValues(self, name, time=None):
        """Internal values of a field at a written time (the last one)."""
        return readList(os.path.join(self.folder, time or self.times()[-1], name))


class WrittenCase(CaseFolder):
    """A case that is written anew and run, on a mesh of its own `system/blockMeshDict`."""

    def __init__(self, folder):
        super().__init__(folder)
        self.remove()
        for part in ("0", "constant", "system"):
            os.makedirs(os.path.join(self.folder, part))
        self.write("system/fvSchemes", SCHEMES)
        self.write("system/fvSolution", SOLUTION % (1e-13, 1e-14))
        self.write("constant/turbulenceProperties", "simulationType laminar;")

    def remove(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def write(self, path, body, foamClass="dictionary"):
        name = os.path.basename(path)
        head = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n" % (foamClass, name)
        os.makedirs(os.path.dirname(os.path.join(self.folder, path)), exist_ok=True)
        with open(os.path.join(self.folder, path), "w") as file:
            file.write(head + body + "\n")

    def gravity(self, g):
        self.write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value %s;" % vec(g), "uniformDimensionedVectorField")

    def grains(self, text):
        self.write("constant/grainProperties", text)

    def table(self, rows, name="grains.dat"):
        """Positions and diameters, one grain a row."""
        with open(os.path.join(self.folder, "constant", name), "w") as file:
            for row in rows:
                file.write(" ".join("%.17g" % value for value in row) + "\n")

    def control(self, deltaT, endTime, writeInterval=None, extra="", startFrom="latestTime"):
        self.write("system/controlDict", "application nscdDEMFoam; startFrom %s; startTime 0; stopAt endTime; endTime %.17g; "
                   "deltaT %.17g; writeControl adjustableRunTime; writeInterval %.17g; writeFormat ascii; writePrecision 17; "
                   "timePrecision 12;\n%s" % (startFrom, endTime, deltaT, writeInterval or endTime, extra))

    def run(self, program="nscdDEMFoam", mesh=True):
        if mesh and not os.path.exists(os.path.join(self.folder, "constant/polyMesh/faces")):
            self.call("blockMesh")
        self.call(program)
        return self

    def call(self, program, *options):
        log = os.path.join(self.folder, "log." + program)
        with open(log, "w") as file:
            status = subprocess.call([program, *options], cwd=self.folder, stdout=file, stderr=subprocess.STDOUT,
                                     env=dict(os.environ, PWD=self.folder))
        if status != 0:
            with open(log) as file:
                sys.stdout.write("".join(file.readlines()[-25:]))
            sys.exit("%s failed in %s" % (program, self.folder))


class MeshedCase(WrittenCase):
    """A case whose mesh a class of its own writes; `types` gives each patch's type: cyclic, wall, patch, symmetry or empty."""

    def __init__(self, folder, types):
        super().__init__(folder)
        self.types = types

    def fluid(self, rho, mu, gravity=(0, 0, -9.81), U=(0, 0, 0), sides=None, pressureSides=None):
        """Fields; `sides` and `pressureSides` give a boundary entry by patch for U and p_rgh where the default is not meant."""
        self.write("constant/transportProperties", "transportModel Newtonian; nu %.17g; rho %.17g;" % (mu/rho, rho))
        self.gravity(gravity)
        velocity = {"cyclic": "type cyclic;", "empty": "type empty;", "symmetry": "type symmetry;", "wall": "type noSlip;",
                    "patch": "type zeroGradient;"}
        pressure = {"cyclic": "type cyclic;", "empty": "type empty;", "symmetry": "type symmetry;",
                    "wall": "type fixedFluxPressure; value uniform 0;", "patch": "type fixedValue; value uniform 0;"}
        self.field("U", "volVectorField", "[0 1 -1 0 0 0 0]", vec(U), velocity, sides or {})
        self.field("p_rgh", "volScalarField", "[1 -1 -2 0 0 0 0]", "0", pressure, pressureSides or {})

    def field(self, name, foamClass, dimensions, value, byType, bySide):
        entries = "".join("%s { %s }\n" % (side, bySide.get(side, byType[kind])) for side, kind in self.types.items())
        self.write("0/" + name, "dimensions %s;\ninternalField uniform %s;\nboundaryField\n{\n%s}" % (dimensions, value, entries), foamClass)


class BoxCase(MeshedCase):
    """A box of cells; `patches` gives each side's type (default: cyclic)."""

    def __init__(self, folder, lower, upper, cells, patches=None, grading=(1, 1, 1)):
        super().__init__(folder, {**{side: "cyclic" for side in FACES}, **(patches or {})})
        self.lower, self.upper, self.cells, self.grading = lower, upper, cells, grading
        self.writeMesh()

    def writeMesh(self):
        lo, up = self.lower, self.upper
        corners = [(lo[0], lo[1]), (up[0], lo[1]), (up[0], up[1]), (lo[0], up[1])]
        vertices = " ".join(vec((x, y, z)) for z in (lo[2], up[2]) for x, y in corners)
        sides = ""
        for side, faces in FACES.items():
            neighbor = "neighbourPatch %s; " % OPPOSITE[side] if self.types[side] == "cyclic" else ""
            sides += "%s { type %s; %sfaces (%s); }\n" % (side, self.types[side], neighbor, faces)
        self.write("system/blockMeshDict", "vertices (%s);\nblocks (hex (0 1 2 3 4 5 6 7) (%d %d %d) simpleGrading (%s %s %s));\n"
                   "boundary\n(\n%s);" % ((vertices,) + tuple(self.cells) + tuple(self.grading) + (sides,)))


WIDTHS = {b"scalarField": "d", b"vectorField": "3d", b"labelField": "i", b"scalar": "d", b"vector": "3d"}
BLANKS = rb"(?:\s|//[^\n]*\n)*"


def binaryList(content):
    """(layout, start) of the values of a cloud's or a mesh's field written in binary; None for others."""
    head = content.index(b"}") + 1
    if b"binary" not in content[:head]:
        return None
    bare = re.compile(BLANKS + rb"(\d+)\s*\(").match(content, head)
    if bare:
        return WIDTHS[re.search(rb"class\s+(\w+)", content[:head]).group(1)], bare
    ofMesh = re.compile(rb"internalField\s+nonuniform\s+List<(\w+)>\s*(\d+)\s*\(").search(content, head)
    return (WIDTHS[ofMesh.group(1)], ofMesh) if ofMesh else None


def readBinary(content, layout, start):
    count = int(start.group(start.lastindex))
    values = struct.iter_unpack("<" + layout, content[start.end():start.end() + count*struct.calcsize("<" + layout)])
    return [value if len(value) > 1 else value[0] for value in values]


def readList(path):
    with open(path, "rb") as file:
        content = file.read()
    binary = binaryList(content)
    if binary:
        return readBinary(content, *binary)
    text = content.decode(errors="replace")
    text = text[text.index("}") + 1:]
    uniform = re.search(r"internalField\s+uniform\s+(\([^)]*\)|\S+);", text)
    if uniform:
        return values("(" + uniform.group(1) + ")")
    start = re.search(r"(?:^|\s)(\d+)\s*([({])", text)
    if not start:
        return []
    count = int(start.group(1))
    if start.group(2) == "{":
        return count*values("(" + text[start.end():text.index("}", start.end())] + ")")
    body = text[start.end():]
    if body.lstrip().startswith("("):
        triples = re.finditer(r"\(([^()]*)\)", body)
        return [tuple(float(number) for number in next(triples).group(1).split()) for _ in range(count)]
    return values("(" + body[:body.index(")")] + ")")


def values(text):
    """Numbers or triples between the outer parentheses."""
    inner = text.strip()[1:-1].strip()
    if not inner.startswith("("):
        return [float(number) for number in inner.split()]
    return [tuple(float(number) for number in part.split()) for part in re.findall(r"\(([^()]*)\)", inner)]


class FigureTable:
    """Rows of figures in the folder that ACCURACY_FOLDER names, if it names one, as tests/accuracy/figures.hpp writes those of C++: the table
    is named after the validation case, and begun anew."""

    def __init__(self):
        folder = os.environ.get("ACCURACY_FOLDER")
        name = os.path.basename(os.path.dirname(os.path.abspath(sys.argv[0])))
        self.file = open(os.path.join(folder, name + ".csv"), "w", newline="") if folder else None
        if self.file:
            self.file.write("# SPDX-License-Identifier: GPL-3.0-or-later\n# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors\n")
            self.file.write("# origin: %s\n# larger is worse: error\n" % os.environ.get("ACCURACY_ORIGIN", "not stated"))
            self.row("scene", "quantity", "reference", "error", "ours", "bar")

    def row(self, *values):
        if self.file:
            csv.writer(self.file, lineterminator="\n").writerow(values)
            self.file.flush()


class Verdict:
    """Figures with their tolerances; ends the program with status 1 when one is out. What a figure is called begins with the name of its
    case, if it has one, and ends with the quantity behind a colon."""

    def __init__(self):
        self.failed = 0
        self.count = 0
        self.table = FigureTable()

    def near(self, what, value, reference, tolerance, relative=True):
        error = abs(value - reference)
        scale, size = (abs(reference) if relative else 1.0), (abs(reference) or 1.0)
        self.judge(what, error/scale, tolerance, "%.8g for %.8g" % (value, reference))
        self.row(what, "%.9g" % reference, "%.9g" % value, error/size, tolerance*scale/size)

    def below(self, what, error, tolerance, detail=""):
        self.judge(what, error, tolerance, detail)
        self.row(what, "", "", error, tolerance)

    def judge(self, what, error, tolerance, detail):
        good = error <= tolerance
        self.count += 1
        self.failed += not good
        print("%-4s %-58s %.3g <= %.3g  %s" % ("ok" if good else "BAD", what, error, tolerance, detail))

    def row(self, what, reference, ours, error, bar):
        scene, _, quantity = what.rpartition(": ")
        self.table.row(scene, quantity, reference, "%.3g" % error, ours, "%.9g" % bar)

    def finish(self):
        print("%d of %d within tolerance" % (self.count - self.failed, self.count))
        sys.exit(1 if self.failed or not self.count else 0)
