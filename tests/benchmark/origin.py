#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Where and from what figures were measured, in one line: date, commit, processor, its load, compiler, versions of OpenFOAM and of the peers."""

import datetime
import os
import re
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Programs that ours are compared with, and their packages of Debian.
PEERS = {"OpenFOAM": ("pimpleFoam", "openfoam"), "LIGGGHTS": ("liggghts", "liggghts"), "LAMMPS": ("lmp", "lammps"), "Yade": ("yade", "yade"),
         "Siconos": ("siconos", "python3-siconos")}


def said(*words):
    """What a program printed; nothing where it is not there or fails."""
    if shutil.which(words[0]) is None:
        return ""
    return subprocess.run(words, cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.strip()


def processor():
    found = re.search(r"^model name\s*:\s*(.*)$", Path("/proc/cpuinfo").read_text(), flags=re.M)
    return " ".join(found.group(1).split()) if found else os.uname().machine


def machine():
    """A short name for folders: BENCHMARK_MACHINE, or the processor's model in one word."""
    words = re.sub(r"\((R|TM)\)|@.*|\b(CPU|Processor|Intel|AMD|\d+-Core)\b", " ", processor(), flags=re.I).split()
    name = "".join(word.capitalize() for word in re.sub(r"[^\w]+", " ", " ".join(words)).split())
    return os.environ.get("BENCHMARK_MACHINE") or name[:1].lower() + name[1:]


def commit():
    """Of the tree, and whether anything in it but figures was changed since."""
    figures = (":!tests/accuracy/figures", ":!tests/accuracy.md", ":!tests/benchmark/results")
    changed = said("git", "status", "--porcelain", "--untracked-files=no", "--", ".", *figures)
    return "commit %s%s" % (said("git", "rev-parse", "--short", "HEAD") or "unknown", " and changes" if changed else "")


def compiler():
    return (said(os.environ.get("CXX", "c++"), "--version").splitlines() or ["no compiler"])[0]


def peer(name):
    program, package = PEERS[name]
    version = said("dpkg-query", "-W", "-f", "${Version}", package)
    if name == "OpenFOAM":
        version = os.environ.get("WM_PROJECT_VERSION", version)
    return "%s %s" % (name, version or ("of unknown version" if shutil.which(program) else "not installed"))


def origin():
    """The load at the start tells whether the cores were free."""
    load = "load %.1f on %d cores" % (os.getloadavg()[0], os.cpu_count())
    return ", ".join([datetime.date.today().isoformat(), commit(), processor(), load, compiler(), *map(peer, PEERS)])


if __name__ == "__main__":
    print(origin())
