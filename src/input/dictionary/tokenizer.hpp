// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Text of dictionaries cut into tokens.
#pragma once

#include "input/dictionary/dictionary.hpp"

namespace input
{

/// openFoam: macros ($), directives (#), verbatim text (#{ ... #}) and words with brackets in them pass as words; plain refuses them.
enum class Dialect { plain, openFoam };

/// Dictionaries in one another, at most: beyond, whoever reads them by recursion runs out of stack.
constexpr int maxDepth = 50;

/// The mistake of going deeper.
Mistake nestedTooDeep(const Place& place);

/// All tokens of a text but its comments.
/// Errors: InputError with file and line for strings and comments that do not end, and for characters that are no text
std::vector<Token> tokensOf(const std::string& text, const std::string& file, Dialect dialect);

} // namespace input
