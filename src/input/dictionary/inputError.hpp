// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Complaints about what a user wrote: where, what is wrong, what would be right.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace input
{

using Words = std::vector<std::string>;

/// Where something was said.
struct Place
{
    std::string file;
    int line = 0;               ///< 0: no line in particular
    std::string keyword = {};   ///< with the names of the dictionaries around it, as grains.bed.diameter
};

/// A user's mistake. Empty parts are left out of the message.
struct Mistake
{
    Place place;
    std::string problem;        ///< what follows the keyword, as "is out of range"
    std::string value = {};     ///< as written
    std::string allowed = {};   ///< where it is not a list of words
    Words words = {};           ///< the words allowed; the nearest one to `value` is named
};

/// Words with commas between them.
std::string joined(const Words& words);

/// Keyword, problem, value, what is allowed and the nearest word, a line each; without file and line number.
std::string describe(const Mistake& mistake);

/// What the readers throw; what() names file and line too.
class InputError : public std::runtime_error
{
public:
    explicit InputError(const Mistake& mistake);
    const Mistake& mistake() const { return mistake_; }

private:
    Mistake mistake_;
};

/// Values as text, one after the other; numbers in few digits.
template<class... Values>
std::string textOf(const Values&... values)
{
    std::ostringstream text;
    (text << ... << values);
    return text.str();
}

} // namespace input
