// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Messages about what a user wrote.
#include "input/dictionary/inputError.hpp"

#include "nscd/base/nearestWord.hpp"

namespace input
{

namespace
{

std::string describe(const Place& place)
{
    return place.file + (place.line > 0 ? ", line " + std::to_string(place.line) : "") + ": ";
}

} // namespace

std::string joined(const Words& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string describe(const Mistake& mistake)
{
    const std::string& keyword = mistake.place.keyword;
    std::string text = (keyword.empty() ? "" : "keyword " + keyword + " ") + mistake.problem;
    if (!mistake.value.empty()) text += "\n  value:   " + mistake.value;
    if (!mistake.allowed.empty()) text += "\n  allowed: " + mistake.allowed;
    else if (!mistake.words.empty()) text += "\n  allowed: " + joined(mistake.words);
    const std::string nearest = nscd::nearestWord(mistake.value, mistake.words);
    return nearest.empty() ? text : text + "\n  nearest: " + nearest;
}

InputError::InputError(const Mistake& mistake)
:
    std::runtime_error(describe(mistake.place) + describe(mistake)),
    mistake_(mistake)
{}

} // namespace input
