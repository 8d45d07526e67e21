// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Checking values as they are asked for.
#include "checkedEntries.hpp"

#include "nscd/base/nearestWord.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace nscdGrains
{

namespace
{

const Words switchWords = {"on", "off", "yes", "no", "true", "false"};
const char* const vectorForm = "three numbers in brackets, as (0 0 1)";

std::string valueText(const Entry* entry)
{
    std::string text;
    if (!entry) return text;
    for (const Token& token : entry->value)
    {
        text += (text.empty() ? "" : " ") + token.text;
        if (text.size() > 100) return text.substr(0, 100) + " ...";
    }
    return text;
}

bool isListed(const std::string& word, const Words& words) { return std::find(words.begin(), words.end(), word) != words.end(); }

} // namespace

bool Range::contains(double value) const
{
    return (includesLower ? value >= lower : value > lower) && (includesUpper ? value <= upper : value < upper);
}

std::string Range::describe() const
{
    std::string text = "a finite number";
    if (std::isfinite(lower)) text += textOf(includesLower ? " >= " : " > ", lower);
    if (std::isfinite(lower) && std::isfinite(upper)) text += " and";
    if (std::isfinite(upper)) text += textOf(includesUpper ? " <= " : " < ", upper);
    return text;
}

bool readNumber(const std::string& word, double& number)
{
    if (word.empty() || word.find_first_not_of("0123456789+-.eE") != std::string::npos) return false;
    char* end = nullptr;
    number = std::strtod(word.c_str(), &end);
    return *end == '\0' && std::isfinite(number);
}

bool CheckedEntries::found(const std::string& keyword) const
{
    if (!isListed(keyword, declared_)) declared_.push_back(keyword);
    return dict_.find(keyword) != nullptr;
}

Place CheckedEntries::place(const std::string& keyword) const
{
    const Entry* entry = dict_.find(keyword);
    return {dict_.place.file, entry ? entry->line : dict_.place.line, dict_.pathOf(keyword)};
}

void CheckedEntries::reject(const std::string& keyword, const std::string& problem, const std::string& allowed, const Words& words) const
{
    fail({place(keyword), problem, valueText(dict_.find(keyword)), allowed, words});
}

void CheckedEntries::failMissing(const std::string& keyword, const std::string& allowed) const
{
    Words others;
    for (const Entry& entry : dict_.entries)
    {
        if (!isListed(entry.keyword, declared_)) others.push_back(entry.keyword);
    }
    const std::string nearest = nscd::nearestWord(keyword, others);
    if (nearest.empty()) fail({place(keyword), "is missing", "", allowed, {}});
    fail({place(nearest), "is not a keyword here, and " + keyword + " is missing", nearest, allowed, {keyword}});
}

bool CheckedEntries::isDictionary(const std::string& keyword) const
{
    const Entry* entry = dict_.find(keyword);
    return entry && entry->dict;
}

const std::vector<Token>& CheckedEntries::tokens(const std::string& keyword, const std::string& allowed) const
{
    if (!found(keyword)) failMissing(keyword, allowed);
    const Entry& entry = *dict_.find(keyword);
    if (entry.dict) reject(keyword, "is a dictionary where a value belongs", allowed);
    if (entry.value.empty()) reject(keyword, "has no value", allowed);
    return entry.value;
}

double CheckedEntries::toNumber(const std::string& keyword, const Token& token, const Range& range) const
{
    double number = 0.0;
    if (token.kind != Token::Kind::word || !readNumber(token.text, number)) reject(keyword, "is not a finite number", range.describe());
    if (!range.contains(number)) reject(keyword, "is out of range", range.describe());
    return number;
}

double CheckedEntries::number(const std::string& keyword, const Range& range) const
{
    const std::vector<Token>& tokens = value(keyword);
    if (tokens.size() != 1) reject(keyword, "is not a single number (a missing semicolon?)", range.describe());
    return toNumber(keyword, tokens[0], range);
}

double CheckedEntries::number(const std::string& keyword, const Range& range, double defaultValue) const
{
    return found(keyword) ? number(keyword, range) : defaultValue;
}

long CheckedEntries::toInteger(const std::string& keyword, double number, long lower) const
{
    if (std::floor(number) != number || number > std::numeric_limits<int>::max())
    {
        reject(keyword, "is not a whole number", "a whole number >= " + std::to_string(lower));
    }
    return static_cast<long>(number);
}

long CheckedEntries::integer(const std::string& keyword, long lower) const
{
    return toInteger(keyword, number(keyword, atLeast(static_cast<double>(lower))), lower);
}

long CheckedEntries::integer(const std::string& keyword, long lower, long defaultValue) const
{
    return found(keyword) ? integer(keyword, lower) : defaultValue;
}

bool CheckedEntries::flag(const std::string& keyword, bool defaultValue) const
{
    if (!found(keyword)) return defaultValue;
    const std::string given = choice(keyword, switchWords);
    return given == "on" || given == "yes" || given == "true";
}

Vec3 CheckedEntries::toVec(const std::string& keyword, const std::vector<Token>& tokens, std::size_t first) const
{
    const bool hasBrackets = tokens.size() >= first + 5 && tokens[first].isMark('(') && tokens[first + 4].isMark(')');
    if (!hasBrackets) reject(keyword, "is not a vector", vectorForm);
    Vec3 result;
    for (int k = 0; k < 3; ++k) result[k] = toNumber(keyword, tokens[first + 1 + k], anyNumber());
    return result;
}

Vec3 CheckedEntries::vec(const std::string& keyword) const
{
    const std::vector<Token>& tokens = value(keyword);
    if (tokens.size() != 5) reject(keyword, "is not a vector", vectorForm);
    return toVec(keyword, tokens, 0);
}

Vec3 CheckedEntries::vec(const std::string& keyword, const Vec3& defaultValue) const
{
    return found(keyword) ? vec(keyword) : defaultValue;
}

std::array<Vec3, 2> CheckedEntries::twoVecs(const std::string& keyword) const
{
    const std::vector<Token>& tokens = value(keyword);
    if (tokens.size() != 10) reject(keyword, "does not hold two vectors", "vectors in a row, as (0 0 0) (1 1 1)");
    return {toVec(keyword, tokens, 0), toVec(keyword, tokens, 5)};
}

std::vector<Vec3> CheckedEntries::vecList(const std::string& keyword) const
{
    const std::vector<Token>& tokens = value(keyword);
    const bool isList = tokens.size() >= 7 && (tokens.size() - 2) % 5 == 0 && tokens[0].isMark('(') && tokens.back().isMark(')');
    if (!isList) reject(keyword, "is not a list of vectors", "as ((0 0 0) (1 0 0) (1 1 0))");
    std::vector<Vec3> result;
    for (std::size_t first = 1; first + 5 < tokens.size(); first += 5) result.push_back(toVec(keyword, tokens, first));
    return result;
}

std::array<double, 2> CheckedEntries::pair(const std::string& keyword) const
{
    const std::vector<Token>& tokens = value(keyword);
    if (tokens.size() != 4 || !tokens[0].isMark('(') || !tokens[3].isMark(')')) reject(keyword, "is not a pair", "two numbers, as (0 1)");
    return {toNumber(keyword, tokens[1], anyNumber()), toNumber(keyword, tokens[2], anyNumber())};
}

std::string CheckedEntries::choice(const std::string& keyword, const Words& allowed) const
{
    const std::vector<Token>& tokens = value(keyword);
    if (tokens.size() != 1 || !isListed(tokens[0].text, allowed)) reject(keyword, "is not one of the words allowed", "", allowed);
    return tokens[0].text;
}

std::string CheckedEntries::choice(const std::string& keyword, const Words& allowed, const std::string& defaultValue) const
{
    return found(keyword) ? choice(keyword, allowed) : defaultValue;
}

Words CheckedEntries::choices(const std::string& keyword, const Words& allowed, const Words& defaultValue) const
{
    if (!found(keyword)) return defaultValue;
    const std::vector<Token>& tokens = value(keyword);
    if (tokens.size() < 2 || !tokens[0].isMark('(') || !tokens.back().isMark(')')) reject(keyword, "is not a list of words", "", allowed);
    Words given;
    for (std::size_t k = 1; k + 1 < tokens.size(); ++k)
    {
        if (!isListed(tokens[k].text, allowed)) fail({place(keyword), "holds a word that is not allowed", tokens[k].text, "", allowed});
        given.push_back(tokens[k].text);
    }
    return given;
}

std::vector<long> CheckedEntries::integers(const std::string& keyword, long lower) const
{
    const std::string allowed = "whole numbers >= " + std::to_string(lower) + " in brackets, as (1 2 3)";
    const std::vector<Token>& given = tokens(keyword, allowed);
    if (given.size() < 3 || !given[0].isMark('(') || !given.back().isMark(')')) reject(keyword, "is not a list of numbers", allowed);
    std::vector<long> numbers;
    for (std::size_t k = 1; k + 1 < given.size(); ++k)
    {
        numbers.push_back(toInteger(keyword, toNumber(keyword, given[k], atLeast(static_cast<double>(lower))), lower));
    }
    return numbers;
}

std::string CheckedEntries::text(const std::string& keyword) const
{
    const std::vector<Token>& tokens = value(keyword);
    if (tokens.size() != 1 || tokens[0].kind == Token::Kind::mark || tokens[0].text.empty())
    {
        reject(keyword, "is not a word or a quoted string", keyword + " \"text\";");
    }
    return tokens[0].text;
}

std::string CheckedEntries::text(const std::string& keyword, const std::string& defaultValue) const
{
    return found(keyword) ? text(keyword) : defaultValue;
}

const Dictionary& CheckedEntries::sub(const std::string& keyword) const
{
    if (!found(keyword)) failMissing(keyword, "a dictionary, " + keyword + " { ... }");
    const Entry& entry = *dict_.find(keyword);
    if (!entry.dict) reject(keyword, "is not a dictionary", keyword + " { ... }");
    return *entry.dict;
}

Dictionary CheckedEntries::subOrEmpty(const std::string& keyword) const
{
    if (found(keyword)) return sub(keyword);
    Dictionary empty;
    empty.place = place(keyword);
    return empty;
}

void CheckedEntries::finish() const
{
    for (const Entry& entry : dict_.entries)
    {
        if (isListed(entry.keyword, declared_)) continue;
        fail({{dict_.place.file, entry.line, dict_.pathOf(entry.keyword)}, "is not a keyword here", entry.keyword, "", declared_});
    }
}

} // namespace nscdGrains
