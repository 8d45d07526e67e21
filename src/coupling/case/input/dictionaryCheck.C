// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Strict reading of dictionaries: declared keywords, checked values, messages that say what would have been right.
#include "coupling/case/input/dictionaryCheck.H"
#include "coupling/case/input/inputError.H"

#include "ITstream.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const Words switchWords = {"on", "off", "yes", "no", "true", "false"};

label closingBracket(const tokenList& tokens)
{
    for (label i = 0; i < tokens.size(); ++i)
    {
        if (tokens[i].isPunctuation() && tokens[i].pToken() == token::END_SQR) return i;
    }
    return -1;
}

label openingBracket(const tokenList& tokens)
{
    const auto isOpening = [&](label i)
    {
        return i < tokens.size() && tokens[i].isPunctuation() && tokens[i].pToken() == token::BEGIN_SQR;
    };
    if (isOpening(0)) return 0;
    return tokens.size() && tokens[0].isWord() && isOpening(1) ? 1 : -1;
}

} // namespace


bool Range::contains(scalar value) const
{
    return (includesLower ? value >= lower : value > lower) && (includesUpper ? value <= upper : value < upper);
}


string Range::describe() const
{
    string text = "a finite number";
    if (std::isfinite(lower)) text += messageText(includesLower ? " >= " : " > ", lower);
    if (std::isfinite(lower) && std::isfinite(upper)) text += " and";
    if (std::isfinite(upper)) text += messageText(includesUpper ? " <= " : " < ", upper);
    return text;
}


CheckedDict::CheckedDict(const dictionary& dict)
:
    dict_(dict)
{}


void CheckedDict::declare(const word& keyword) const
{
    if (std::find(declared_.begin(), declared_.end(), keyword) == declared_.end()) declared_.push_back(keyword);
}


bool CheckedDict::has(const word& keyword) const
{
    return dict_.findEntry(keyword, keyType::LITERAL) != nullptr;
}


bool CheckedDict::found(const word& keyword) const
{
    declare(keyword);
    return has(keyword);
}


InputPlace CheckedDict::place(const word& keyword) const
{
    return placeOf(dict_, keyword);
}


void CheckedDict::reject
(
    const word& keyword, const string& problem, const string& allowed, const Words& words
) const
{
    fail({placeOf(dict_, keyword), problem, valueText(dict_, keyword), allowed, words});
}


CheckedDict::Value CheckedDict::value(const word& keyword, const dimensionSet* dimensions) const
{
    declare(keyword);
    const entry* found = dict_.findEntry(keyword, keyType::LITERAL);
    if (!found) fail({placeOf(dict_, keyword), "is missing"});
    if (found->isDict()) reject(keyword, "is a sub-dictionary where a value belongs");

    const tokenList& tokens = found->stream();
    if (tokens.empty()) reject(keyword, "has no value");
    const label opening = dimensions ? openingBracket(tokens) : -1;
    if (opening < 0) return {tokens, 1.0};

    const label closing = closingBracket(tokens);
    if (closing < 0) reject(keyword, "has dimensions without a closing ]");
    ITstream stream(found->name(), SubList<token>(tokens, closing - opening + 1, opening));
    dimensionSet given(dimless);
    scalar multiplier = 1;
    given.read(stream, multiplier);
    if (given != *dimensions) reject(keyword, "has wrong dimensions", messageText(*dimensions, " or a plain SI number"));
    return {tokenList(SubList<token>(tokens, tokens.size() - closing - 1, closing + 1)), multiplier};
}


scalar CheckedDict::toNumber(const word& keyword, const token& tok, scalar multiplier, const Range& range) const
{
    if (!tok.isNumber() || !std::isfinite(tok.number())) reject(keyword, "is not a finite number", range.describe());
    const scalar number = multiplier*tok.number();
    if (!range.contains(number)) reject(keyword, "is out of range", range.describe());
    return number;
}


scalar CheckedDict::number(const word& keyword, const Range& range, const dimensionSet& dimensions) const
{
    const Value given = value(keyword, &dimensions);
    if (given.tokens.size() != 1) reject(keyword, "is not a single number (a missing semicolon?)", range.describe());
    return toNumber(keyword, given.tokens[0], given.multiplier, range);
}


scalar CheckedDict::number
(
    const word& keyword, const Range& range, const dimensionSet& dimensions, scalar defaultValue
) const
{
    return found(keyword) ? number(keyword, range, dimensions) : defaultValue;
}


label CheckedDict::integer(const word& keyword, label lower) const
{
    const scalar number = this->number(keyword, atLeast(lower));
    const bool isWhole = std::floor(number) == number && number <= labelMax;
    if (!isWhole) reject(keyword, "is not a whole number", "a whole number >= " + Foam::name(lower));
    return static_cast<label>(number);
}


