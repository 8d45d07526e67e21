// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A dictionary as it is written: keywords with their values, lines and paths, nothing judged yet. Every front end makes one of what it reads.
#pragma once

#include "input/dictionary/inputError.hpp"

#include "nscd/scene/wallMotion.hpp"

#include <memory>

namespace input
{

/// A number, a word, a quoted string, or one of the marks ( ) [ ] { } ;
struct Token
{
    enum class Kind { number, word, quoted, mark };
    Kind kind;
    std::string text;
    int line;
    double number = 0.0;                     ///< of a number

    bool isNumber() const { return kind == Kind::number; }
    bool isMark(char mark) const { return kind == Kind::mark && text[0] == mark; }
};

struct Dictionary;

/// `keyword value;` or `keyword { ... }`
struct Entry
{
    std::string keyword;
    int line;
    std::vector<Token> value;                ///< without the semicolon
    std::shared_ptr<const Dictionary> dict;  ///< null for a value
    bool isQuoted = false;                   ///< the keyword, which OpenFOAM then takes for a regular expression
};

/// Functions of time of a dictionary, for a program that knows more kinds of them than functionReader.
class Functions
{
public:
    virtual ~Functions() = default;

    /// The words that may stand for a kind.
    virtual Words types() const = 0;
    /// What a keyword says.
    /// Errors: those of the program
    virtual nscd::ScalarOfTime scalar(const std::string& keyword) const = 0;
    virtual nscd::VectorOfTime vector(const std::string& keyword) const = 0;
};

struct Dictionary
{
    Place place;                             ///< keyword: path of the dictionary, empty at the top
    std::vector<Entry> entries;              ///< no keyword twice
    std::shared_ptr<const Functions> functions = nullptr;  ///< null: functionReader knows all there are

    const Entry* find(const std::string& keyword) const;
    /// Path of a keyword in here.
    std::string pathOf(const std::string& keyword) const;
    /// Where a keyword is; where the dictionary is if there is none.
    Place placeOf(const std::string& keyword) const;
};

/// A finite number from a whole word; false for anything else, as nan, inf, 0x10, 1e400 or 5mm.
bool readNumber(const std::string& word, double& number);

/// The tokens as written, with blanks between them, cut after some hundred letters.
std::string asWritten(const std::vector<Token>& tokens);

/// That a keyword is given a second time at a place.
Mistake repeated(const Place& place, int firstLine);

/// Parses text with OpenFOAM's comments, brackets and strings; a FoamFile header is skipped. No macros ($) and no directives (#).
/// Errors: InputError with file, line and keyword for text that is not a dictionary, and for keywords given twice
Dictionary parseDictionary(const std::string& text, const std::string& file);

} // namespace input
