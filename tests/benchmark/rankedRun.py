# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Programs run on several ranks, and cases cut for them."""

import os
import subprocess

# As root only where that is all there is.
ROOT_MAY = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def said(folder, *words, environment=()):
    """What a program printed."""
    run = subprocess.run(list(map(str, words)), cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         text=True, env={**os.environ, **ROOT_MAY, **dict(environment), "PWD": str(folder)})
    if run.returncode:
        raise SystemExit("%s failed in %s:\n%s" % (" ".join(map(str, words)), folder, run.stdout[-2000:]))
    return run.stdout


def setParts(case, parts):
    """For decomposePar: so many parts of the mesh along each axis."""
    (case/"system/decomposeParDict").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n"
        "numberOfSubdomains %d; method simple; simpleCoeffs { n (%d %d %d); delta 0.001; }\n" % (parts[0]*parts[1]*parts[2], *parts))
