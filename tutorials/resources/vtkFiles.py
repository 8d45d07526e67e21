# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What nscdGrains writes, read back as numpy arrays."""

import re
import sys

import numpy as np

TYPES = {"Float64": "f8", "Int64": "i8", "Int32": "i4"}
ARRAY = re.compile(rb'<DataArray type="(\w+)" Name="(\w+)" NumberOfComponents="(\d)" format="appended" offset="(\d+)"/>')
MARK = b'<AppendedData encoding="raw">\n_'


def readVtp(path):
    """All arrays of a .vtp file by name."""
    with open(path, "rb") as file:
        content = file.read()
    head, data = content.split(MARK, 1)
    order = "<" if b"LittleEndian" in head else ">"
    arrays = {}
    for kind, name, components, offset in ARRAY.findall(head):
        start = int(offset)
        size = int(np.frombuffer(data, order + "u8", 1, start)[0])
        dtype = np.dtype(order + TYPES[kind.decode()])
        values = np.frombuffer(data, dtype, size//dtype.itemsize, start + 8)
        arrays[name.decode()] = values.reshape(-1, 3) if components == b"3" else values
    return arrays


def timesOf(series):
    """Times and files of a .pvd series."""
    with open(series) as file:
        found = re.findall(r'timestep="([^"]+)" file="([^"]+)"', file.read())
    if not found:
        sys.exit(series + " lists no time")
    return [(float(time), name) for time, name in found]


def readReport(path):
    """Columns of report.csv by name."""
    return np.genfromtxt(path, delimiter=",", names=True, skip_header=1)
