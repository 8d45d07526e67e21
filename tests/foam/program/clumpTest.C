// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Clumps in runs of the program: alone, in a fluid that does not feel them and in one that does, through exits, over restarts.
#include "caseTools.H"
#include "programCase.H"

#include "closures/dragLaws.hpp"
#include "nscd/scene/clumpForm.hpp"

#include <algorithm>
#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

using nscd::Vec3;

const std::string head = "materials { glass { density 2500; } } contacts { default { friction 0.3; restitution 0.2; } } "
    "patches { front { type wall; } back { type exit; } } ";

/// Two balls of 4 mm that touch, along x or z.
const std::vector<nscd::Ball> along(const Vec3& axis) { return {{0.002*axis, 0.002}, {-0.002*axis, 0.002}}; }
const std::string alongX = "members ((-0.002 0 0) (0.002 0 0)); diameter 0.004; ", alongZ = "members ((0 0 -0.002) (0 0 0.002)); diameter 0.004; ";

/// Three balls of 10 mm, each in the others.
const std::string pebble = "members ((0 0 0) (0.005 0 0) (0.002 0.004 0.001)); diameter 0.01; ";
const std::vector<nscd::Ball> pebbleBalls = {{Vec3(0, 0, 0), 0.005}, {Vec3(0.005, 0, 0), 0.005}, {Vec3(0.002, 0.004, 0.001), 0.005}};

std::string lattice(const std::string& where, const std::string& clump)
{
    return "grains { type lattice; " + where + " diameter 0.01; clump { " + clump + "} } ";
}

const std::string middle = "box (0.045 0.045 0.175) (0.055 0.055 0.185); count (1 1 1);", eight = "box (0.01 0.01 0.01) (0.09 0.09 0.07); count (2 2 2);";

nscd::ClumpForm formOf(const std::vector<nscd::Ball>& members)
{
    const nscd::GrainShape shape;
    return nscd::formOf(nscd::makeClumpShape(members, 2500, shape), shape);
}

/// Speed at which the law carries the submerged weight of a clump that falls along z in the fluid of ProgramCase.
double terminalSpeed(const std::string& law, const std::vector<nscd::Ball>& members)
{
    const nscd::ClumpForm form = formOf(members);
    closures::DragState state{closures::sphereSize(form.equivalentDiameter()), 0, 1, 1000, 0.1};
    state.sphericity = form.sphericity();
    state.crosswiseSphericity = state.size.frontalArea/nscd::projectedArea(members, Vec3::UnitZ());
    double low = 1e-6, high = 10;
    for (int k = 0; k < 200; ++k)
    {
        state.slip = std::sqrt(low*high);
        (closures::findDragLaw(law).law(state)*state.slip > 1500*form.volume*9.81 ? high : low) = state.slip;
    }
    return low;
}

double lastSpeed(const ProgramCase& c)
{
    const std::vector<double> height = c.reported("0", "massCenterZ"), time = c.reported("0", "time");
    const std::size_t n = height.size();
    return -(height[n - 1] - height[n - 2])/(time[n - 1] - time[n - 2]);
}

} // namespace

// Sphericity 0.794; the way it lies matters to one law and not to the other.
TEST(ClumpsInRuns, oneSettlesAtTheSpeedOfItsLaw)
{
    for (const std::string law : {"HaiderLevenspiel", "HoelzerSommerfeld", "DiFelice"})
    {
        for (const auto& [clump, members] : {std::pair(alongX, along(Vec3::UnitX())), std::pair(alongZ, along(Vec3::UnitZ()))})
        {
            const Files files{{"constant/grainProperties", head + lattice(middle, clump + "orientation asGiven; ") + "feedback off; forces { drag { law " + law + "; } }"}};
            const ProgramCase c(files, "deltaT 4e-3; endTime 0.6; writeInterval 1000;");
            ASSERT_TRUE(succeeds(c.run()));
            EXPECT_NEAR(lastSpeed(c)/terminalSpeed(law, members), 1, 1e-6) << law << ": " << clump;
        }
    }
    EXPECT_GT(terminalSpeed("HoelzerSommerfeld", along(Vec3::UnitZ())), 1.05*terminalSpeed("HoelzerSommerfeld", along(Vec3::UnitX())));
    EXPECT_GT(terminalSpeed("DiFelice", along(Vec3::UnitZ())), 1.02*terminalSpeed("HaiderLevenspiel", along(Vec3::UnitZ())));
}

