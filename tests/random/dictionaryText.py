# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Tokens and entries of dictionary text, as bytes with their places, for who wants to break it."""

import re
from dataclasses import dataclass

TOKEN = re.compile(rb'//[^\n]*|/\*.*?\*/|"[^"]*"|[(){};\[\]]|[^\s(){};\[\]"]+', re.S)
NUMBER = re.compile(rb"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
WORD = re.compile(rb'"?[A-Za-z_.#$]')


@dataclass
class Token:
    start: int
    end: int
    text: bytes

    @property
    def isNumber(self):
        return bool(NUMBER.fullmatch(self.text))

    @property
    def isWord(self):
        return bool(WORD.match(self.text)) and not self.isNumber


@dataclass
class Entry:
    """`key values;` or `key { ... }`; `path`: keys of the dictionaries around it."""
    path: list
    key: Token
    values: list
    end: int
    isDictionary: bool

    @property
    def name(self):
        return ".".join(self.path + [self.key.text.decode("latin1")])

    @property
    def numbers(self):
        return [token for token in self.values if token.isNumber]

    @property
    def words(self):
        return [token for token in self.values if token.isWord]

    @property
    def isList(self):
        return bool(self.values) and self.values[0].text == b"("


def tokensOf(text):
    """Without comments, and without OpenFOAM's header."""
    found = [Token(m.start(), m.end(), m.group()) for m in TOKEN.finditer(text) if not m.group().startswith((b"//", b"/*"))]
    header = next((k for k, token in enumerate(found) if token.text == b"FoamFile"), None)
    if header is None:
        return found
    close = next(k for k in range(header, len(found)) if found[k].text == b"}")
    return found[:header] + found[close + 1:]


def entriesOf(text):
    entries, around, key, values, depth = [], [], None, [], 0
    for token in tokensOf(text):
        if token.text == b"}" and depth == 0:
            if around:
                around.pop().end = token.end
            key = None
        elif key is None:
            key, values = token, []
        elif token.text == b"{" and depth == 0:
            around.append(Entry([one.key.text.decode("latin1") for one in around], key, [], token.end, True))
            entries.append(around[-1])
            key = None
        elif token.text == b";" and depth == 0:
            entries.append(Entry([one.key.text.decode("latin1") for one in around], key, values, token.end, False))
            key = None
        else:
            depth += {b"(": 1, b"[": 1, b")": -1, b"]": -1}.get(token.text, 0)
            values.append(token)
    return entries


def splice(text, start, end, new):
    return text[:start] + new + text[end:]


def misspelt(word, rng):
    """Two neighboring letters exchanged, or one more."""
    at = rng.randrange(max(1, len(word) - 1))
    if len(word) > 1 and word[at] != word[at + 1]:
        return word[:at] + word[at + 1:at + 2] + word[at:at + 1] + word[at + 2:]
    return word[:at] + b"x" + word[at:]
