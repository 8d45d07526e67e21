// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The word a user most likely meant, for messages about words nobody knows.
#pragma once

#include <string>
#include <vector>

namespace nscd
{

/// Letters to insert, drop, replace or swap with their neighbor to turn one word into the other; case costs nothing.
/// Equation: optimal string alignment distance (Damerau 1964)
int editDistance(const std::string& a, const std::string& b);

/// The candidate nearest to `word`, the first of equals; empty if more than a third of the longer word's letters differ.
std::string nearestWord(const std::string& word, const std::vector<std::string>& candidates);

} // namespace nscd
