// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What each grain remembers: declared once, and found again after entries, exits, a change of ranks, and a restart on another number.
#include "caseTools.H"
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/grainExits.H"
#include "coupling/step/grainMemory.H"
#include "coupling/step/grainRanks.H"
#include "mappingTools.H"
#include "ranksMesh.H"

#include "StringStream.H"

#include <stdexcept>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

constexpr bool isWritten = true;
const Remembered<scalar> warmth{"warmth", "K", 293, isWritten, OnRestart::required};
const Remembered<Vec3> push{"push", "N", Vec3(0, 0, 1), isWritten, OnRestart::optional};
const Remembered<Vec3> whim{"whim", "m", Vec3(7, 7, 7), !isWritten, OnRestart::forgotten};

/// A memory of three quantities, none of which any code knows.
struct Dummies
{
    GrainMemory memory;
    std::vector<scalar>& warmth = memory.add(::warmth);
    std::vector<Vec3>& push = memory.add(::push);
    std::vector<Vec3>& whim = memory.add(::whim);

    /// Values that tell the grain.
    void think(const ::nscd::Grains& grains)
    {
        memory.start(grains.size());
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            const scalar id = scalar(grains.id[i]);
            warmth[i] = 300 + id/7;
            push[i] = Vec3(id, 1/(1 + id), -id);
            whim[i] = Vec3(-id, 0, id/3);
        }
    }

    void expectThoughtsOf(const ::nscd::Grains& grains, bool isWhimKept)
    {
        ASSERT_EQ(warmth.size(), grains.size());
        ASSERT_EQ(push.size(), grains.size());
        ASSERT_EQ(whim.size(), grains.size());
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            const scalar id = scalar(grains.id[i]);
            EXPECT_EQ(warmth[i], 300 + id/7);
            EXPECT_EQ(push[i], Vec3(id, 1/(1 + id), -id));
            EXPECT_EQ(whim[i], isWhimKept ? Vec3(-id, 0, id/3) : Vec3(7, 7, 7));
        }
    }

    RestartExpectation expected() const
    {
        RestartExpectation expected;
        memory.expect(expected);
        return expected;
    }
};

input::MaterialTable glass()
{
    input::MaterialTable materials;
    materials.table.add("glass");
    materials.density.push_back(2500);
    materials.place.push_back(input::Place());
    return materials;
}

GrainState stateOf(const ::nscd::Grains& grains, const GrainMemory& memory)
{
    GrainState state;
    state.grains = grains;
    memory.copyTo(state);
    return state;
}

void writeAt(scalar time, fvMesh& mesh, const GrainState& state)
{
    const_cast<Time&>(mesh.time()).setTime(time, label(time));
    writeGrainState(mesh, state, glass().table, labelList(label(state.grains.size()), -1));
}

GrainState readAt(scalar time, fvMesh& mesh, const RestartExpectation& expected)
{
    const_cast<Time&>(mesh.time()).setTime(time, label(time));
    return readGrainState(mesh, glass(), ::nscd::GrainShape(), expected);
}

BoxMeshSettings exactBox()
{
    BoxMeshSettings settings = unitCells(labelVector(8, 3, 2));
    settings.control.add("writePrecision", 17);
    return settings;
}

/// The same on every rank; grains whose center is in this rank's part come out.
::nscd::Grains grainsOfPart(RanksMesh& mesh)
{
    const ::nscd::Grains all = makeGrains(randomPoints(40, Vec3(0.1, 0.1, 0.1), Vec3(7.9, 2.9, 1.9)), 0.05);
    ::nscd::Grains own;
    own.shape = all.shape;
    const SerialSection serial;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const label cell = mesh.whole().findCell(toFoam(all.position[i]));
        if (mesh.rankOf(cell) == UPstream::myProcNo(UPstream::worldComm)) own.add(all.position[i], all.radius[i], 2500, 0, all.id[i]);
    }
    return own;
}

void runInCase(const RanksMesh& mesh, const std::string& command)
{
    const std::string log = mesh.casePath() + "/log.restart";
    const int status = std::system(("cd " + mesh.casePath() + " && " + command + " > " + log + " 2>&1 < /dev/null").c_str());
    if (status != 0) std::system(("tail -n 30 " + log + " >&2").c_str());
    EXPECT_EQ(status, 0) << command;
}

} // namespace

TEST(GrainMemory, newGrainsStartAsDeclared)
{
    Dummies dummies;
    dummies.memory.start(3);
    EXPECT_EQ(dummies.warmth, std::vector<scalar>(3, 293.0));
    EXPECT_EQ(dummies.push, std::vector<Vec3>(3, Vec3(0, 0, 1)));
    dummies.warmth[1] = 5;
    dummies.memory.enter(2);
    EXPECT_EQ(dummies.warmth, std::vector<scalar>({293, 5, 293, 293, 293}));
    EXPECT_EQ(dummies.whim, std::vector<Vec3>(5, Vec3(7, 7, 7)));
}

TEST(GrainMemory, exitsTakeTheirValuesAlong)
{
    ::nscd::Grains grains = makeGrains(randomPoints(6, Vec3::Zero(), Vec3(1, 1, 1)), 0.1);
    Dummies dummies;
    dummies.think(grains);
    const std::vector<std::size_t> gone = {0, 3, 5};
    eraseGrains(grains, gone);
    dummies.memory.erase(gone);
    dummies.expectThoughtsOf(grains, true);
    EXPECT_EQ(grains.size(), 3u);
}

