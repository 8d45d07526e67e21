// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Implementation of nearestWord.hpp.
#include "nscd/base/nearestWord.hpp"

#include <algorithm>
#include <cctype>

namespace nscd
{

namespace
{

bool isSameLetter(char a, char b)
{
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

} // namespace

int editDistance(const std::string& a, const std::string& b)
{
    const std::size_t columns = b.size() + 1;
    std::vector<int> cost((a.size() + 1)*columns);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return cost[i*columns + j]; };

    for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = static_cast<int>(j);

    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const int replace = at(i - 1, j - 1) + (isSameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
            at(i, j) = std::min({replace, at(i - 1, j) + 1, at(i, j - 1) + 1});
            const bool isSwap =
                i > 1 && j > 1 && isSameLetter(a[i - 1], b[j - 2]) && isSameLetter(a[i - 2], b[j - 1]);
            if (isSwap) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    }
    return at(a.size(), b.size());
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& candidates)
{
    std::string nearest;
    int least = 0;
    for (const std::string& candidate : candidates)
    {
        const int distance = editDistance(word, candidate);
        const int letters = static_cast<int>(std::max(word.size(), candidate.size()));
        const bool isNear = 3*distance <= letters;
        if (isNear && (nearest.empty() || distance < least))
        {
            nearest = candidate;
            least = distance;
        }
    }
    return nearest;
}

} // namespace nscd
