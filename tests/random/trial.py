# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What came out of one random scene or broken input."""

from dataclasses import dataclass


@dataclass
class Trial:
    seed: int
    found: dict     # kind of finding: text; none: fine
    figures: dict   # numbers to count or to show the largest of
    what: str = ""  # of a broken input: what was broken
    seconds: float = 0.0
