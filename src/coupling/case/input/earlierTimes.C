// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Listing times.
#include "coupling/case/input/earlierTimes.H"

namespace Foam
{
namespace nscdCoupling
{

wordList earlierTimes(const Time& time)
{
    wordList names;
    for (const instant& each : time.times())
    {
        if (each.name() != time.constant() && each.value() < time.value() && each.name() != time.timeName()) names.append(each.name());
    }
    return names;
}


string adviceOnEarlierTime(const Time& time)
{
    const wordList names = earlierTimes(time);
    if (names.empty()) return "";
    return "; if this time was not written or copied to its end, remove its directory or start from an earlier one, as " + names.last()
        + ", by startFrom and startTime in system/controlDict";
}

} // namespace nscdCoupling
} // namespace Foam
