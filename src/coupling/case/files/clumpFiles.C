// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing and reading clumps.
#include "coupling/case/files/clumpFiles.H"

#include "coupling/base/vectorConversion.H"

#include "Time.H"

#include <unordered_map>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

std::vector<std::size_t> firstMembers(const GrainState& state)
{
    std::vector<std::size_t> first;
    for (std::size_t i = 0; i < state.grains.size(); ++i)
    {
        if (isFirstMember(state, i)) first.push_back(i);
    }
    return first;
}

/// Of the first members, from what grains have.
template<class Type, class Of>
List<Type> ofThose(const std::vector<std::size_t>& first, const Of& of)
{
    List<Type> values(label(first.size()));
    forAll(values, c) values[c] = of(first[c]);
    return values;
}

std::vector<nscd::Vec3> toVec3s(const vectorField& values)
{
    std::vector<nscd::Vec3> result;
    for (const vector& value : values) result.push_back(toVec3(value));
    return result;
}

} // namespace


void writeMembership(const CloudWriter& grainCloud, const GrainState& state)
{
    if (!areClumpsApart(state)) return;
    const std::vector<scalar>& clump = state.clumpParts.scalars.at(part::clump);
    const std::vector<nscd::Vec3>& center = state.clumpParts.vectors.at(part::memberCenter);
    labelList ids(label(clump.size()));
    forAll(ids, i) ids[i] = label(clump[i]);
    List<vector> centers(label(center.size()));
    forAll(centers, i) centers[i] = toFoam(center[i]);
    grainCloud.write(part::clump, ids);
    grainCloud.write(part::memberCenter, centers);
}


void writeClumps(const polyMesh& mesh, const GrainState& state, const labelUList& cells)
{
    if (!areClumpsApart(state)) return;
    const std::vector<std::size_t> first = firstMembers(state);
    const nscd::Grains& grains = state.grains;
    const auto points = ofThose<vector>(first, [&](std::size_t i) { return toFoam(grains.position[i]); });
    const auto cellsOfClumps = ofThose<label>(first, [&](std::size_t i) { return cells[label(i)]; });
    const auto ids = ofThose<label>(first, [&](std::size_t i) { return label(grains.id[i]); });
    const CloudWriter cloud(mesh, "clumps", points, cellsOfClumps, ids);
    for (const word& name : part::scalars)
    {
        const std::vector<scalar>& values = state.clumpParts.scalars.at(name);
        if (name == "members") cloud.write(name, ofThose<label>(first, [&](std::size_t i) { return label(values[i]); }));
        else cloud.write(name, ofThose<scalar>(first, [&](std::size_t i) { return values[i]; }));
    }
    for (const word& name : part::vectors)
    {
        const std::vector<nscd::Vec3>& values = state.clumpParts.vectors.at(name);
        cloud.write(name, ofThose<vector>(first, [&](std::size_t i) { return toFoam(values[i]); }));
    }
}


void readClumpParts(const polyMesh& mesh, GrainState& state)
{
    const CloudReader grainCloud(mesh, "grains");
    grainCloud.labels("origId");   // how many there are
    if (!grainCloud.found(part::clump)) return;
    state.clumpParts = clumpParts(state.grains);
    const labelList clump = grainCloud.labels(part::clump);
    std::copy(clump.begin(), clump.end(), state.clumpParts.scalars[part::clump].begin());
    state.clumpParts.vectors[part::memberCenter] = toVec3s(grainCloud.vectors(part::memberCenter));

    std::unordered_map<std::int64_t, std::size_t> place;
    for (std::size_t i = 0; i < state.grains.size(); ++i) place.emplace(state.grains.id[i], i);
    const CloudReader cloud(mesh, "clumps");
    const labelList id = cloud.labels("origId");
    std::vector<std::size_t> first;
    for (const label c : id)
    {
        const auto found = place.find(c);
        if (found == place.end() || !isFirstMember(state, found->second)) refuseClump(mesh, c, "whose members are not there, or not in a row");
        first.push_back(found->second);
    }
    const auto put = [&](const auto& from, auto& to, const auto& convert) { forAll(from, c) to[first[c]] = convert(from[c]); };
    put(cloud.labels("members"), state.clumpParts.scalars["members"], [](label x) { return scalar(x); });
    for (const word& name : part::scalars)
    {
        if (name != "members") put(cloud.scalars(name), state.clumpParts.scalars[name], [](scalar x) { return x; });
    }
    for (const word& name : part::vectors) put(cloud.vectors(name), state.clumpParts.vectors[name], [](const vector& x) { return toVec3(x); });
}

} // namespace nscdCoupling
} // namespace Foam
