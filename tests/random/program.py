# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Running a program under limits, and how it ended."""

import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

MEMORY = 6 << 20  # kB a process may have; a broken number must not take the machine down
STACK = re.compile(r"^#\d+ ", re.M)
SANITIZER = re.compile(r"runtime error:|AddressSanitizer|LeakSanitizer")


class Outcome:
    """How a program ended: `status` None where it was stopped after its time."""

    def __init__(self, status, log):
        self.status, self.log = status, log

    @property
    def crash(self):
        """`hang`, `signal`, or None: an end of its own will."""
        if self.status is None:
            return "hang"
        if self.status < 0 or self.status > 128 or STACK.search(self.log) or SANITIZER.search(self.log):
            return "signal"
        return None

    @property
    def error(self):
        """What the log says was wrong, or its end."""
        for start in ("--> FOAM FATAL", "nscdGrains: "):
            if start in self.log:
                return self.log[self.log.rfind(start) if start.startswith("-->") else self.log.find(start):]
        return self.log[-600:]


def find(name):
    path = shutil.which(name)
    if not path:
        sys.exit(f"{name} is not on the PATH: build it, and source etc/bashrc")
    return path


def run(command, folder, seconds):
    """Runs to the end, or is killed with its children after so many seconds."""
    limited = ["bash", "-c", f'ulimit -v {MEMORY} -c 0; exec "$@"', "bash", *command]
    process = subprocess.Popen(limited, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               start_new_session=True, env={**os.environ, "PWD": str(folder)})
    try:
        log, status = process.communicate(timeout=seconds)[0], process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        log, status = process.communicate()[0], None
    return Outcome(status, log.decode("utf-8", "replace"))


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    Path(folder).mkdir(parents=True)
    return Path(folder)


def write(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content if isinstance(content, bytes) else content.encode())


def oneLine(text, length=200):
    return re.sub(r"\s+", " ", text).strip()[:length]
