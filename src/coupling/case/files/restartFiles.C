// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Listing the files of a time, and looking for them.
#include "coupling/case/files/restartFiles.H"
#include "coupling/case/files/processorNames.H"
#include "coupling/case/input/earlierTimes.H"
#include "coupling/case/input/inputError.H"

#include "HashSet.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "cloud.H"
#include "polyMesh.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// What a run makes anew, without reading it.
const wordHashSet madeAnew{"p", "grainState", "positions", "coordinates", "origProcId"};

void addFiles(const fileName& timePath, const fileName& folder, fileNameList& files)
{
    for (const fileName& file : readDir(timePath/folder, fileName::FILE))
    {
        if (!madeAnew.found(word(file.name(), false))) files.append(folder.empty() ? file : folder/file);
    }
}

/// -1 where there is none.
off_t sizeOf(const fileName& path) { return std::max(fileSize(path), fileSize(path + ".gz")); }

/// Whether a file is one of a cloud that no rank has points of.
bool isOfEmptyCloud(const Time& time, const fileName& file)
{
    return file.path().path() == cloud::prefix && !returnReduce(isDir(time.timePath()/file.path()), orOp<bool>());
}

[[noreturn]] void refuseLoss(const Time& time, const fileName& file, const string& loss, bool isHere)
{
    const fileName folder = Pstream::parRun() ? time.globalPath()/"processor*"/time.timeName() : time.timePath();
    const string advice = adviceOnEarlierTime(time);
    fail
    ({
        placeInFile(folder/file, file.name()), loss + ", and without it the run would not go on as the one that wrote this time",
        Pstream::parRun() ? processorsWhere(isHere) : string(),
        "a written time with all of its files" + (advice.empty() ? "; or a new run, from time 0" : advice)
            + "; who wants to go on all the same takes the name out of `files` in uniform/grainState"
    });
}

} // namespace


fileNameList restartFiles(const Time& time)
{
    const fileName folder = time.timePath();
    fileNameList files;
    addFiles(folder, "", files);
    addFiles(folder, "uniform", files);
    const fileName movedPoints = fileName(polyMesh::meshSubDir)/"points";
    if (isFile(folder/movedPoints)) files.append(movedPoints);
    for (const fileName& points : readDir(folder/cloud::prefix, fileName::DIRECTORY)) addFiles(folder, cloud::prefix/points, files);
    sort(files);
    return files;
}


void checkRestartFiles(const Time& time, fileNameList files)
{
    Pstream::scatter(files);
    for (const fileName& file : files)
    {
        const off_t size = sizeOf(time.timePath()/file);
        const bool isMissing = !returnReduce(size >= 0, orOp<bool>()), isEmpty = size == 0;
        if (isMissing && !isOfEmptyCloud(time, file)) refuseLoss(time, file, "is missing", true);
        if (returnReduce(isEmpty, orOp<bool>())) refuseLoss(time, file, "is empty", isEmpty);
    }
}


bool skipsWrittenTime(const Time& time)
{
    bool isSkipped = false;
    for (const word& name : earlierTimes(time)) isSkipped = isSkipped || isFile(time.path()/name/"uniform/grainState");
    isSkipped = isSkipped && time.controlDict().getOrDefault<word>("startFrom", "latestTime") == "latestTime";
    return returnReduce(isSkipped, orOp<bool>());
}

} // namespace nscdCoupling
} // namespace Foam
