// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Messages about scenes.
#include "sceneError.hpp"

#include "nscd/base/nearestWord.hpp"

namespace nscdGrains
{

namespace
{

std::string joined(const Words& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

} // namespace

void fail(const Mistake& mistake)
{
    const Place& place = mistake.place;
    std::string text = place.file;
    if (place.line > 0) text += ", line " + std::to_string(place.line);
    text += ": ";
    if (!place.keyword.empty()) text += "keyword " + place.keyword + " ";
    text += mistake.problem;
    if (!mistake.value.empty()) text += "\n  value:   " + mistake.value;
    if (!mistake.allowed.empty()) text += "\n  allowed: " + mistake.allowed;
    else if (!mistake.words.empty()) text += "\n  allowed: " + joined(mistake.words);
    const std::string nearest = nscd::nearestWord(mistake.value, mistake.words);
    if (!nearest.empty()) text += "\n  nearest: " + nearest;
    throw SceneError(text);
}

} // namespace nscdGrains
