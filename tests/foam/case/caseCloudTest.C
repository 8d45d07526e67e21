// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of written times: what is read back, in every format, and what is said about damaged files.
#include "caseTools.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/files/grainCloud.H"
#include "coupling/case/files/runState.H"
#include "coupling/case/files/writtenFiles.H"

#include "OSspecific.H"
#include "passiveParticleCloud.H"

#include <cmath>
#include <fstream>
#include <random>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;
using nscd::Vec3;

namespace
{

input::MaterialTable twoMaterials(const std::string& first = "glass", const std::string& second = "lead")
{
    input::MaterialTable materials;
    for (const std::string& name : {first, second})
    {
        materials.table.add(name);
        materials.density.push_back(name == "lead" ? 11000 : 2500);
        materials.place.push_back(Place());
    }
    return materials;
}

/// Random numbers that use every bit.
class Numbers
{
public:
    double operator()() { return uniform_(engine_); }
    Vec3 vec() { return Vec3((*this)(), (*this)(), (*this)()); }

private:
    std::mt19937_64 engine_{11};
    std::uniform_real_distribution<double> uniform_{0, 1};
};

GrainState randomState(int n)
{
    Numbers number;
    GrainState state;
    std::vector<scalar> temperature;
    std::vector<Vec3> force;
    const input::MaterialTable materials = twoMaterials();
    for (int i = 0; i < n; ++i)
    {
        const int material = i % 2;
        state.grains.add(number.vec(), 0.01*(1 + number()), materials.density[material], material, 7*i + 3);
        state.grains.velocity.back() = number.vec() - Vec3(0.5, 0.5, 0.5);
        state.grains.omega.back() = 1e3*number.vec();
        state.grains.orientation.back() = nscd::Quaternion(number(), number(), number(), number()).normalized();
        state.grains.isFixed.back() = i % 3 == 0;
        temperature.push_back(300*number());
        force.push_back(1e-9*number.vec());
    }
    for (int i = 0; i + 1 < n; ++i)
    {
        state.contacts.push_back({7*i + 3, i % 4 ? 7*i + 10 : -1 - (i % 3), 1e-7*number.vec()});
    }
    state.extras.scalars["temperature"] = temperature;
    state.extras.vectors["fContact"] = force;
    state.numbers = {{"lastDeltaT", 1e-4/3}, {"exited", 12345678901.0}};
    return state;
}

BoxMeshSettings inFormat(const word& format, label precision = 17, bool isCompressed = false)
{
    BoxMeshSettings settings;
    settings.control.add("writeFormat", format);
    settings.control.add("writePrecision", precision);
    settings.control.add("writeCompression", word(isCompressed ? "on" : "off"));
    return settings;
}

RestartExpectation expectation()
{
    return {{"temperature"}, {"fContact"}, {"lastDeltaT", "exited"}, 3};
}

void write(BoxMesh& box, const GrainState& state)
{
    const labelList cells(label(state.grains.size()), -1);
    writeGrainState(box.mesh(), state, twoMaterials().table, cells);
}

GrainState readBack(BoxMesh& box, const input::MaterialTable& materials = twoMaterials())
{
    return readGrainState(box.mesh(), materials, nscd::GrainShape(), expectation());
}

GrainState roundTrip(const BoxMeshSettings& settings, const GrainState& state)
{
    BoxMesh box(settings);
    ++box.time();
    write(box, state);
    return readBack(box);
}

/// Largest difference of anything in two states, over the size of what is compared. 0: the same to the bit.
double difference(const GrainState& a, const GrainState& b)
{
    double worst = 0;
    const auto compare = [&](double x, double y) { worst = std::max(worst, std::abs(x - y)/std::max(1e-12, std::abs(x))); };
    const auto compareVec = [&](const Vec3& x, const Vec3& y) { for (int k = 0; k < 3; ++k) compare(x[k], y[k]); };
    EXPECT_EQ(a.grains.size(), b.grains.size());
    EXPECT_EQ(a.contacts.size(), b.contacts.size());
    EXPECT_EQ(a.grains.id, b.grains.id);
    EXPECT_EQ(a.grains.material, b.grains.material);
    EXPECT_EQ(a.grains.isFixed, b.grains.isFixed);
    for (std::size_t i = 0; i < std::min(a.grains.size(), b.grains.size()); ++i)
    {
        compareVec(a.grains.position[i], b.grains.position[i]);
        compareVec(a.grains.velocity[i], b.grains.velocity[i]);
        compareVec(a.grains.omega[i], b.grains.omega[i]);
        for (int k = 0; k < 4; ++k) compare(a.grains.orientation[i].coeffs()[k], b.grains.orientation[i].coeffs()[k]);
        compare(a.grains.radius[i], b.grains.radius[i]);
        compare(a.grains.mass[i], b.grains.mass[i]);
        compare(a.extras.scalars.at("temperature")[i], b.extras.scalars.at("temperature").at(i));
        compareVec(a.extras.vectors.at("fContact")[i], b.extras.vectors.at("fContact").at(i));
    }
    for (std::size_t c = 0; c < std::min(a.contacts.size(), b.contacts.size()); ++c)
    {
        EXPECT_EQ(a.contacts[c].idA, b.contacts[c].idA);
        EXPECT_EQ(a.contacts[c].idB, b.contacts[c].idB);
        compareVec(a.contacts[c].impulse, b.contacts[c].impulse);
        compareVec(a.contacts[c].ofLaws[0], b.contacts[c].ofLaws[0]);
    }
    return worst;
}

/// What is said when a file of the written time is cut to a share of its length (0: removed).
std::string complaintWithout(const fileName& file, double share)
{
    BoxMesh box(inFormat("ascii"));
    ++box.time();
    write(box, randomState(20));
    const fileName path = box.time().timePath()/file;
    std::ifstream whole(path);
    const std::string contents((std::istreambuf_iterator<char>(whole)), std::istreambuf_iterator<char>());
    EXPECT_FALSE(contents.empty()) << path;
    rm(path);
    if (share > 0) std::ofstream(path) << contents.substr(0, std::size_t(share*contents.size()));
    return complaint([&] { readBack(box); });
}

} // namespace

