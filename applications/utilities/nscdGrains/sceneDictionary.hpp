// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A scene's dictionary as it is written: keywords with their tokens and lines, nothing judged yet.
#pragma once

#include "sceneError.hpp"

#include <memory>

namespace nscdGrains
{

/// A word, a quoted string, or one of the marks ( ) [ ] { } ;
struct Token
{
    enum class Kind {word, quoted, mark};
    Kind kind;
    std::string text;
    int line;

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
};

struct Dictionary
{
    Place place;                             ///< keyword: path of the dictionary, empty at the top
    std::vector<Entry> entries;              ///< no keyword twice

    const Entry* find(const std::string& keyword) const;
    /// Path of a keyword in here.
    std::string pathOf(const std::string& keyword) const;
};

/// Refuses a path that leads to no file, and names the one beside it that may be meant.
/// Errors: SceneError with `place` as where the file was asked for
void checkIsFile(const std::string& path, const Place& place);

/// The text of a file.
/// Errors: SceneError where it cannot be read, with `place` as where it was asked for
std::string readText(const std::string& path, const Place& place);

/// Parses text with OpenFOAM's comments, brackets and strings; a FoamFile header is skipped. No macros ($) and no directives (#).
/// Errors: SceneError with file, line and keyword for text that is not a dictionary, and keywords given twice
Dictionary parseDictionary(const std::string& text, const std::string& file);

} // namespace nscdGrains
