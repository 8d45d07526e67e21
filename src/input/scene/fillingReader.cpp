// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading fillings.
#include "input/scene/fillingReader.hpp"

#include "input/scene/coarseReader.hpp"
#include "input/scene/regionReader.hpp"
#include "input/scene/sizeReader.hpp"

#include <algorithm>

namespace input
{

namespace
{

using nscd::FillingAmount;

const char* const amounts = "one of number 1000; mass 0.1; [kg], solidFraction 0.3; packing { solidFraction 0.6; }";

/// The one keyword that says how much.
std::string amountKeyword(const CheckedEntries& given)
{
    const Words known = {"number", "mass", "solidFraction", "packing"};
    Words found;
    for (const std::string& keyword : known)
    {
        if (given.found(keyword)) found.push_back(keyword);
    }
    if (found.empty()) given.refuseMisspelt(known);
    if (found.empty()) given.require("number", amounts);
    if (found.size() > 1) given.reject(found[1], "stands beside " + found[0], amounts);
    return found[0];
}

/// Of spheres in a plane, the share that they take of a layer as thick as the mesh does not tell how dense they lie.
double readPacking(const CheckedEntries& given, const Surroundings& around)
{
    if (around.shape.dimensions == 3 && around.shape.emptyAxis >= 0) given.reject("packing", "is not for spheres in a plane", "number, mass or solidFraction");
    const CheckedEntries inside(given.sub("packing"));
    for (const char* loose : {"number", "mass"})
    {
        if (inside.found(loose)) inside.reject(loose, "is of loose grains, and stands in the place of packing", "packing { solidFraction 0.6; }");
    }
    const double fraction = inside.number("solidFraction", Range{0, nscd::densestPacking(around.shape.dimensions), false, true});
    inside.finish();
    return fraction;
}

/// Of the grains that are asked for; of a number if all are as large as the largest [m3].
double askedVolume(const nscd::FillingSource& filling, const nscd::GrainShape& shape)
{
    if (filling.measure == FillingAmount::number) return filling.amount*shape.volume(0.5*filling.sizes.largest);
    return filling.measure == FillingAmount::mass ? filling.amount/filling.density : filling.amount*nscd::volumeOf(filling.region, shape);
}

/// Loose grains of one size that cannot find places would be tried for minutes. Of a number or a mass more may find them in a region hardly wider
/// than a grain, where they lie in a row: up to 0.75 of its length, 0.5 of its volume.
void checkLooseFraction(const CheckedEntries& given, const std::string& keyword, const Surroundings& around, const nscd::FillingSource& filling)
{
    constexpr double inARow = 1.3;
    const bool isOneSize = filling.sizes.smallest == filling.sizes.largest;
    if (filling.isPacked || !isOneSize || (around.shape.dimensions == 3 && around.shape.emptyAxis >= 0)) return;
    const bool isFraction = filling.measure == FillingAmount::solidFraction;
    const double most = nscd::densestAddition(around.shape.dimensions);
    const double fraction = askedVolume(filling, around.shape)/nscd::volumeOf(filling.region, around.shape);
    if (fraction <= (isFraction ? most : inARow*most)) return;
    const std::string makes = isFraction ? "" : textOf("makes a solid fraction of ", fraction, ", and ");
    const std::string dense = fraction > nscd::densestPacking(around.shape.dimensions) ? "" : textOf("; for more, packing { solidFraction ", fraction, "; }");
    given.reject(keyword, makes + "is more than grains of one size reach at random", textOf(isFraction ? "" : "a solid fraction ", "up to ", most, dense));
}

void readAmount(const CheckedEntries& given, const Surroundings& around, double coarseGraining, nscd::FillingSource& filling)
{
    const std::string keyword = amountKeyword(given);
    if (keyword == "number") filling.amount = double(bodiesOf(given.integer("number", 1), coarseGraining, around, given, "number"));
    if (keyword == "mass") filling.amount = given.number("mass", above(0, unit::mass));
    if (keyword == "solidFraction") filling.amount = given.number("solidFraction", within(0, 1));
    if (keyword == "packing") filling.amount = readPacking(given, around);
    filling.isPacked = keyword == "packing";
    if (keyword == "mass") filling.measure = FillingAmount::mass;
    if (keyword == "packing" || keyword == "solidFraction") filling.measure = FillingAmount::solidFraction;
    checkLooseFraction(given, keyword, around, filling);
}

/// At least so many grains are asked for.
double fewestGrains(const nscd::FillingSource& filling, const nscd::GrainShape& shape)
{
    return askedVolume(filling, shape)/shape.volume(0.5*filling.sizes.largest);
}

/// A region beyond its own image would be filled twice.
void checkPeriods(const CheckedEntries& given, const nscd::Region& region, const nscd::PeriodicBox& box)
{
    for (int k = 0; k < 3; ++k)
    {
        if (!box.isPeriodic(k) || region.bounds.sizes()[k] <= box.length[k]*(1.0 + 1e-9)) continue;
        given.reject("region", "is longer than the period", textOf("up to ", box.length[k], " m along axis ", k));
    }
}

} // namespace

void readFilling(const CheckedEntries& given, const MaterialTable& materials, const Surroundings& around, double mostGrains, GrainSource& source)
{
    nscd::FillingSource& filling = source.filling;
    filling.region = readRegion(given, "region", around);
    checkPeriods(given, filling.region, around.box);
    if (!(filling.region.volume > 0.0)) given.reject("region", "is flat", "a region with a volume");
    filling.sizes = nscd::scaledSizes(readSizes(given, around), source.coarseGraining);
    filling.density = materials.density[source.material];
    readAmount(given, around, source.coarseGraining, filling);
    filling.seed = static_cast<std::uint64_t>(given.integer("seed", 0, 1));
    source.amountPlace = given.place(amountKeyword(given));
    if (fewestGrains(filling, around.shape) > mostGrains)
    {
        given.reject(amountKeyword(given), "makes too many grains", textOf("at most ", mostGrains, " grains, for the memory of this machine"));
    }
}

} // namespace input
