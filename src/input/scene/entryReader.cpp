// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading sources that let grains in.
#include "input/scene/entryReader.hpp"

#include "input/scene/coarseReader.hpp"
#include "input/scene/functionReader.hpp"
#include "input/scene/materialReader.hpp"
#include "input/scene/regionReader.hpp"
#include "input/scene/sizeReader.hpp"

#include <algorithm>

namespace input
{

namespace
{

/// The integral of a rate from `start` on, over a duration [s].
nscd::ScalarOfTime amountOf(const nscd::ScalarOfTime& rate, double start, double duration)
{
    const nscd::ScalarOfTime integral = nscd::integralOf(rate);
    return [=](double time) { return integral(std::clamp(time, start, start + duration)) - integral(start); };
}

/// The amount of bodies that an amount of real grains makes.
nscd::ScalarOfTime inBodies(const nscd::ScalarOfTime& amount, double realGrains)
{
    return [=](double time) { return amount(time)/realGrains; };
}

/// `rate` [1/s] or `massRate` [kg/s], functions of time.
void readRate(const CheckedEntries& given, const Surroundings& around, nscd::EntrySource& entry)
{
    entry.isMass = given.found("massRate");
    if (entry.isMass && given.found("rate")) given.reject("massRate", "stands beside rate", "one of the two");
    if (!entry.isMass) given.require("rate", "rate 100; [1/s], or massRate 0.1; [kg/s]");
    const std::string keyword = entry.isMass ? "massRate" : "rate";
    const nscd::ScalarOfTime rate = readScalarFunction(given, keyword);
    const double start = given.number("start", atLeast(0, unit::time), 0.0);
    const double duration = given.number("duration", above(0, unit::time), largestNumber);
    if (!(rate(start) >= 0.0)) given.reject(keyword, "is below zero at the start", ">= 0");
    entry.amount = amountOf(rate, start, duration);
    if (!entry.isMass && entry.coarseGraining > 1.0) entry.amount = inBodies(entry.amount, nscd::grainsInParcel(entry.coarseGraining, around.shape.dimensions));
    if (given.found("number")) entry.number = bodiesOf(given.integer("number", 1), entry.coarseGraining, around, given, "number");
}

/// A vector, or the word `fluid`.
void readVelocity(const CheckedEntries& given, const Surroundings& around, nscd::EntrySource& entry)
{
    const std::vector<Token> value = given.found("velocity") ? given.tokens("velocity", "(x y z), or fluid") : std::vector<Token>();
    entry.takesFluidVelocity = value.size() == 1 && value[0].kind == Token::Kind::word && value[0].text == "fluid";
    if (entry.takesFluidVelocity && !around.hasFluid) given.reject("velocity", "is that of a fluid, and none is solved", "(x y z) [m/s]");
    if (entry.takesFluidVelocity) return;
    entry.velocity = given.vec("velocity", unit::velocity, Vec3::Zero());
    checkInPlane(given, "velocity", entry.velocity, around.shape.emptyAxis);
}

} // namespace

void readEntry(const Dictionary& dict, const std::string& name, const Surroundings& around, Scene& scene)
{
    const CheckedEntries given(dict);
    nscd::EntrySource entry;
    entry.name = name;
    given.found("type");
    entry.material = readMaterialOfGrains(given, scene.materials);
    entry.density = scene.materials.density[entry.material];
    given.require("region", "a dictionary, region { ... }");
    entry.coarseGraining = readCoarseGraining(given, around, scene);
    entry.sizes = nscd::scaledSizes(readSizes(given, around), entry.coarseGraining);
    entry.region = readEntryRegion(given, "region", around, 0.5*entry.sizes.largest);
    readRate(given, around, entry);
    readVelocity(given, around, entry);
    entry.omega = given.vec("omega", unit::rate, Vec3::Zero());
    checkNormalToPlane(given, "omega", entry.omega, around.shape.emptyAxis);
    entry.seed = static_cast<std::uint64_t>(given.integer("seed", 0, 1));
    given.finish();
    scene.entries.push_back(entry);
    scene.entryPlaces.push_back(given.place("region"));
}

} // namespace input
