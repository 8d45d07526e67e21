// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading sizes.
#include "input/scene/sizeReader.hpp"

#include <algorithm>
#include <cmath>

namespace input
{

namespace
{

const Range length = above(0, unit::length);

struct Ends
{
    double smallest;
    double largest;
};

Ends readEnds(const CheckedEntries& given)
{
    const Ends ends = {given.number("min", length), given.number("max", length)};
    if (!(ends.largest > ends.smallest)) given.reject("max", "is not above min", textOf("more than ", ends.smallest));
    return ends;
}

nscd::SizeDistribution readUniform(const CheckedEntries& given)
{
    const Ends ends = readEnds(given);
    return nscd::tabulatedSizes({{ends.smallest, 1.0}, {ends.largest, 1.0}});
}

nscd::SizeDistribution readNormal(const CheckedEntries& given)
{
    const Ends ends = readEnds(given);
    return nscd::normalSizes(given.number("mean", length), given.number("deviation", length), ends.smallest, ends.largest);
}

/// By median and geometric deviation, or by mean and deviation, all of them before the ends are cut off.
/// Equation: geometric deviation exp(s), median mean exp(-s^2/2), s^2 = ln(1 + (deviation/mean)^2)
nscd::SizeDistribution readLogNormal(const CheckedEntries& given)
{
    const Ends ends = readEnds(given);
    if (given.found("mean"))
    {
        const double mean = given.number("mean", length);
        const double variance = std::log1p(std::pow(given.number("deviation", length)/mean, 2));
        return nscd::logNormalSizes(mean*std::exp(-variance/2), std::exp(std::sqrt(variance)), ends.smallest, ends.largest);
    }
    const double median = given.number("median", length);
    return nscd::logNormalSizes(median, given.number("geometricDeviation", above(1)), ends.smallest, ends.largest);
}

nscd::SizeDistribution readRosinRammler(const CheckedEntries& given)
{
    const Ends ends = readEnds(given);
    return nscd::rosinRammlerSizes(given.number("d", length), given.number("n", above(0)), ends.smallest, ends.largest);
}

/// ((diameter density) ...)
nscd::SizeDistribution readGeneral(const CheckedEntries& given)
{
    const char* const form = "rows of diameter [m] and density, as ((0.001 0) (0.002 5) (0.003 0))";
    const std::vector<Token>& tokens = given.tokens("distribution", form);
    if (tokens.size() < 2 || tokens.size() % 4 != 2) given.reject("distribution", "is not a table", form);
    std::vector<std::array<double, 2>> rows;
    for (std::size_t at = 1; at + 1 < tokens.size(); at += 4)
    {
        if (!tokens[at].isMark('(') || !tokens[at + 3].isMark(')')) given.reject("distribution", "is not a table", form);
        rows.push_back({given.toNumber("distribution", tokens[at + 1], length), given.toNumber("distribution", tokens[at + 2], atLeast(0))});
    }
    return nscd::tabulatedSizes(rows);
}

struct SizeType
{
    const char* name;
    nscd::SizeDistribution (*read)(const CheckedEntries&);
};

/// Every distribution: a function that reads its keywords, and a row. Others go here.
const SizeType sizeTypes[] =
{
    {"uniform", readUniform},
    {"normal", readNormal},
    {"logNormal", readLogNormal},
    {"RosinRammler", readRosinRammler},
    {"general", readGeneral}
};

/// The program's own, where its dictionary of numbers stands there or the type is none of ours.
ReadSizes readType(const CheckedEntries& given, const Surroundings& around)
{
    Words names;
    for (const SizeType& type : sizeTypes) names.push_back(type.name);
    for (const auto& model : around.sizeModels) names.push_back(model.first);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const std::string name = given.choice("type", names);
    const auto type = std::find_if(std::begin(sizeTypes), std::end(sizeTypes), [&](const SizeType& row) { return name == row.name; });
    const auto model = around.sizeModels.find(name);
    const bool isModel = model != around.sizeModels.end() && (type == std::end(sizeTypes) || given.found(name + "Distribution"));
    return isModel ? model->second : ReadSizes(type->read);
}

/// Numbers from masses take (largest/smallest)^3 draws at worst.
constexpr double largestRatioOfMasses = 50.0;

nscd::SizeDistribution readDistribution(const CheckedEntries& given, const Surroundings& around)
{
    const ReadSizes read = readType(given, around);
    const bool isByMass = given.choice("by", {"number", "mass"}, "number") == "mass";
    const nscd::SizeDistribution sizes = read(given);
    given.finish();
    if (!isByMass) return sizes;
    if (sizes.largest > largestRatioOfMasses*sizes.smallest) given.reject("by", "is for narrower ranges of sizes", textOf("a largest one within ", largestRatioOfMasses, " times the smallest"));
    return nscd::numbersOfMasses(sizes, around.shape.dimensions);
}

} // namespace

nscd::SizeDistribution readSizes(const CheckedEntries& given, const Surroundings& around)
{
    const bool hasSizes = given.found("sizes");
    if (given.found("diameter") && hasSizes) given.reject("sizes", "stands beside diameter", "one of the two");
    if (!hasSizes) return nscd::oneSize(given.number("diameter", length));
    const CheckedEntries inside(given.sub("sizes"));
    try
    {
        return readDistribution(inside, around);
    }
    catch (const std::invalid_argument& error)
    {
        given.reject("sizes", std::string("cannot be drawn: ") + error.what());
    }
}

} // namespace input
