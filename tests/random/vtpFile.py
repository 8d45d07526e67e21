# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Arrays of the files that nscdGrains writes for ParaView."""

import re
import struct

LAYOUT = {b"Float64": "d", b"Int64": "q", b"Int32": "i"}


def readArray(path, name):
    """Values of an array: numbers, or tuples where it has components."""
    data = path.read_bytes()
    pattern = rb'type="(\w+)" Name="%s" NumberOfComponents="(\d+)"[^>]*offset="(\d+)"' % name.encode()
    kind, components, offset = re.search(pattern, data).groups()
    start = data.index(b"_", data.index(b"<AppendedData")) + 1 + int(offset)
    size = int.from_bytes(data[start:start + 8], "little")
    layout = "<%d%s" % (int(components), LAYOUT[kind])
    rows = struct.iter_unpack(layout, data[start + 8:start + 8 + size])
    return [row if len(row) > 1 else row[0] for row in rows]