// J omega' = -C omega, C = pi mu d^3 of the sphere of the same volume.
TEST(ClumpsInRuns, spinDecaysAsThatOfTheSphereOfItsVolume)
{
    const std::string spinning = lattice("omega (0 0 10); " + middle, alongX + "orientation asGiven; ");
    const ProgramCase c(Files{{"constant/grainProperties", head + spinning + "feedback off;"}}, "deltaT 1e-3; endTime 0.01; writeInterval 1000;");
    ASSERT_TRUE(succeeds(c.run()));
    const nscd::GrainShape shape;
    const nscd::ClumpShape clump = nscd::makeClumpShape(along(Vec3::UnitX()), 2500, shape);
    const double coefficient = closures::sphereSpinDrag(formOf(along(Vec3::UnitX())).equivalentDiameter(), 0.1);
    const double inertia = clump.inertia(2, 2), spin = 10*std::pow(1 + 1e-3*coefficient/inertia, -10);
    EXPECT_LT(spin, 9.0);
    const double speed = c.reported("0", "massCenterZ").size() > 1 ? lastSpeed(c) : 0;
    EXPECT_NEAR(c.reported("0", "kineticEnergy").back() - 0.5*clump.mass*speed*speed, 0.5*inertia*spin*spin, 1e-6*inertia*spin*spin);
}

TEST(ClumpsInRuns, theFluidHasTheVolumeOfTheirUnionAndLosesWhatTheyGain)
{
    const ProgramCase c(Files{{"constant/grainProperties", head + lattice("velocity (0 0 -0.3); " + eight, pebble) + "forces { drag { law HoelzerSommerfeld; } }"},
                              {"system/fvSolution", solutionWith(8)}}, "endTime 0.1; writeInterval 1000;");
    const ProgramRun run = c.run();
    ASSERT_TRUE(succeeds(run));
    const double volume = 8*formOf(pebbleBalls).volume, members = 24*std::acos(-1.0)/6*1e-6;
    EXPECT_LT(volume, 0.8*members);
    for (const double solid : c.reported("0", "solidVolume")) EXPECT_NEAR(solid, volume, 1e-12*volume);
    for (const double grains : c.reported("0", "grainVolume")) EXPECT_NEAR(grains, volume, 1e-12*volume);
    EXPECT_LT(largest(c.reported("0", "momentumError")), 1e-9);
    EXPECT_GT(largest(c.reported("0", "contacts")), 0) << "some should have come to the floor";
    EXPECT_NE(run.log.find("24 spheres, those of 8 clumps included"), std::string::npos) << run.log;
}

/// Falls, lands and drags its fluid along as a sphere does.
TEST(ClumpsInRuns, oneBallIsASphereToTheFluidToo)
{
    const std::string where = "velocity (0.05 0 -0.5); box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2);";
    const ProgramCase clumps(Files{{"constant/grainProperties", head + lattice(where, "members ((0 0 0)); diameter 0.01; ")}}, "endTime 0.1; writeInterval 1000;");
    const ProgramCase spheres(Files{{"constant/grainProperties", head + "grains { type lattice; " + where + " diameter 0.01; }"}}, "endTime 0.1; writeInterval 1000;");
    for (const ProgramCase* c : {&clumps, &spheres}) ASSERT_TRUE(succeeds(c->run()));
    EXPECT_GT(largest(spheres.reported("0", "contacts")), 0);
    for (const char* column : {"massCenterX", "massCenterZ", "kineticEnergy", "solidVolume", "courantMax", "momentumError"})
    {
        const std::vector<double> found = clumps.reported("0", column), expected = spheres.reported("0", column);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-5*std::abs(expected[k]) + 1e-10) << column << " " << k;
    }
}

