// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking for times that are there for others.
#include "coupling/case/files/decomposedTimes.H"
#include "coupling/case/files/processorNames.H"
#include "coupling/case/input/inputError.H"

#include "IFstream.H"
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

bool startsFromLatestTime(const fileName& wholeCase)
{
    const fileName file = wholeCase/"system/controlDict";
    IFstream is(file);
    return is.good() && dictionary(file, dictionary::null, is).getOrDefault<word>("startFrom", "latestTime") == "latestTime";
}

void checkLatestTime(const argList& args, const fileName& wholeCase)
{
    const instantList times = Time::findTimes(args.path());
    const scalar last = times.empty() ? 0 : times.last().value();
    const scalar latest = returnReduce(last, maxOp<scalar>());
    const bool isLacking = last < latest;
    if (!returnReduce(isLacking, orOp<bool>()) || !startsFromLatestTime(wholeCase)) return;
    word name = isLacking ? word() : word(times.last().name());
    reduce(name, maxOp<word>());
    fail
    ({
        placeInFile(wholeCase/"processor*"/name, name),
        "is the latest time, and some processors lack it: it was not written to its end", processorsWhere(isLacking),
        "remove the directory " + name + " of all processors, and the run continues from the time before it"
    });
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
    checkLatestTime(args, wholeCase);
}

} // namespace nscdCoupling
} // namespace Foam
