# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""S30: 1e5 steps of a static bed: what it creeps, and what a step costs."""

from coreRun import bed
from leftOut import measured
from results import bars

table = measured("S30", [["skips", "rest", bed(8, 15)]], ("sweepsPerStep", "msPerStep", "creep"))
bars(table, ["variant"], "msPerStep", "ms per step (processor)")