label CheckedDict::integer(const word& keyword, label lower, label defaultValue) const
{
    return found(keyword) ? integer(keyword, lower) : defaultValue;
}


bool CheckedDict::flag(const word& keyword, bool defaultValue) const
{
    if (!found(keyword)) return defaultValue;
    const std::string given = choice(keyword, switchWords);
    return given == "on" || given == "yes" || given == "true";
}


vector CheckedDict::toVector(const word& keyword, const Value& given, label first) const
{
    const auto isMark = [&](label i, token::punctuationToken mark)
    {
        return given.tokens[i].isPunctuation() && given.tokens[i].pToken() == mark;
    };
    const bool hasBrackets = given.tokens.size() >= first + 5
        && isMark(first, token::BEGIN_LIST) && isMark(first + 4, token::END_LIST);
    if (!hasBrackets) reject(keyword, "is not a vector", "three numbers in brackets, as (0 0 1)");
    vector result;
    for (direction k = 0; k < 3; ++k)
    {
        result[k] = toNumber(keyword, given.tokens[first + 1 + k], given.multiplier, anyNumber());
    }
    return result;
}


vector CheckedDict::vec(const word& keyword, const dimensionSet& dimensions) const
{
    const Value given = value(keyword, &dimensions);
    if (given.tokens.size() != 5) reject(keyword, "is not a vector", "three numbers in brackets, as (0 0 1)");
    return toVector(keyword, given, 0);
}


vector CheckedDict::vec(const word& keyword, const dimensionSet& dimensions, const vector& defaultValue) const
{
    return found(keyword) ? vec(keyword, dimensions) : defaultValue;
}


List<vector> CheckedDict::vecs(const word& keyword, label count, const dimensionSet& dimensions) const
{
    const Value given = value(keyword, &dimensions);
    if (given.tokens.size() != 5*count)
    {
        reject(keyword, "does not hold " + Foam::name(count) + " vectors", "vectors in a row, as (0 0 0) (1 1 1)");
    }
    List<vector> result(count);
    forAll(result, i) result[i] = toVector(keyword, given, 5*i);
    return result;
}


string CheckedDict::text(const word& keyword) const
{
    const Value given = value(keyword, nullptr);
    const bool isText = given.tokens.size() == 1 && (given.tokens[0].isWord() || given.tokens[0].isString());
    if (!isText) reject(keyword, "is not a word or a quoted string");
    const token& tok = given.tokens[0];
    return tok.isWord() ? string(tok.wordToken()) : tok.stringToken();
}


string CheckedDict::text(const word& keyword, const string& defaultValue) const
{
    return found(keyword) ? text(keyword) : defaultValue;
}


std::string CheckedDict::choice(const word& keyword, const Words& allowed) const
{
    const Value given = value(keyword, nullptr);
    const bool isText = given.tokens.size() == 1 && (given.tokens[0].isWord() || given.tokens[0].isString());
    const std::string chosen = isText ? std::string(text(keyword)) : std::string();
    if (std::find(allowed.begin(), allowed.end(), chosen) == allowed.end())
    {
        reject(keyword, "is not one of the words allowed", string::null, allowed);
    }
    return chosen;
}


std::string CheckedDict::choice(const word& keyword, const Words& allowed, const std::string& defaultValue) const
{
    return found(keyword) ? choice(keyword, allowed) : defaultValue;
}


const dictionary& CheckedDict::sub(const word& keyword) const
{
    declare(keyword);
    const entry* found = dict_.findEntry(keyword, keyType::LITERAL);
    if (!found) fail({placeOf(dict_, keyword), "is missing", string::null, "a sub-dictionary, " + keyword + " { ... }"});
    if (!found->isDict()) reject(keyword, "is not a sub-dictionary", keyword + " { ... }");
    return found->dict();
}


dictionary CheckedDict::subOrEmpty(const word& keyword) const
{
    if (found(keyword)) return dictionary(dict_, sub(keyword));
    dictionary empty(fileName(dict_.name() + '.' + keyword));
    return dictionary(dict_, empty);
}


void CheckedDict::finish() const
{
    for (const entry& given : dict_)
    {
        const std::string keyword = given.keyword();
        if (std::find(declared_.begin(), declared_.end(), keyword) != declared_.end()) continue;
        InputError error{placeOf(dict_, given.keyword()), "is not a keyword here"};
        error.value = keyword;
        error.words = declared_;
        fail(error);
    }
}

} // namespace nscdCoupling
} // namespace Foam
