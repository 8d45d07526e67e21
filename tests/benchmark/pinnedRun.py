# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Programs run on one core and timed by the processor seconds that they used."""

import os
import subprocess
import sys
import time
from collections import namedtuple

Cost = namedtuple("Cost", "cpu wall")


CORE = int(os.environ.get("BENCHMARK_CORE", "0"))


def pinned(program, folder, core=CORE, log=None, arguments=(), environment=()):
    """Seconds of one run: of the processor (user and system, which other programs on the core do not change much) and of the clock."""
    log = os.path.join(folder, log or "log." + program)
    start = time.time()
    with open(log, "w") as file:
        process = subprocess.Popen(["taskset", "-c", str(core), program, *map(str, arguments)], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=file, stderr=subprocess.STDOUT, env=dict(os.environ, PWD=os.path.abspath(folder), **dict(environment)))
        _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        with open(log) as file:
            sys.stdout.write("".join(file.readlines()[-25:]))
        sys.exit("%s failed; all it said is in %s" % (program, log))
    return Cost(usage.ru_utime + usage.ru_stime, time.time() - start)