TEST(ClumpsInRuns, goOnFromAWrittenTimeAsIfNeverStopped)
{
    const std::vector<std::string> stateFiles =
    {
        "lagrangian/grains/position", "lagrangian/grains/U", "lagrangian/grains/clump", "lagrangian/grains/memberCenter", "lagrangian/grains/dragDebt",
        "lagrangian/grains/fFluid", "lagrangian/clumps/position", "lagrangian/clumps/U", "lagrangian/clumps/omega", "lagrangian/clumps/orientation",
        "lagrangian/clumps/angularMomentum", "lagrangian/clumps/mass", "lagrangian/contacts/impulse", "uniform/grainState"
    };
    const std::string falling = "velocity (0.3 0.1 -0.5); " + eight, binary = "writeFormat binary; writeInterval 20; ";
    const std::string wet = "forces { drag { law Gidaspow; } }";
    for (const std::string& fluid : {std::string("fluid none;"), wet})
    {
        const Files files = fluid == wet ? Files{{"constant/grainProperties", head + lattice(falling, pebble) + fluid}} : dryFiles(head + lattice(falling, pebble) + fluid);
        const ProgramCase whole(files, binary + "endTime 0.04;"), parts(files, binary + "endTime 0.02;");
        for (const ProgramCase* c : {&whole, &parts}) ASSERT_TRUE(succeeds(c->run()));
        // The shapes are those that were written.
        parts.write("constant/grainProperties", head + "grains { type lattice; box (0 0 0) (1 1 1); count (1 1 1); diameter 0.1; }" + fluid);
        parts.writeControl(binary + "endTime 0.04;");
        ASSERT_TRUE(succeeds(parts.run()));
        EXPECT_GT(largest(whole.reported("0", "contacts")), 0);
        for (const std::string& file : stateFiles)
        {
            EXPECT_FALSE(whole.contents("0.04/" + file).empty()) << file;
            EXPECT_EQ(whole.contents("0.04/" + file), parts.contents("0.04/" + file)) << file << ", " << fluid;
        }
    }
}

// A clump leaves with the first of its members; the others stay what they are.
TEST(ClumpsInRuns, leaveThroughExitsAsWholes)
{
    const std::string rising = "grains { up { type lattice; velocity (0 0 2); box (0.03 0.03 0.16) (0.07 0.07 0.18); count (2 2 1); diameter 0.01; clump { " + pebble
        + "} } down { type lattice; box (0.03 0.03 0.05) (0.07 0.07 0.06); count (2 1 1); diameter 0.01; clump { " + pebble + "} } "
        "single { type lattice; velocity (0 0 2); box (0.04 0.04 0.19) (0.05 0.05 0.2); count (1 1 1); diameter 0.004; } } ";
    for (const std::string fluid : {"fluid none;", ""})
    {
        const Files files = fluid.empty() ? Files{{"constant/grainProperties", head + rising}} : dryFiles(head + rising + fluid);
        const ProgramCase c(files, "endTime 0.03;");
        ASSERT_TRUE(succeeds(c.run()));
        EXPECT_EQ(c.reported("0", "exited").back(), 13) << fluid;
        EXPECT_EQ(c.reported("0", "grains").back(), 6) << fluid;
        EXPECT_EQ(c.reported("0", "clumps").front(), 6) << fluid;
        EXPECT_EQ(c.reported("0", "clumps").back(), 2) << fluid;
        // From there on as well.
        c.writeControl("endTime 0.04;");
        ASSERT_TRUE(succeeds(c.run()));
        EXPECT_EQ(c.reported("0.03", "grains").back(), 6) << fluid;
    }
}

TEST(BadStart, clumpsStandBesideNoOtherLawsAndAreNoDiscsInAFluid)
{
    const std::string alone = lattice(middle, alongX);
    const auto refused = [](const std::string& properties, const std::vector<std::string>& pieces, const BoxMeshSettings& box = programBox())
    {
        return isRefused(ProgramCase(Files{{"constant/grainProperties", properties}}, "", box), pieces);
    };
    EXPECT_TRUE(refused(with(head, "friction 0.3;", "friction 0.3; roughness 1e-5; lubricationRange 1e-3;") + alone, {"lubrication, which contacts of clumps do not know"}));
    EXPECT_TRUE(refused(head + alone + "solver { type queue; }", {"solver.type", "knows no clumps"}));
    EXPECT_TRUE(refused(head + alone + "heat { law Gunn; fluid { heatCapacity 4182; conductivity 6; } materials { default { heatCapacity 800; temperature 300; } } }", {"heat", "stands beside clumps"}));
    BoxMeshSettings flat = programBox();
    flat.cells.y() = 1;
    flat.patchTypes[2] = flat.patchTypes[3] = "empty";
    EXPECT_TRUE(refused(head + alone, {"fluid", "around clumps of discs"}, flat));
}

