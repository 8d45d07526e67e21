// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Checking values as they are asked for.
#include "input/dictionary/checkedEntries.hpp"

#include "nscd/base/nearestWord.hpp"

#include <algorithm>
#include <cmath>

namespace input
{

namespace
{

const Words switchWords = {"on", "off", "yes", "no", "true", "false"};
const char* const vectorForm = "three numbers in brackets, as (0 0 1)";

bool isListed(const std::string& word, const Words& words) { return std::find(words.begin(), words.end(), word) != words.end(); }

bool isInBrackets(const std::vector<Token>& tokens) { return tokens.size() > 1 && tokens[0].isMark('(') && tokens.back().isMark(')'); }

} // namespace

std::string describe(const Vec3& vector) { return textOf("(", vector[0], " ", vector[1], " ", vector[2], ")"); }

bool CheckedEntries::found(const std::string& keyword) const
{
    if (!isListed(keyword, declared_)) declared_.push_back(keyword);
    return dict_.find(keyword) != nullptr;
}

void CheckedEntries::reject(const std::string& keyword, const std::string& problem, const std::string& allowed, const Words& words) const
{
    const Entry* entry = dict_.find(keyword);
    throw InputError({place(keyword), problem, entry ? asWritten(entry->value) : "", allowed, words});
}

std::string CheckedEntries::misspelt(const std::string& keyword) const
{
    Words others;
    for (const Entry& entry : dict_.entries)
    {
        if (!isListed(entry.keyword, declared_)) others.push_back(entry.keyword);
    }
    return nscd::nearestWord(keyword, others);
}

bool CheckedEntries::foundAsSpelt(const std::string& keyword) const
{
    if (found(keyword)) return true;
    const std::string nearest = misspelt(keyword);
    if (!nearest.empty()) throw InputError({place(nearest), "is not a keyword here", nearest, "", {keyword}});
    return false;
}

void CheckedEntries::refuseMisspelt(const Words& keywords) const
{
    for (const std::string& keyword : keywords) found(keyword);
    for (const std::string& keyword : keywords) foundAsSpelt(keyword);
}

void CheckedEntries::require(const std::string& keyword, const std::string& allowed) const
{
    if (found(keyword)) return;
    const std::string nearest = misspelt(keyword);
    if (nearest.empty()) throw InputError({place(keyword), "is missing", "", allowed});
    throw InputError({place(nearest), "is not a keyword here, and " + keyword + " is missing", nearest, allowed, {keyword}});
}

bool CheckedEntries::isDictionary(const std::string& keyword) const
{
    const Entry* entry = dict_.find(keyword);
    return entry && entry->dict;
}

const std::vector<Token>& CheckedEntries::tokens(const std::string& keyword, const std::string& allowed) const
{
    require(keyword, allowed);
    const Entry& entry = *dict_.find(keyword);
    if (entry.dict) reject(keyword, "is a dictionary where a value belongs", allowed);
    if (entry.value.empty()) reject(keyword, "has no value", allowed);
    return entry.value;
}

std::vector<Token> CheckedEntries::quantity(const std::string& keyword, const Unit& unit) const
{
    const std::vector<Token>& all = tokens(keyword, keyword + " value;");
    // A name before the dimensions, as OpenFOAM writes dimensioned numbers, says nothing.
    const auto opening = all.begin() + (all.size() > 1 && all[0].kind == Token::Kind::word && all[1].isMark('['));
    if (!opening->isMark('[')) return all;
    const auto closing = std::find_if(opening, all.end(), [](const Token& token) { return token.isMark(']'); });
    if (closing == all.end()) reject(keyword, "has dimensions without a closing ]");
    if (!unit.isSaidBy({opening + 1, closing})) reject(keyword, "has wrong dimensions", unit.describe() + " or a plain SI number");
    if (closing + 1 == all.end()) reject(keyword, "has no value");
    return {closing + 1, all.end()};
}

double CheckedEntries::toNumber(const std::string& keyword, const Token& token, const Range& range) const
{
    if (!token.isNumber()) reject(keyword, "is not a finite number", range.describe());
    if (std::abs(token.number) > largestNumber) reject(keyword, "is too large", textOf("numbers up to ", largestNumber));
    if (!range.contains(token.number)) reject(keyword, "is out of range", range.describe());
    const bool isTiny = token.number < smallestPositive && range.lower == 0.0 && !range.includesLower;
    if (isTiny) reject(keyword, "is too small", textOf("numbers from ", smallestPositive, " on"));
    return token.number;
}

double CheckedEntries::number(const std::string& keyword, const Range& range) const
{
    const std::vector<Token> tokens = quantity(keyword, range.unit);
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

Vec3 CheckedEntries::vec(const std::string& keyword, const Unit& unit) const
{
    const std::vector<Token> tokens = quantity(keyword, unit);
    if (tokens.size() != 5) reject(keyword, "is not a vector", vectorForm);
    return toVec(keyword, tokens, 0);
}

Vec3 CheckedEntries::vec(const std::string& keyword, const Unit& unit, const Vec3& defaultValue) const
{
    return found(keyword) ? vec(keyword, unit) : defaultValue;
}

std::array<Vec3, 2> CheckedEntries::twoVecs(const std::string& keyword, const Unit& unit) const
{
    const std::vector<Token> tokens = quantity(keyword, unit);
    if (tokens.size() != 10) reject(keyword, "does not hold two vectors", "vectors in a row, as (0 0 0) (1 1 1)");
    return {toVec(keyword, tokens, 0), toVec(keyword, tokens, 5)};
}

std::vector<Vec3> CheckedEntries::vecList(const std::string& keyword, const Unit& unit) const
{
    const std::vector<Token> tokens = quantity(keyword, unit);
    const bool isList = tokens.size() >= 7 && (tokens.size() - 2) % 5 == 0 && isInBrackets(tokens);
    if (!isList) reject(keyword, "is not a list of vectors", "as ((0 0 0) (1 0 0) (1 1 0))");
    std::vector<Vec3> result;
    for (std::size_t first = 1; first + 5 < tokens.size(); first += 5) result.push_back(toVec(keyword, tokens, first));
    return result;
}

std::array<double, 2> CheckedEntries::pair(const std::string& keyword, const Unit& unit) const
{
    const std::vector<Token> tokens = quantity(keyword, unit);
    if (tokens.size() != 4 || !isInBrackets(tokens)) reject(keyword, "is not a pair", "two numbers, as (0 1)");
    return {toNumber(keyword, tokens[1], anyNumber()), toNumber(keyword, tokens[2], anyNumber())};
}

std::vector<long> CheckedEntries::integers(const std::string& keyword, long lower) const
{
    const std::string allowed = "whole numbers >= " + std::to_string(lower) + " in brackets, as (1 2 3)";
    std::vector<Token> list = tokens(keyword, allowed);
    // OpenFOAM writes the number of entries before the brackets.
    const bool isCounted = list.size() > 3 && list[0].isNumber() && list[0].number == static_cast<double>(list.size() - 3);
    if (isCounted) list.erase(list.begin());
    if (list.size() < 3 || !isInBrackets(list)) reject(keyword, "is not a list of numbers", allowed);
    std::vector<long> numbers;
    for (std::size_t k = 1; k + 1 < list.size(); ++k)
    {
        numbers.push_back(toInteger(keyword, toNumber(keyword, list[k], atLeast(static_cast<double>(lower))), lower));
    }
    return numbers;
}

std::string CheckedEntries::choice(const std::string& keyword, const Words& allowed) const
{
    const std::vector<Token>& given = tokens(keyword, keyword + " word;");
    if (given.size() != 1 || !isListed(given[0].text, allowed)) reject(keyword, "is not one of the words allowed", "", allowed);
    return given[0].text;
}

std::string CheckedEntries::choice(const std::string& keyword, const Words& allowed, const std::string& defaultValue) const
{
    return found(keyword) ? choice(keyword, allowed) : defaultValue;
}

Words CheckedEntries::choices(const std::string& keyword, const Words& allowed, const Words& defaultValue) const
{
    if (!found(keyword)) return defaultValue;
    const std::vector<Token>& given = tokens(keyword, keyword + " (word word);");
    if (!isInBrackets(given)) reject(keyword, "is not a list of words", "", allowed);
    Words words;
    for (std::size_t k = 1; k + 1 < given.size(); ++k)
    {
        if (!isListed(given[k].text, allowed)) throw InputError({place(keyword), "holds a word that is not allowed", given[k].text, "", allowed});
        words.push_back(given[k].text);
    }
    return words;
}

std::string CheckedEntries::text(const std::string& keyword) const
{
    const std::vector<Token>& given = tokens(keyword, keyword + " \"text\";");
    const bool isText = given.size() == 1 && (given[0].kind == Token::Kind::word || given[0].kind == Token::Kind::quoted);
    if (!isText || given[0].text.empty()) reject(keyword, "is not a word or a quoted string", keyword + " \"text\";");
    return given[0].text;
}

std::string CheckedEntries::text(const std::string& keyword, const std::string& defaultValue) const
{
    return found(keyword) ? text(keyword) : defaultValue;
}

const Dictionary& CheckedEntries::sub(const std::string& keyword) const
{
    require(keyword, "a dictionary, " + keyword + " { ... }");
    const Entry& entry = *dict_.find(keyword);
    if (!entry.dict) reject(keyword, "is not a dictionary", keyword + " { ... }");
    return *entry.dict;
}

Dictionary CheckedEntries::subOrEmpty(const std::string& keyword) const
{
    return found(keyword) ? sub(keyword) : Dictionary{place(keyword), {}};
}

void CheckedEntries::finish() const
{
    for (const Entry& entry : dict_.entries)
    {
        if (!isListed(entry.keyword, declared_)) throw InputError({place(entry.keyword), "is not a keyword here", entry.keyword, "", declared_});
    }
}

} // namespace input
