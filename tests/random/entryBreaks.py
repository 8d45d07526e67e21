# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Ways to break an entry of a dictionary: each a function of text, entry and random numbers that returns new text, or None where it does
not apply."""

from dictionaryText import misspelt, splice

NUMBERS = {"nan": b"nan", "inf": b"inf", "-inf": b"-inf", "1e300": b"1e300", "1e999": b"1e999", "1e12": b"1e12", "0": b"0", "1e-300": b"1e-300",
           "a word": b"five", "a vector": b"(1 2 3)", "a comma": b"0,5", "hexadecimal": b"0x1G", "two": b"1 2", "none": b"", "a unit": b"5mm",
           "a string": b'"0.1"', "int64": b"99999999999999999999"}


def replaceKey(new):
    def apply(text, entry, rng):
        return splice(text, entry.key.start, entry.key.end, new(entry.key.text, rng))
    return apply


def replaceWhole(new):
    """The key stays."""
    def apply(text, entry, rng):
        return splice(text, entry.key.end, entry.end, new)
    return apply


def withDictionary(change):
    return lambda text, entry, rng: change(text, entry, rng) if entry.isDictionary else None


def withValue(change):
    return lambda text, entry, rng: change(text, entry, rng) if not entry.isDictionary and entry.values else None


def withNumber(new):
    """`new(token, rng)` in place of one of the numbers."""
    def apply(text, entry, rng):
        if not entry.numbers:
            return None
        token = rng.choice(entry.numbers)
        return splice(text, token.start, token.end, new(token.text, rng))
    return apply


def withWord(new):
    def apply(text, entry, rng):
        if not entry.words:
            return None
        token = rng.choice(entry.words)
        return splice(text, token.start, token.end, new(token.text, rng))
    return apply


def withList(new):
    """In place of the last bracket, and of the number before it where `new` says so."""
    def apply(text, entry, rng):
        if not entry.isList:
            return None
        last = entry.values[-1]
        return splice(text, last.start, last.end, new)
    return apply


def listTooShort(text, entry, rng):
    if not entry.isList or not entry.numbers:
        return None
    return splice(text, entry.numbers[-1].start, entry.numbers[-1].end, b"")


def dropEnd(text, entry, rng):
    return splice(text, entry.end - 1, entry.end, b"")


def values(new):
    return withValue(lambda text, entry, rng: splice(text, entry.values[0].start, entry.values[-1].end, new(rng)))


def garbage(rng):
    return bytes(rng.randrange(128, 256) for _ in range(12))


def otherSign(number, rng):
    return number[1:] if number.startswith(b"-") else b"-" + number


def twice(text, entry, rng):
    """The entry once more, with another number."""
    if not entry.numbers:
        return None
    whole = text[entry.key.start:entry.end]
    return splice(text, entry.end, entry.end, b"\n" + whole.replace(entry.numbers[0].text, b"7e77"))


def anyNumber(number, rng):
    """Of any size and sign."""
    return rng.choice([b"%s%.4g" % (rng.choice([b"", b"-"]), 10**rng.uniform(-12, 12)), b"%d" % rng.randint(-3, 12),
                       b"1e%d" % rng.randint(-320, 320), b"%.4g" % (float(number)*10**rng.gauss(0, 2))])


ENTRY_BREAKS = {
    "entry left out": lambda text, entry, rng: splice(text, entry.key.start, entry.end, b""),
    "misspelt key": replaceKey(misspelt),
    "key with an accent": replaceKey(lambda key, rng: key + "é".encode()),
    "brace missing": withDictionary(dropEnd),
    "number for dictionary": withDictionary(replaceWhole(b" 5;")),
    "empty dictionary": withDictionary(replaceWhole(b" {}")),
    "semicolon missing": withValue(dropEnd),
    "dictionary for value": withValue(replaceWhole(b" { a 1; }")),
    "misspelt word": withWord(lambda word, rng: misspelt(word.strip(b'"'), rng)),
    "number for word": withWord(lambda word, rng: b"-3"),
    "other sign": withNumber(otherSign),
    "fraction": withNumber(lambda number, rng: b"%.17g" % (float(number) + 0.5)),
    "any number": withNumber(anyNumber),
    "entry twice": twice,
    "empty list": withValue(lambda text, entry, rng: splice(text, entry.values[0].start, entry.values[-1].end, b"()") if entry.isList else None),
    "list too long": withList(b" 1 2 3 4)"),
    "list too short": listTooShort,
    "bracket missing": withList(b""),
    "garbage for value": values(garbage),
    "open brackets for value": values(lambda rng: b"(((("),
    **{"number: " + name: withNumber(lambda number, rng, new=new: new) for name, new in NUMBERS.items()},
}
