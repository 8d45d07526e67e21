# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""S30: 1e5 steps of a static bed: what it creeps, and what a step costs."""

from coreRun import bed
from leftOut import bars, measured

table = measured("S30", [["skips", "rest", bed(8, 15)]])
bars(table, "S30", ["variant"], "msPerStep", "ms per step (processor)")
