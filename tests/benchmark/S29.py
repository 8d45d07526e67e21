# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""S29: a million grains at a volume fraction of 1e-3, hardly any touching."""

from leftOut import measured
from results import bars

table = measured("S29", [["skips", "cloud"]])
bars(table, ["variant"], "msPerStep", "ms per step (processor)")
