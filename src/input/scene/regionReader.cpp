// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading regions.
#include "input/scene/regionReader.hpp"

#include "input/dictionary/textFile.hpp"
#include "input/dictionary/withoutTraps.hpp"

#include "nscd/scene/stlFile.hpp"

#include <algorithm>

namespace input
{

namespace
{

using ReadRegion = nscd::Region (*)(const CheckedEntries&, const Surroundings&);

nscd::Region readBox(const CheckedEntries& given, const Surroundings& around)
{
    const std::array<Vec3, 2> corners = given.twoVecs("box", unit::length);
    for (int k = 0; k < 3; ++k)
    {
        if (!around.isEmpty(k) && !(corners[1][k] >= corners[0][k])) given.reject("box", "is empty", "(lower corner) (upper corner)");
    }
    return nscd::boxRegion(corners[0], corners[1]);
}

nscd::Region readSphere(const CheckedEntries& given, const Surroundings&)
{
    return nscd::sphereRegion(given.vec("center", unit::length), given.number("radius", above(0, unit::length)));
}

nscd::Region readCylinder(const CheckedEntries& given, const Surroundings&)
{
    const std::array<Vec3, 2> ends = given.twoVecs("axis", unit::length);
    if (!((ends[1] - ends[0]).norm() > 0.0)) given.reject("axis", "has no length", "(x y z) (x y z), two ends that differ");
    return nscd::cylinderRegion(ends[0], ends[1], given.number("radius", above(0, unit::length)));
}

nscd::Region readSurface(const CheckedEntries& given, const Surroundings& around)
{
    const std::string path = around.pathOfSurface(given.text("file"));
    const double scale = given.number("scale", above(0), 1.0);
    checkIsFile(path, given.place("file"));
    try
    {
        const WithoutTraps traps;
        return nscd::surfaceRegion(nscd::readStl(path, scale));
    }
    catch (const std::invalid_argument& error)
    {
        given.reject("file", std::string("cannot be used: ") + error.what(), "an STL file of a closed surface");
    }
}

struct RegionType
{
    const char* name;
    ReadRegion read;
};

/// Every kind of region: a function that reads its keywords, and a row. Others go here.
const RegionType regionTypes[] =
{
    {"box", readBox},
    {"sphere", readSphere},
    {"cylinder", readCylinder},
    {"stl", readSurface}
};

Words namesOfTypes()
{
    Words names;
    for (const RegionType& type : regionTypes) names.push_back(type.name);
    return names;
}

const RegionType& readType(const CheckedEntries& given)
{
    const std::string name = given.choice("type", namesOfTypes());
    return *std::find_if(std::begin(regionTypes), std::end(regionTypes), [&](const RegionType& type) { return name == type.name; });
}

/// Points are drawn by rejection, which must come to an end.
constexpr double leastShare = 1e-3;

} // namespace

nscd::Region readRegion(const CheckedEntries& given, const std::string& keyword, const Surroundings& around)
{
    const CheckedEntries inside(given.sub(keyword));
    nscd::Region region = readType(inside).read(inside, around);
    inside.finish();
    if (around.shape.emptyAxis >= 0) region = nscd::inPlane(region, around.shape.emptyAxis, around.midPlane);
    if (nscd::shareOfBounds(region) < leastShare)
    {
        given.reject(keyword, "has no points to draw", "a region with room, in scenes of discs one that their plane cuts");
    }
    return region;
}

nscd::EntryRegion readEntryRegion(const CheckedEntries& given, const std::string& keyword, const Surroundings& around, double largestRadius)
{
    const CheckedEntries inside(given.sub(keyword));
    Words names = namesOfTypes();
    for (const auto& more : around.entryRegions) names.push_back(more.first);
    const auto more = around.entryRegions.find(inside.choice("type", names));
    if (more == around.entryRegions.end()) return readRegion(given, keyword, around);
    nscd::EntryRegion region = more->second(inside, around, largestRadius);
    inside.finish();
    return region;
}

} // namespace input
