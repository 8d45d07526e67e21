// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Asking all ranks, and naming some.
#include "coupling/case/files/processorNames.H"

#include "Pstream.H"
#include "labelList.H"

namespace Foam
{
namespace nscdCoupling
{

string processorsWhere(bool isMeant)
{
    constexpr label mostNamed = 8;
    labelList answers(Pstream::nProcs(), 0);
    answers[Pstream::myProcNo()] = isMeant;
    Pstream::gatherList(answers);
    Pstream::scatterList(answers);
    string names;
    label count = 0;
    forAll(answers, rank)
    {
        if (!answers[rank]) continue;
        if (count < mostNamed) names += (count ? ", processor" : "processor") + std::to_string(rank);
        ++count;
    }
    if (count > mostNamed) names += " and " + std::to_string(count - mostNamed) + " more";
    return names;
}

} // namespace nscdCoupling
} // namespace Foam
