// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking things up in dictionaries, and numbers in words.
#include "input/dictionary/dictionary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace input
{

const Entry* Dictionary::find(const std::string& keyword) const
{
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.keyword == keyword; });
    return found == entries.end() ? nullptr : &*found;
}

std::string Dictionary::pathOf(const std::string& keyword) const
{
    return place.keyword.empty() ? keyword : place.keyword + "." + keyword;
}

Place Dictionary::placeOf(const std::string& keyword) const
{
    const Entry* entry = find(keyword);
    return {place.file, entry ? entry->line : place.line, pathOf(keyword)};
}

bool readNumber(const std::string& word, double& number)
{
    if (word.empty() || word.find_first_not_of("0123456789+-.eE") != std::string::npos) return false;
    char* end = nullptr;
    number = std::strtod(word.c_str(), &end);
    return *end == '\0' && std::isfinite(number);
}

std::string asWritten(const std::vector<Token>& tokens)
{
    std::string text;
    for (const Token& token : tokens)
    {
        text += (text.empty() ? "" : " ") + token.text;
        if (text.size() > 100) return text.substr(0, 100) + " ...";
    }
    return text;
}

Mistake repeated(const Place& place, int firstLine)
{
    return {place, "is given twice, first in line " + std::to_string(firstLine), "", "once"};
}

} // namespace input
