// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What OpenFOAM's own parser takes without a word, or stops at with a signal.
#pragma once

#include "input/dictionary/dictionary.hpp"

namespace input
{

/// Whether a keyword may stand twice in a dictionary, of which OpenFOAM then takes the last one.
enum class Repeats { refused, allowed };

/// Looks through the text of a dictionary that OpenFOAM is going to read. What a file includes, and what stands beside conditional
/// directives, is not looked at: a keyword may well be said there again.
/// Errors: InputError for a keyword given twice in one dictionary, for a semicolon missing before a dictionary, for numbers that no
///         computer holds (1e999), and for dictionaries nested too deep
void checkOpenFoamText(const std::string& text, const std::string& file, Repeats repeats = Repeats::refused);

/// Looks for numbers and braces alone, in any text: fields and lists are read at about a gigabyte a second.
/// Errors: InputError for a number that no computer holds, and for dictionaries nested too deep, with their line
void checkFieldText(const std::string& text, const std::string& file);

} // namespace input
