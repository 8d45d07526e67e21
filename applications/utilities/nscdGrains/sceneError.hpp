// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Complaints about a scene: where, what is wrong, what would be right.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace nscdGrains
{

using Words = std::vector<std::string>;

/// Where something was said.
struct Place
{
    std::string file;
    int line = 0;          ///< 0: no line in particular
    std::string keyword;   ///< with the names of the dictionaries around it, as grains.bed.diameter
};

/// A user's mistake.
struct Mistake
{
    Place place;
    std::string problem;   ///< what follows the keyword, as "is out of range"
    std::string value;     ///< as written
    std::string allowed;   ///< where it is not a list of words
    Words words = {};      ///< the words allowed; the nearest one to `value` is named
};

class SceneError : public std::invalid_argument
{
public:
    using std::invalid_argument::invalid_argument;
};

/// Throws SceneError with all that a mistake says.
[[noreturn]] void fail(const Mistake& mistake);

/// Values as text, one after the other; numbers in few digits.
template<class... Values>
std::string textOf(const Values&... values)
{
    std::ostringstream text;
    (text << ... << values);
    return text.str();
}

} // namespace nscdGrains
