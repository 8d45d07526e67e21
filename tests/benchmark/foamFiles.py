# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Reads OpenFOAM's lists of numbers, in ASCII or in binary of doubles, and changes entries of its dictionaries."""

import re
import struct


def readNumbers(path, width):
    """A list of scalars (width 1) or vectors (width 3), as a flat list of floats."""
    with open(path, "rb") as file:
        content = file.read()
    headEnd = content.index(b"}") + 1
    uniform = re.match(rb"(?:\s|//[^\n]*\n)*(\d+)\s*\{([^}]*)\}", content[headEnd:])
    if uniform:
        return int(uniform.group(1))*[float(word) for word in uniform.group(2).strip(b"( )").split()]
    start = re.compile(rb"(?:\s|//[^\n]*\n)*(\d+)\s*\(").match(content, headEnd)
    count = width*int(start.group(1))
    if b"binary" in content[:headEnd]:
        return list(struct.unpack_from("<%dd" % count, content, start.end()))
    return [float(word) for word in re.findall(rb"[^\s()]+", content[start.end():])[:count]]


def setEntry(path, keyword, value):
    """Puts `value` in the place of what a keyword at the start of a line has."""
    with open(path) as file:
        text = file.read()
    text, count = re.subn(r"^(\s*%s\s+)[^;]*;" % keyword, r"\g<1>%s;" % value, text, flags=re.M)
    if count != 1:
        raise ValueError("%s has %d entries %s, not one" % (path, count, keyword))
    with open(path, "w") as file:
        file.write(text)


def firstEntry(path, keyword):
    with open(path) as file:
        found = re.search(r"^\s*%s\s+([^;]*);" % keyword, file.read(), flags=re.M)
    return found.group(1)
