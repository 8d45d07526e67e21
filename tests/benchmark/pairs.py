# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Contacts of a dilute gas: isolated ones solved once beside the sweeps, or all by sweeps."""

from leftOut import bars, measured

table = measured("pairs", [["skips", "pairs"]])
bars(table, "pairs", ["variant"], "solveMs", "ms per solve (processor)")
