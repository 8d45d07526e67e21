// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag laws in runs of the program: a table of a user's own, mixes of sizes on any number of ranks, warnings beyond a law's range.
#include "caseTools.H"
#include "programCase.H"

#include "IFstream.H"

#include <cmath>
#include <fstream>
#include <map>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string firstStep = "endTime 1e-4; deltaT 1e-4; writeInterval 1; writePrecision 17;";

const std::string head = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } "
    "patches { front { type wall; } back { type exit; } } ";

std::size_t countOf(const std::string& text, const std::string& word)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

template<class Type>
List<Type> cloudField(const fileName& file)
{
    IFstream is(file);
    token word(is);
    const dictionary header(is);
    return List<Type>(is);
}

/// Force of the fluid by the grain's identity, of one or of all ranks.
std::map<label, vector> forces(const ProgramCase& c, label ranks)
{
    std::map<label, vector> found;
    for (label rank = 0; rank < ranks; ++rank)
    {
        const fileName processor = ranks > 1 ? fileName("processor" + std::to_string(rank)) : fileName(".");
        const fileName folder = c.path(processor/"0.0001/lagrangian/grains");
        const List<vector> force = cloudField<vector>(folder/"fFluid");
        const List<label> id = cloudField<label>(folder/"origId");
        forAll(id, i) found[id[i]] = force[i];
    }
    return found;
}

/// 36 grains of three sizes about the corners of cells, which hold parts of eight of them, that sink in water at rest.
void writeMix(const ProgramCase& c)
{
    std::ofstream file(c.path("constant/mix.txt"));
    file.precision(17);
    for (int i = 0; i < 36; ++i)
    {
        const int x = i % 3, y = i/3 % 3, z = i/9;
        const double d[] = {0.008, 0.014, 0.02};
        file << 0.025*(1 + x) << " " << 0.025*(1 + y) << " " << 0.025*(1 + z) << " " << d[(x + y + z) % 3] << "\n";
    }
}

} // namespace

namespace
{

/// Drag on one sphere in the first step, F = A/2 rho Cd U_s^2 of a table with Cd = 3 at every Re: of 1/(1 + k/2) to the order of the step.
void expectForceOfTable(const std::string& shape, const Files& fields, const BoxMeshSettings& box)
{
    Files files = fields;
    files["constant/grainProperties"] = shape + head + "feedback off; grains { type table; file \"grain.txt\"; velocity (0 0 -0.2); } "
        "forces { drag { law table; table \"cd.txt\"; } pressureGradient off; viscous off; spinDrag off; }";
    const ProgramCase c(files, firstStep, box);
    std::ofstream(c.path("constant/grain.txt")) << "0.0375 0.0375 0.0875 0.004\n";
    std::ofstream(c.path("constant/cd.txt")) << "1 1 3\n1000 1 3\n";
    ASSERT_TRUE(succeeds(c.run()));
    const vector force = cloudField<vector>(c.path("0.0001/lagrangian/grains/fFluid"))[0];
    const double d = 4e-3, pi = std::acos(-1.0), volume = pi*d*d*d/6, buoyancy = 1000*volume*9.81;
    const double drag = 0.5*1000*3*pi/4*d*d*0.2*0.2;
    EXPECT_NEAR((force.z() - buoyancy)/drag, 1, 0.02);
}

} // namespace

TEST(DragInRuns, aTableGivesItsForce)
{
    expectForceOfTable("", Files(), programBox());
}

TEST(DragInRuns, spheresInAPlaneFeelTheForceOfSpheres)
{
    BoxMeshSettings box = programBox();
    box.cells.y() = 1;
    box.patchTypes[2] = box.patchTypes[3] = "empty";
    const std::string open = "\"(bottom|top)\" { type empty; } back { ";
    const Files fields =
    {
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { \"(left|right|front)\" { type noSlip; } " + open
          + "type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }"},
        {"0/p_rgh", "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField { \"(left|right|front)\" { type fixedFluxPressure; "
            "value uniform 0; } " + open + "type fixedValue; value uniform 0; } }"}
    };
    expectForceOfTable("shape sphere; ", fields, box);
}

// The mean diameter of a cell is made of grains of all ranks: the forces are those of one rank, to what the pressure solver leaves.
TEST(Ranks, dragAMixOfSizesAsOneRankDoes)
{
    const std::string drag = "grains { type table; file \"mix.txt\"; velocity (0.02 0 -0.1); } forces { drag { law Beetstra; polydisperse ";
    const Files mixed{{"constant/grainProperties", head + drag + "on; } }"}}, equal{{"constant/grainProperties", head + drag + "off; } }"}};
    const ProgramCase alone(mixed, firstStep), without(equal, firstStep);
    for (const ProgramCase* c : {&alone, &without})
    {
        writeMix(*c);
        ASSERT_TRUE(succeeds(c->run()));
    }
    const std::map<label, vector> expected = forces(alone, 1), other = forces(without, 1);
    ASSERT_EQ(expected.size(), 36u);
    scalar largest = 0, change = 0;
    for (const auto& [id, force] : expected)
    {
        largest = std::max(largest, mag(force));
        change = std::max(change, mag(force - other.at(id)));
    }
    // Most of the force is buoyancy.
    const scalar tolerance = 1e-5*largest;
    EXPECT_GT(change, 200*tolerance) << "the sizes should matter";
    for (const labelVector& parts : {labelVector(1, 1, 2), labelVector(2, 1, 1), labelVector(2, 2, 1)})
    {
        const ProgramCase together(mixed, firstStep);
        writeMix(together);
        ASSERT_TRUE(succeeds(together.decompose(parts)));
        const label ranks = parts.x()*parts.y()*parts.z();
        ASSERT_TRUE(succeeds(together.runOn(ranks)));
        const std::map<label, vector> found = forces(together, ranks);
        ASSERT_EQ(found.size(), expected.size());
        for (const auto& [id, force] : found) EXPECT_LT(mag(force - expected.at(id)), tolerance) << id << " on " << ranks;
    }
}

TEST(DragInRuns, whatIsBeyondALawsRangeIsSaidOnceAndCounted)
{
    const auto logOf = [](const std::string& law)
    {
        const ProgramCase c(Files{{"constant/grainProperties", head + "grains { type lattice; box (0.01 0.01 0.01) (0.09 0.09 0.1); "
            "count (4 4 4); diameter 0.015; velocity (0 0 -0.1); } forces { drag { law " + law + "; } }"}});
        const ProgramRun run = c.run();
        EXPECT_TRUE(succeeds(run));
        return run.log;
    };
    const std::string stokes = logOf("Stokes");
    EXPECT_EQ(countOf(stokes, "grains slip faster than the drag law is meant for"), 1u);
    EXPECT_EQ(countOf(stokes, "in fluid fractions that the drag law is not meant for"), 1u);
    EXPECT_EQ(countOf(stokes, "drag beyond its Re"), 1u) << "in the summary";
    EXPECT_EQ(countOf(stokes, "drag beyond its alpha"), 1u) << "in the summary";
    EXPECT_EQ(countOf(logOf("DiFelice"), "drag beyond"), 0u);
}
