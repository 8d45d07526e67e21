# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""K4: a still bed of 10 000 spheres: sweeps a step, lists built, and what is left when it may sleep."""

from coreRun import bed
from leftOut import measured
from results import bars

table = measured("K4", [["skips", "still", bed(20, 25)]])
bars(table, ["variant"], "msPerStep", "ms per step (processor)")
