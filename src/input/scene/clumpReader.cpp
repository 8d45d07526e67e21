// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading clumps.
#include "input/scene/clumpReader.hpp"

#include "input/lists/grainFiles.hpp"

#include <algorithm>

namespace input
{

namespace
{

/// Members that differ more are a mistake, and take ages to integrate over.
constexpr double largestRatio = 1e4;

std::vector<nscd::Ball> readMemberFile(const CheckedEntries& given, const Surroundings& around)
{
    std::vector<nscd::Ball> members;
    const std::string path = around.pathOfGrains(given.text("file"));
    for (const TableRow& row : readGrainTable(path, given.place("file")))
    {
        if (!row.material.empty())
        {
            throw InputError({{path, row.line}, "names a material", row.material, "x y z d: a clump has one, that of its source"});
        }
        members.push_back({row.position, 0.5*row.diameter});
    }
    return members;
}

std::vector<nscd::Ball> readMemberList(const CheckedEntries& given)
{
    std::vector<nscd::Ball> members;
    const double diameter = given.number("diameter", above(0, unit::length));
    for (const Vec3& center : given.vecList("members", unit::length)) members.push_back({center, 0.5*diameter});
    return members;
}

void checkMembers(const CheckedEntries& given, const std::string& keyword, const std::vector<nscd::Ball>& members, const nscd::GrainShape& shape)
{
    const auto isSmaller = [](const nscd::Ball& a, const nscd::Ball& b) { return a.radius < b.radius; };
    const double smallest = std::min_element(members.begin(), members.end(), isSmaller)->radius;
    for (const nscd::Ball& member : members)
    {
        const double reach = std::max(member.radius, (member.center - members[0].center).norm());
        if (reach <= largestRatio*smallest) continue;
        given.reject(keyword, "is too large for its smallest member", textOf("sizes up to ", largestRatio, " times its radius"));
    }
    try
    {
        nscd::makeClumpShape(members, 1.0, shape);
    }
    catch (const std::invalid_argument& error)
    {
        given.reject(keyword, error.what());
    }
}

} // namespace

ClumpSource readClump(const CheckedEntries& given, const GrainSource& source, const Surroundings& around)
{
    ClumpSource clump;
    if (!given.found("clump")) return clump;
    if (source.isFixed) given.reject("clump", "cannot be held", "motion free, or single grains that are fixed");
    if (source.lattice.spread > 0.0) given.reject("spread", "stands beside clump", "clumps of one size: several sources for several sizes");
    const CheckedEntries dict(given.sub("clump"));
    const std::string keyword = dict.found("file") ? "file" : "members";
    if (dict.found("members") && keyword == "file") dict.reject("members", "stands beside file", "one of the two");
    clump.members = keyword == "file" ? readMemberFile(dict, around) : readMemberList(dict);
    checkMembers(dict, keyword, clump.members, around.shape);
    clump.isRandom = dict.choice("orientation", {"random", "asGiven"}, "random") == "random";
    clump.seed = static_cast<std::uint64_t>(dict.integer("seed", 0, 1));
    dict.finish();
    return clump;
}

} // namespace input