TEST(GrainMemory, aStateCarriesAllOfItAndWritesWhatIsWritten)
{
    const ::nscd::Grains grains = makeGrains(randomPoints(6, Vec3::Zero(), Vec3(1, 1, 1)), 0.1);
    Dummies dummies, others;
    dummies.think(grains);
    const GrainState state = stateOf(grains, dummies.memory);
    EXPECT_EQ(state.extras.scalars.size(), 1u);
    EXPECT_EQ(state.extras.vectors.size(), 1u);
    EXPECT_EQ(state.unwritten.vectors.count("whim"), 1u);
    others.memory.takeFrom(state);
    others.expectThoughtsOf(grains, true);
}

TEST(GrainMemory, aRestartFindsWhatWasWrittenAndStartsTheRest)
{
    BoxMesh box(exactBox());
    const ::nscd::Grains grains = makeGrains(randomPoints(30, Vec3::Zero(), Vec3(8, 3, 2)), 0.1);
    Dummies before, after;
    before.think(grains);
    writeAt(1, box.mesh(), stateOf(grains, before.memory));
    const GrainState read = readAt(1, box.mesh(), after.expected());
    after.memory.start(read.grains.size());
    OStringStream said;
    after.memory.recall(read.extras, said);
    after.expectThoughtsOf(read.grains, false);
    EXPECT_EQ(said.str(), "");
}

TEST(GrainMemory, aRestartThatLacksAQuantityIsRefusedOrStartsItAsDeclared)
{
    BoxMesh box(exactBox());
    const ::nscd::Grains grains = makeGrains(randomPoints(30, Vec3::Zero(), Vec3(8, 3, 2)), 0.1);
    Dummies before, after;
    before.think(grains);
    GrainState state = stateOf(grains, before.memory);
    state.extras.vectors.erase("push");
    writeAt(1, box.mesh(), state);
    const GrainState read = readAt(1, box.mesh(), after.expected());
    after.memory.start(read.grains.size());
    OStringStream said;
    after.memory.recall(read.extras, said);
    EXPECT_EQ(after.push, std::vector<Vec3>(30, Vec3(0, 0, 1)));
    EXPECT_EQ(after.warmth, before.warmth);
    EXPECT_TRUE(holds(said.str(), {"lagrangian/grains/push", "(0 0 1) N"}));

    state = stateOf(grains, before.memory);
    state.extras.scalars.erase("warmth");
    writeAt(2, box.mesh(), state);
    EXPECT_TRUE(holds(complaint([&] { readAt(2, box.mesh(), after.expected()); }), {"lagrangian/grains/warmth", "missing"}));
}

TEST(GrainMemory, refusesDeclarationsThatCannotBe)
{
    GrainMemory memory;
    memory.add(warmth);
    EXPECT_THROW(memory.add(warmth), std::invalid_argument);
    EXPECT_THROW(memory.add(Remembered<Vec3>{"warmth", "m", Vec3::Zero(), isWritten, OnRestart::forgotten}), std::invalid_argument);
    EXPECT_THROW(memory.add(Remembered<scalar>{"mood", "-", 0, !isWritten, OnRestart::required}), std::invalid_argument);
}

TEST(grainMemoryRanks, goesAlongFromRankToRank)
{
    RanksMesh mesh(exactBox(), slices());
    const ::nscd::Grains own = grainsOfPart(mesh);
    Dummies dummies;
    dummies.think(own);
    GrainRanks ranks(1.2);
    // All to the last rank, and then shared out.
    GrainState state = stateOf(own, dummies.memory);
    if (ranks.isParallel()) state = ranks.moved(state, std::vector<int>(own.size(), Pstream::nProcs() - 1));
    EXPECT_EQ(state.grains.size(), Pstream::myProcNo() == Pstream::nProcs() - 1 ? 40u : 0u);
    dummies.memory.takeFrom(state);
    dummies.expectThoughtsOf(state.grains, true);
    state = ranks.share(state, {});
    EXPECT_LT(state.grains.size(), Pstream::parRun() ? 40u : 41u);
    dummies.memory.takeFrom(state);
    dummies.expectThoughtsOf(state.grains, true);
}

TEST(grainMemoryRanks, isFoundOnAnotherNumberOfRanks)
{
    if (!Pstream::parRun()) GTEST_SKIP() << "on several ranks";
    RanksMesh mesh(exactBox(), slices());
    const ::nscd::Grains own = grainsOfPart(mesh);
    Dummies dummies;
    dummies.think(own);
    writeAt(1, mesh.part(), stateOf(own, dummies.memory));
    OStringStream said;

    // From all ranks to one, and from there to all again.
    if (Pstream::master())
    {
        const SerialSection serial;
        runInCase(mesh, "reconstructPar -latestTime");
        Dummies alone;
        const GrainState read = readAt(1, mesh.whole(), alone.expected());
        EXPECT_EQ(read.grains.size(), 40u);
        alone.memory.start(read.grains.size());
        alone.memory.recall(read.extras, said);
        alone.expectThoughtsOf(read.grains, false);
        writeAt(2, mesh.whole(), stateOf(read.grains, alone.memory));
        runInCase(mesh, "decomposePar -fields -time 2");
    }
    label isWritten = 1;
    reduce(isWritten, sumOp<label>());
    Dummies again;
    GrainState read = readAt(2, mesh.part(), again.expected());
    EXPECT_EQ(read.grains.size(), own.size());
    read = GrainRanks(1.2).share(read, {});
    again.memory.start(read.grains.size());
    again.memory.recall(read.extras, said);
    again.expectThoughtsOf(read.grains, false);
    EXPECT_EQ(said.str(), "");
}
