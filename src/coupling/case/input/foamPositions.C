// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading what OpenFOAM alone can read, and handing the rest over.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/foamHeader.H"
#include "coupling/case/input/foamPositions.H"
#include "coupling/case/input/inputError.H"

#include "input/dictionary/quantity.hpp"
#include "input/dictionary/withoutTraps.hpp"
#include "input/dictionary/textFile.hpp"

#include "OSspecific.H"
#include "vectorList.H"

#include <iterator>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

std::vector<nscd::Vec3> readBinary(IFstream& is, const Place& source)
{
    std::vector<nscd::Vec3> positions;
    for (const vector& x : List<vector>(is))
    {
        positions.push_back(toVec3(x));
        if (positions.back().cwiseAbs().maxCoeff() <= input::largestNumber && positions.back().allFinite()) continue;
        throw input::InputError({{is.name(), 0, is.name().name()}, "holds a position whose coordinate is not a finite number", messageText(x)});
    }
    if (positions.empty()) throw input::InputError({source, "names a file that holds no grain", is.name(), "a file with grains"});
    return positions;
}

} // namespace


std::vector<nscd::Vec3> readFoamPositions(const std::string& path, const Place& source)
{
    if (!isFile(path)) input::checkIsFile(path, source);
    const input::WithoutTraps traps;
    IFstream is(path);
    if (readHeader(is) && is.format() == IOstream::BINARY) return readBinary(is, source);
    IFstream text(path);
    return input::parsePositions({std::istreambuf_iterator<char>(text.stdStream()), {}}, path, source);
}

} // namespace nscdCoupling
} // namespace Foam
