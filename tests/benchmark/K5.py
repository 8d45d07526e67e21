# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""K5: discs that land, solved in their plane and as if in space."""

from leftOut import measured
from results import bars

table = measured("K5", [["skips", "planar"]])
bars(table, ["variant"], "msPerStep", "ms per step (processor)")
