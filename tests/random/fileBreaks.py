# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Ways to break a file as a whole, its tokens, the numbers of a table, a field of OpenFOAM: functions of text and random numbers that
return new text, None where they do not apply, or NO_FILE."""

import re

from dictionaryText import entriesOf, splice, tokensOf
from entryBreaks import NUMBERS

NO_FILE = object()


def cut(text, rng):
    return text[:int(rng.choice([0, 0.2, 0.5, 0.8, 0.95])*len(text))]


def randomBytes(number, rng):
    return bytes(rng.randrange(256) for _ in range(number))


def insert(text, rng, new):
    at = rng.randrange(len(text))
    return splice(text, at, at, new)


FILE_BREAKS = {
    "cut short": cut,
    "garbage bytes": lambda text, rng: insert(text, rng, randomBytes(40, rng)),
    "random file": lambda text, rng: randomBytes(400, rng),
    "NUL": lambda text, rng: insert(text, rng, b"\0"),
    "CRLF": lambda text, rng: text.replace(b"\n", b"\r\n"),
    "byte order mark": lambda text, rng: b"\xef\xbb\xbf" + text,
    "no-break spaces": lambda text, rng: text.replace(b" ", b"\xc2\xa0", 400),
    "UTF-16": lambda text, rng: text.decode("latin1").encode("utf-16"),
    "braces at the end": lambda text, rng: text + b"}"*50,
    "deep list": lambda text, rng: text + b"\nz " + b"("*200000,
    "deep dictionaries": lambda text, rng: text + b"\n" + b"z { "*100000,
    "long line": lambda text, rng: text + b"\nz " + b"9"*3000000 + b";",
    "no file": lambda text, rng: NO_FILE,
}


def twoTokens(text, rng):
    return sorted(rng.sample(tokensOf(text), 2), key=lambda token: token.start)


def exchanged(text, rng):
    a, b = twoTokens(text, rng)
    return text[:a.start] + b.text + text[a.end:b.start] + a.text + text[b.end:]


def elsewhere(text, rng):
    a, b = twoTokens(text, rng)
    return splice(splice(text, b.start, b.start, a.text + b" "), a.start, a.end, b"")


def repeated(text, rng):
    token = rng.choice(tokensOf(text))
    return splice(text, token.end, token.end, b" " + token.text)


def gone(text, rng):
    token = rng.choice(tokensOf(text))
    return splice(text, token.start, token.end, b"")


def copied(text, rng):
    """An entry, into another dictionary."""
    entries = entriesOf(text)
    into = [entry for entry in entries if entry.isDictionary]
    if not into:
        return None
    one, at = rng.choice(entries), rng.choice(into).end - 1
    return splice(text, at, at, text[one.key.start:one.end] + b" ")


def valueOfAnother(text, rng):
    plain = [entry for entry in entriesOf(text) if entry.values]
    if len(plain) < 2:
        return None
    one, other = rng.sample(plain, 2)
    return splice(text, one.values[0].start, one.values[-1].end, text[other.values[0].start:other.values[-1].end])


TOKEN_BREAKS = {"tokens exchanged": exchanged, "token elsewhere": elsewhere, "token repeated": repeated, "token gone": gone,
                "entry copied": copied, "value of another": valueOfAnother}


def rowNumber(text, rng):
    numbers = [token for token in tokensOf(text) if token.isNumber]
    token = rng.choice(numbers)
    return splice(text, token.start, token.end, rng.choice([b"-" + token.text, *NUMBERS.values()]))


def rowTwice(text, rng):
    line = rng.choice(text.splitlines(keepends=True))
    return text.replace(line, line + line, 1)


def rowShort(text, rng):
    line = rng.choice(text.splitlines(keepends=True))
    return text.replace(line, line.rsplit(None, 1)[0] + b"\n", 1) if len(line.split()) > 1 else None


TABLE_BREAKS = {"table: number": rowNumber, "table: row twice": rowTwice, "table: row short": rowShort}


def replaced(pattern, *news):
    def apply(text, rng):
        new = rng.choice(news)
        return re.sub(pattern, lambda found: new, text, count=1) if re.search(pattern, text) else None
    return apply


FIELD_BREAKS = {
    "field: dimensions": replaced(rb"dimensions \[[^\]]*\]", b"dimensions [0 0 0 0 0 0 0]", b"dimensions [0 1 -1]", b"dimensions [0 9 9 0 0 0 0]"),
    "field: class": replaced(rb"class vol\w+", b"class surfaceScalarField", b"class volTensorField"),
    "field: no header": replaced(rb"FoamFile \{[^}]*\}", b""),
    "field: size": replaced(rb"internalField uniform [^;]*;", b"internalField nonuniform List<scalar> 7(0 0 0 0 0 0 0);",
                            b"internalField nonuniform List<vector> -1();"),
    "field: not finite": replaced(rb"internalField uniform [^;]*;", b"internalField uniform nan;", b"internalField uniform (nan 0 0);"),
    "field: patch left out": replaced(rb"zMin \{[^}]*\}", b""),
}
