// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The parts of a checkpoint file.
#include "nscd/tools/sceneCheckpoint.hpp"

#include "nscd/base/sectionFile.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

constexpr char kind[] = "nscdScen";
constexpr std::uint64_t version = 3;

static_assert(sizeof(Vec3) == 3*sizeof(double) && sizeof(Quaternion) == 4*sizeof(double), "vectors are written as plain numbers");
static_assert(sizeof(EntryState) == 3*sizeof(std::int64_t) + 2*sizeof(double), "states of sources are written as they lie in memory");
static_assert(sizeof(StoredImpulse) == 2*sizeof(std::int64_t) + 2*sizeof(Vec3), "impulses are written as they lie in memory");

/// What is no array.
struct Numbers
{
    std::uint64_t grains;
    std::int64_t step;
    double time;
    double lastDeltaT;
    std::int64_t dimensions;
    double thickness;
    std::int64_t emptyAxis;
    std::int64_t nextId;
};

/// Names as one text, each ended by a zero byte.
std::vector<char> joined(const std::vector<std::string>& names)
{
    std::vector<char> text;
    for (const std::string& name : names) text.insert(text.end(), name.c_str(), name.c_str() + name.size() + 1);
    return text;
}

std::vector<std::string> split(const std::vector<char>& text)
{
    std::vector<std::string> names;
    for (auto begin = text.begin(); begin != text.end();)
    {
        const auto end = std::find(begin, text.end(), '\0');
        names.emplace_back(begin, end);
        begin = end == text.end() ? end : end + 1;
    }
    return names;
}

/// Passes each array of the grains under its name, in the order of the file.
template<class Grains, class Section>
void forEachNamedArray(Grains& grains, const Section& section)
{
    nscd::Grains::forEachMember([&](const char* name, auto array) { section(name, grains.*array); });
}

template<class Clumps, class Section>
void forEachNamedArrayOfClumps(Clumps& clumps, const Section& section)
{
    section("clump.shape", clumps.shape);
    section("clump.first", clumps.firstMember);
    section("clump.position", clumps.position);
    section("clump.turn", clumps.orientation);
    section("clump.velocity", clumps.velocity);
    section("clump.momentum", clumps.angularMomentum);
}

/// A shape without its members, which follow those of the shapes before.
struct ShapeNumbers
{
    std::uint64_t members;
    double mass;
    Eigen::Matrix3d inertia;
    Vec3 massCenter;
};

static_assert(sizeof(Ball) == 4*sizeof(double) && sizeof(ShapeNumbers) == 14*sizeof(double), "shapes are written as they lie in memory");

void writeClumps(SectionFileWriter& file, const Clumps& clumps)
{
    std::vector<ShapeNumbers> shapes;
    std::vector<Ball> members;
    for (const ClumpShape& shape : clumps.shapes)
    {
        shapes.push_back({shape.members.size(), shape.mass, shape.inertia, shape.massCenter});
        members.insert(members.end(), shape.members.begin(), shape.members.end());
    }
    file.section("clumpShapes", shapes);
    file.section("clumpMembers", members);
    forEachNamedArrayOfClumps(clumps, [&](const char* name, const auto& values) { file.section(name, values); });
}

/// Sections as they are; joined to clumps once the file has proved whole.
struct StoredClumps
{
    std::vector<ShapeNumbers> shapes;
    std::vector<Ball> members;
    Clumps clumps;
};

StoredClumps readClumps(SectionFileReader& file)
{
    StoredClumps stored;
    file.section("clumpShapes", stored.shapes);
    file.section("clumpMembers", stored.members);
    forEachNamedArrayOfClumps(stored.clumps, [&](const char* name, auto& values) { file.section(name, values); });
    return stored;
}

Clumps joinClumps(const SectionFileReader& file, StoredClumps stored)
{
    forEachNamedArrayOfClumps(stored.clumps, [&](const char*, const auto& values)
    {
        if (values.size() != stored.clumps.size()) file.refuse("made of arrays of clumps that differ in length");
    });
    auto next = stored.members.begin();
    for (const ShapeNumbers& shape : stored.shapes)
    {
        if (shape.members > static_cast<std::uint64_t>(stored.members.end() - next)) file.refuse("without some members of clumps");
        const auto end = next + static_cast<std::ptrdiff_t>(shape.members);
        stored.clumps.shapes.push_back({std::vector<Ball>(next, end), shape.mass, shape.inertia, shape.massCenter});
        next = end;
    }
    return stored.clumps;
}

} // namespace

SceneState takeState(GrainDynamics& dynamics, double time, std::int64_t step)
{
    SceneState state;
    state.impulses = dynamics.checkpoint(state.lastDeltaT);
    state.grains = dynamics.grains();
    state.time = time;
    state.step = step;
    return state;
}

void writeCheckpoint(const std::string& path, const SceneState& state)
{
    const GrainShape& shape = state.grains.shape;
    const Numbers numbers =
    {
        state.grains.size(), state.step, state.time, state.lastDeltaT, shape.dimensions, shape.thickness, shape.emptyAxis, state.nextId
    };
    SectionFileWriter file(path, kind, version);
    file.section("numbers", std::vector<Numbers>(1, numbers));
    file.section("materials", joined(state.materials));
    forEachNamedArray(state.grains, [&](const char* name, const auto& values) { file.section(name, values); });
    writeClumps(file, state.grains.clumps);
    file.section("entryNames", joined(state.entryNames));
    file.section("entries", state.entries);
    file.section("impulses", state.impulses);
    file.complete();
}

SceneState readCheckpoint(const std::string& path)
{
    SectionFileReader file(path, kind, version);
    SceneState state;
    std::vector<Numbers> numbers;
    std::vector<char> materials, entryNames;
    file.section("numbers", numbers);
    file.section("materials", materials);
    forEachNamedArray(state.grains, [&](const char* name, auto& values) { file.section(name, values); });
    StoredClumps clumps = readClumps(file);
    file.section("entryNames", entryNames);
    file.section("entries", state.entries);
    file.section("impulses", state.impulses);
    file.finish();

    if (numbers.size() != 1) file.refuse("without its numbers");
    state.grains.forEachArray([&](const auto& values)
    {
        if (values.size() != numbers[0].grains) file.refuse("made of arrays that differ in length");
    });
    state.grains.clumps = joinClumps(file, std::move(clumps));
    state.grains.nOwned = state.grains.size();
    state.grains.shape.dimensions = static_cast<int>(numbers[0].dimensions);
    state.grains.shape.thickness = numbers[0].thickness;
    state.grains.shape.emptyAxis = static_cast<int>(numbers[0].emptyAxis);
    state.time = numbers[0].time;
    state.lastDeltaT = numbers[0].lastDeltaT;
    state.step = numbers[0].step;
    state.materials = split(materials);
    state.nextId = numbers[0].nextId;
    state.entryNames = split(entryNames);
    if (state.entryNames.size() != state.entries.size()) file.refuse("without the names of some sources");
    return state;
}

} // namespace nscd
