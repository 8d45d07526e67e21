// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking for times that are there for others.
#include "decomposedTimes.H"

#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "Time.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Written times of the whole case.
wordList timesOfWhole(const fileName& wholeCase)
{
    wordList names;
    for (const instant& time : Time::findTimes(wholeCase))
    {
        if (isFile(wholeCase/time.name()/"uniform/grainState")) names.append(time.name());
    }
    return names;
}

} // namespace

void completeTimes(const argList& args)
{
    if (!Pstream::parRun()) return;
    const fileName wholeCase = args.rootPath()/args.globalCaseName();
    wordList names = timesOfWhole(wholeCase);
    Pstream::scatter(names);
    for (const word& name : names)
    {
        const fileName own = args.path()/name;
        const bool isDecomposed = returnReduce(isDir(own/"lagrangian/grains"), orOp<bool>());
        if (!isDecomposed || isDir(own)) continue;
        mkDir(own);
        ln("../../"/name/"uniform", own/"uniform");
    }
}

} // namespace nscdCoupling
} // namespace Foam
