# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Rows of build/core/benchmark/skips and detection: what scenes cost with and without what they do not need."""

from coreRun import rows, tableOf


def measured(name, runs, larger=("sweepsPerStep", "msPerStep")):
    """A table of the rows that programs print: runs are lists of a program's name and its arguments."""
    return tableOf(name, lambda: [({}, rows(*run)) for run in runs], larger=larger)