TEST(Restart, rollingMomentsAreWrittenWhereThereIsRollingFriction)
{
    GrainState state = randomState(20);
    for (nscd::StoredImpulse& contact : state.contacts) contact.ofLaws[0] = 0.1*contact.impulse;
    for (const bool isRolling : {true, false})
    {
        input::MaterialTable materials = twoMaterials();
        nscd::ContactPair pair;
        pair.rollingFriction = isRolling ? 0.1 : 0;
        materials.table.setPair(0, 1, pair);
        BoxMesh box(inFormat("binary"));
        ++box.time();
        writeGrainState(box.mesh(), state, materials.table, labelList(label(state.grains.size()), -1));
        EXPECT_EQ(isFile(box.time().timePath()/"lagrangian/contacts/rolling"), isRolling);
        const GrainState back = readBack(box, materials);
        for (std::size_t c = 0; c < state.contacts.size(); ++c)
        {
            EXPECT_EQ(back.contacts.at(c).ofLaws[0], isRolling ? state.contacts[c].ofLaws[0] : Vec3(Vec3::Zero()));
        }
    }
}

TEST(GrainCloud, comesBackToTheBitFromBinaryAndFullAscii)
{
    const GrainState state = randomState(50);
    for (const bool isCompressed : {false, true})
    {
        EXPECT_EQ(difference(state, roundTrip(inFormat("binary", 6, isCompressed), state)), 0);
        EXPECT_EQ(difference(state, roundTrip(inFormat("ascii", 17, isCompressed), state)), 0);
    }
}

TEST(GrainCloud, comesBackToTheWritePrecisionFromAscii)
{
    const GrainState state = randomState(50);
    const double error = difference(state, roundTrip(inFormat("ascii", 8), state));
    EXPECT_GT(error, 0);
    // Eight digits of the radius are half an ulp, 5e-8, and the mass has its cube.
    EXPECT_LT(error, 3*5e-8);
}

TEST(GrainCloud, numbersOfTheRunKeepEveryBitInAnyFormat)
{
    const GrainState state = randomState(2);
    EXPECT_EQ(roundTrip(inFormat("ascii", 3), state).numbers, state.numbers);
}

TEST(GrainCloud, mayBeEmpty)
{
    for (const word format : {"ascii", "binary"})
    {
        const GrainState back = roundTrip(inFormat(format), randomState(0));
        EXPECT_EQ(back.grains.size(), 0u);
        EXPECT_EQ(back.contacts.size(), 0u);
    }
}

TEST(GrainCloud, isACloudForOpenFOAM)
{
    for (const int n : {0, 30})
    {
        BoxMesh box(inFormat("binary"));
        ++box.time();
        const GrainState state = randomState(n);
        write(box, state);
        const passiveParticleCloud cloud(box.mesh(), "grains");
        EXPECT_EQ(cloud.size(), n);
        label i = 0;
        for (const passiveParticle& grain : cloud)
        {
            EXPECT_EQ(grain.origId(), state.grains.id[i]);
            EXPECT_LT(mag(grain.position() - toFoam(state.grains.position[i])), 1e-12);
            ++i;
        }
        for (const char* file : {"positions", "coordinates", "origId", "origProcId", "d", "U", "omega", "fContact"})
        {
            EXPECT_TRUE(isFile(box.time().timePath()/"lagrangian/grains"/file)) << file << ", " << n << " grains";
        }
    }
}

TEST(GrainCloud, materialsAreFoundByName)
{
    BoxMesh box(inFormat("ascii"));
    ++box.time();
    write(box, randomState(2));
    const GrainState back = readBack(box, twoMaterials("lead", "glass"));
    EXPECT_EQ(back.grains.material[0], 1);
    EXPECT_EQ(back.grains.material[1], 0);
    EXPECT_TRUE(holds(complaint([&] { readBack(box, twoMaterials("led", "glass")); }),
        {"no longer has", "value:   lead", "nearest: led", "grainState"}));
}

