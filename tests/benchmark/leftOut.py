# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Rows and pictures of build/core/benchmark/skips and detection: what scenes cost with and without what they do not need."""

from coreRun import rows, tableOf
from results import pyplot, savePicture


def measured(name, runs):
    """A table of the rows that programs printed: runs are lists of a program's name and its arguments."""
    return tableOf(name, [({}, rows(*run)) for run in runs])


def bars(table, name, labels, value, unit):
    """A bar for each row."""
    figure, axes = pyplot.subplots(figsize=(6, 1 + 0.4*len(table.rows)))
    texts = [" ".join(str(part) for part in row) for row in zip(*(table.column(label) for label in labels))]
    axes.barh(range(len(texts)), table.column(value))
    axes.set_yticks(range(len(texts)), texts)
    axes.invert_yaxis()
    axes.set_xlabel(unit)
    savePicture(figure, name)
