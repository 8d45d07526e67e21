// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading where grains come from.
#include "coupling/case/input/grainSourceReader.H"
#include "coupling/case/input/materialsReader.H"

#include "dimensionSets.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Grains along each axis from `count (nx ny nz);`, or from `spacing`: as many as fit.
Vector<label> readCount(const CheckedDict& given, const vector& extent)
{
    if (given.found("count") && given.found("spacing")) given.reject("spacing", "stands beside count", "one of the two");
    const bool isCounted = given.found("count");
    const vector perAxis = isCounted
        ? given.vec("count", dimless)
        : vector(extent/given.number("spacing", above(0), dimLength));
    Vector<label> count;
    for (direction k = 0; k < 3; ++k)
    {
        // A box that is a whole number of spacings long must not lose a layer to round-off.
        const scalar number = std::floor(perAxis[k] + (isCounted ? 0 : 1e-9));
        const bool isWhole = number >= 1 && number <= labelMax && (!isCounted || number == perAxis[k]);
        if (isCounted && !isWhole) given.reject("count", "is not three whole numbers >= 1", "as (10 10 20)");
        count[k] = max(label(1), label(number));
    }
    return count;
}


LatticeSettings readLattice(const CheckedDict& given)
{
    LatticeSettings lattice;
    const List<vector> corners = given.vecs("box", 2, dimLength);
    lattice.lower = corners[0];
    lattice.upper = corners[1];
    for (direction k = 0; k < 3; ++k)
    {
        if (lattice.upper[k] <= lattice.lower[k]) given.reject("box", "is empty", "(lower corner) (upper corner)");
    }
    lattice.diameter = given.number("diameter", above(0), dimLength);
    lattice.count = readCount(given, lattice.upper - lattice.lower);
    lattice.spread = given.number("spread", Range{0, 1, true, false}, dimless, lattice.spread);
    lattice.jitter = given.number("jitter", between(0, 1), dimless, lattice.jitter);
    lattice.seed = given.integer("seed", 0, lattice.seed);
    return lattice;
}


GrainSource readSource(const dictionary& dict, const GrainProperties& properties, bool isFixedByDefault)
{
    const CheckedDict given(dict);
    GrainSource source;
    source.place = placeOf(dict);
    source.type = given.choice("type", {"positionsFile", "table", "lattice"});
    source.material = readGrainMaterial(given, properties.materials);
    source.velocity = given.vec("velocity", dimVelocity, Zero);
    source.omega = given.vec("omega", dimless/dimTime, Zero);
    source.isFixed = given.choice("motion", {"free", "fixed"}, isFixedByDefault ? "fixed" : "free") == "fixed";
    if (source.type == "lattice") source.lattice = readLattice(given);
    if (source.type == "table") source.file = fileName(given.text("file"));
    if (source.type == "positionsFile")
    {
        source.file = fileName(given.text("file"));
        source.diameter = given.number("diameter", above(0), dimLength);
    }
    given.finish();
    return source;
}

} // namespace


void readSources(const CheckedDict& top, GrainProperties& properties)
{
    const bool isFixed = top.choice("motion", {"free", "fixed"}, "free") == "fixed";
    properties.shape = top.choice("shape", {"sphere", "disc"}, "");
    properties.shapePlace = top.place("shape");
    properties.overlapPlace = top.place("maxInitialOverlap");
    properties.maxInitialOverlap = top.number("maxInitialOverlap", atLeast(0), dimless, properties.maxInitialOverlap);

    const dictionary& grains = top.sub("grains");
    if (grains.found("type"))
    {
        properties.sources.push_back(readSource(grains, properties, isFixed));
        return;
    }
    const CheckedDict named(grains);
    for (const entry& given : grains)
    {
        properties.sources.push_back(readSource(named.sub(given.keyword()), properties, isFixed));
    }
}

} // namespace nscdCoupling
} // namespace Foam
