# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""K6: spheres without friction: normal impulses only, and with all directions and spins for a friction that is not felt."""

from leftOut import measured
from results import bars

table = measured("K6", [["skips", "smooth"]])
bars(table, ["variant"], "msPerStep", "ms per step (processor)")