TEST(BadRestart, missingOrTruncatedFilesAreNamed)
{
    const std::vector<fileName> files =
    {
        "lagrangian/grains/position", "lagrangian/grains/d", "lagrangian/grains/origId", "lagrangian/grains/isFixed",
        "lagrangian/grains/temperature", "lagrangian/grains/fContact", "lagrangian/contacts/idA",
        "lagrangian/contacts/impulse", "uniform/grainState"
    };
    for (const fileName& file : files)
    {
        EXPECT_TRUE(holds(complaintWithout(file, 0), {file})) << "removed";
        for (const double share : {0.1, 0.6, 0.8})
        {
            EXPECT_TRUE(holds(complaintWithout(file, share), {file})) << "cut to " << share;
        }
    }
}

TEST(BadRestart, aTimeThatWasNotWrittenToItsEndIsNamed)
{
    BoxMesh box;
    ++box.time();
    EXPECT_FALSE(hasGrainState(box.mesh()));
    write(box, randomState(5));
    EXPECT_TRUE(hasGrainState(box.mesh()));
    rm(box.time().timePath()/"uniform/grainState");
    const std::vector<std::string> pieces = {"0.001/uniform/grainState", "not written to its end", "remove"};
    EXPECT_TRUE(holds(complaint([&] { hasGrainState(box.mesh()); }), pieces));
    // Nothing but the mark there, of a new time and of one written anew.
    rmDir(box.time().timePath());
    beginRunState(box.time());
    EXPECT_TRUE(holds(complaint([&] { hasGrainState(box.mesh()); }), pieces));
    write(box, randomState(5));
    beginRunState(box.time());
    EXPECT_TRUE(holds(complaint([&] { hasGrainState(box.mesh()); }), pieces));
}

TEST(BadRestart, aFileThatTheDiskDidNotTakeIsNamedAndLeavesTheTimeUnfinished)
{
    for (const bool isCompressed : {false, true})
    {
        BoxMesh box(inFormat(isCompressed ? "ascii" : "binary", 6, isCompressed));
        ++box.time();
        write(box, randomState(5));
        const fileName velocity = box.time().timePath()/(isCompressed ? "lagrangian/grains/U.gz" : "lagrangian/grains/U");
        std::ifstream whole(velocity);
        const std::string contents((std::istreambuf_iterator<char>(whole)), std::istreambuf_iterator<char>());
        checkWritten(box.time().timePath());
        for (const double share : {0.0, 0.5, 0.9})
        {
            std::ofstream(velocity) << contents.substr(0, std::size_t(share*contents.size()));
            std::string said;
            try { checkWritten(box.time().timePath()); }
            catch (const Foam::error& raised) { said = raised.message(); }
            EXPECT_TRUE(holds(said, {"lagrangian/grains/U", "is the disk full?", "remove"})) << share;
        }
    }
}

TEST(BadRestart, numbersThatTheRunNeedsMustBeThere)
{
    GrainState state = randomState(1);
    state.numbers.erase("exited");
    EXPECT_TRUE(holds(complaint([&] { roundTrip(inFormat("ascii"), state); }), {"uniform/grainState", "exited"}));
}

TEST(BadRestart, filesOfDifferentTimesDoNotFit)
{
    BoxMesh box(inFormat("ascii"));
    ++box.time();
    write(box, randomState(20));
    const fileName velocity = box.time().timePath()/"lagrangian/grains/U";
    cp(velocity, box.casePath()/"U");
    write(box, randomState(21));
    mv(box.casePath()/"U", velocity);
    EXPECT_TRUE(holds(complaint([&] { readBack(box); }), {"lagrangian/grains/U", "20 values", "21 values"}));
}

TEST(BadRestart, orientationsMustBeOfLengthOne)
{
    const auto complaintOf = [](const nscd::Quaternion& orientation)
    {
        GrainState state = randomState(5);
        state.grains.orientation[2] = orientation;
        return complaint([&] { roundTrip(inFormat("ascii"), state); });
    };
    const std::vector<std::string> pieces = {"lagrangian/grains", "keyword orientationW, orientation", "are damaged: grain 17", "length 1"};
    for (const nscd::Quaternion& q : {nscd::Quaternion(-1e30, 0, 0, 0), nscd::Quaternion(1e200, 0, 0, 0), nscd::Quaternion(0, 0, 0, 0), nscd::Quaternion(1, 0.2, 0, 0)})
    {
        EXPECT_TRUE(holds(complaintOf(q), pieces));
    }
    EXPECT_EQ(complaintOf(nscd::Quaternion(0.87, 0.5, 0, 0)), "");   // 30 degrees in two digits
}

TEST(BadRestart, contactsMustBeOfGrainsAndWallsThatAreThere)
{
    GrainState state = randomState(5);
    state.contacts.push_back({3, -5, Vec3::Zero()});
    EXPECT_TRUE(holds(complaint([&] { roundTrip(inFormat("ascii"), state); }), {"lagrangian/contacts", "3 and -5"}));
}
