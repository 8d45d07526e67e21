// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking at the ends of files.
#include "coupling/case/files/writtenFiles.H"
#include "coupling/case/input/throwingErrors.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <algorithm>
#include <iterator>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// The last characters of the divider that OpenFOAM ends its files with.
const std::string dividerEnd = "**** //\n";

std::string lastPart(std::istream& is, bool isCompressed)
{
    const std::size_t length = dividerEnd.size();
    if (!isCompressed)
    {
        is.seekg(0, std::ios::end);
        is.seekg(-std::min(std::streamoff(length), std::streamoff(is.tellg())), std::ios::end);
    }
    const std::string text((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
    return text.substr(text.size() - std::min(length, text.size()));
}

/// Files with OpenFOAM's banner end with a divider; an empty file has lost its banner. Others' files end as they like.
bool isWhole(const fileName& path)
{
    IFstream file(path);
    if (!file.good()) return false;
    std::istream& is = file.stdStream();
    std::string banner(2, ' ');
    if (!is.read(&banner[0], 2)) return false;
    if (banner != "/*") return true;
    const bool isCompressed = !isFile(path, false);
    return lastPart(is, isCompressed) == dividerEnd;
}

} // namespace


void checkWritten(const fileName& folder)
{
    for (const fileName& file : readDir(folder, fileName::FILE))
    {
        if (!isWhole(folder/file)) refuseUnwritten(folder/file);
    }
    for (const fileName& inner : readDir(folder, fileName::DIRECTORY)) checkWritten(folder/inner);
}


void writeOrRefuse(const fileName& path, const std::function<bool()>& write)
{
    bool isWritten = false;
    string reason;
    try
    {
        const ThrowingErrors throwing;
        isWritten = write();
    }
    catch (const Foam::error& error)
    {
        reason = error.message();
    }
    if (!isWritten) refuseUnwritten(path, reason);
}


void refuseUnwritten(const fileName& path, const string& reason)
{
    FatalErrorIn("nscdDEMFoam")
        << "Cannot write " << path << " to its end; is the disk full? The times before it are whole: make room, remove this time's "
        << "directory (of all processors), and start again with startFrom latestTime. " << reason.c_str() << exit(FatalError);
    std::abort();
}

} // namespace nscdCoupling
} // namespace Foam
