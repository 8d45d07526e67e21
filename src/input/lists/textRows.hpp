// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files of rows: numbers separated by blanks or commas; # begins a comment.
#pragma once

#include "input/dictionary/inputError.hpp"

#include <functional>
#include <string>
#include <vector>

namespace input
{

/// Refuses a text with zeros in it, which end it for whoever reads it in place.
void checkIsText(const std::string& text, const std::string& path);

/// A number at the start of a text, whose end is then behind it; false for anything else, and for numbers that are too large.
bool takeNumber(const char*& at, double& number);

/// The same behind blanks and commas, with blanks, commas or the end behind it.
bool takeColumn(const char*& at, double& number);

/// Moves behind blanks and commas.
void skipSeparators(const char*& at);

/// Calls `read` for every line that holds more than blanks, commas and a comment, without its comment.
/// Errors: InputError with that of `source`, where the file was asked for, where it cannot be read
void forEachRow
(
    const std::string& path, const Place& source, const std::function<void(const std::string& line, const Place& place)>& read
);

struct NumberRow
{
    std::vector<double> values;
    Place place;
};

/// Rows of as many numbers as `columns` names.
/// Errors: InputError with file and line for other rows; with that of `source` for a file without rows
std::vector<NumberRow> readNumberTable(const std::string& path, const Words& columns, const Place& source);

} // namespace input
