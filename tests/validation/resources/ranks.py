# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases cut by decomposePar and run on several ranks, by the commands that a user has; what all processors wrote, put together."""

import os
import shutil
import subprocess
import sys

from foamCase import CaseFolder, readList

# In a container without users, everybody is root.
ROOT_MAY = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def status(case, *words, log=None):
    """Runs a program in the case; its output in log.<name>."""
    with open(os.path.join(case.folder, "log." + (log or words[0])), "w") as file:
        return subprocess.call(words, cwd=case.folder, stdout=file, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                               env=dict(os.environ, **ROOT_MAY, PWD=case.folder), timeout=600)


def logOf(case, log):
    with open(os.path.join(case.folder, "log." + log), errors="replace") as file:
        return file.read()


def command(case, *words, log=None):
    """A program that must succeed."""
    if status(case, *words, log=log) != 0:
        print("".join(logOf(case, log or words[0]).splitlines(True)[-25:]))
        sys.exit("%s failed in %s" % (" ".join(words), case.folder))


def launcher(ranks, program="nscdDEMFoam", *options):
    """Words that start a program on more ranks than there may be cores."""
    return ("mpirun", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1", "-np", str(ranks), program, "-parallel") + options


def copied(case, name, times=("0",)):
    """The case with some of its times, beside it under another name."""
    folder = os.path.join(os.path.dirname(case.folder), name)
    shutil.rmtree(folder, ignore_errors=True)
    for part in ("constant", "system") + tuple(times):
        shutil.copytree(os.path.join(case.folder, part), os.path.join(folder, part))
    return CaseFolder(folder)


def decompose(case, ranks, method, entries="", cellRanks=None, options=()):
    """Cuts the mesh by a method of decomposePar; `manual` takes the rank of each cell."""
    head = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"
    with open(os.path.join(case.folder, "system/decomposeParDict"), "w") as file:
        file.write(head % ("dictionary", "decomposeParDict") + "numberOfSubdomains %d; method %s;\n%s\n" % (ranks, method, entries)
                   + "manualCoeffs { dataFile \"cellRanks\"; }\n")
    if cellRanks:
        with open(os.path.join(case.folder, "constant/cellRanks"), "w") as file:
            file.write(head % ("labelList", "cellRanks") + "(%s)\n" % " ".join(map(str, cellRanks)))
    command(case, "decomposePar", *options)


def onRanks(case, program, ranks, log="ranks"):
    command(case, *launcher(ranks, program), log=log)


def gathered(case, field, ranks, time):
    """A field of a decomposed case in the order of the whole mesh's cells."""
    whole = {}
    for rank in range(ranks):
        part = os.path.join(case.folder, "processor%d" % rank)
        cells = readList(os.path.join(part, "constant/polyMesh/cellProcAddressing"))
        values = readList(os.path.join(part, time, field))
        whole.update(zip(map(int, cells), len(cells)*values if len(values) == 1 else values))
    return [whole[i] for i in range(len(whole))]


def differ(a, b):
    """Largest difference over the largest value."""
    n = max(len(a), len(b))
    a, b = [n*x if len(x) == 1 else x for x in (a, b)]
    flat = [[y for x in values for y in (x if isinstance(x, tuple) else (x,))] for values in (a, b)]
    return max(abs(x - y) for x, y in zip(*flat))/max(max(map(abs, flat[0])), 1e-300)
