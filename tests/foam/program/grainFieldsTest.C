// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of grainFields in nscdDEMFoam: with OpenFOAM's fieldAverage, on two ranks, over restarts, and bad input.
#include "caseTools.H"
#include "programCase.H"
#include "writtenFields.H"

#include "OSspecific.H"

#include <cmath>
#include <sstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

// Probes are in the middle of a grain at the start.
const std::string functions = "functions\n{\nfields { type grainFields; }\n"
    "average { type fieldAverage; libs (fieldFunctionObjects); writeControl writeTime; fields ("
    "U.grains { mean on; prime2Mean off; base time; } T.grains { mean on; prime2Mean off; base time; } ); }\n"
    "probes { type probes; libs (sampling); fields (U.grains T.grains); probeLocations ((0.03 0.03 0.03)); writePrecision 12; }\n}\n";

const std::vector<const char*> names = {"bulkDensity.grains", "U.grains", "T.grains", "kineticStress.grains"};

constexpr scalar cellVolume = 0.025*0.025*0.025;
constexpr double grainMass = 2500*M_PI/6*1e-6;

/// Two layers of grains in the same cells that go different ways and touch nothing.
Files movingFiles()
{
    return {{"constant/grainProperties",
        "materials { glass { density 2500; } } contacts { default { friction 0.3; } }"
        "grains { slow { type lattice; box (0.02 0.02 0.021) (0.08 0.08 0.041); count (3 3 1); diameter 0.01; velocity (0.1 0 0); }"
        "quick { type lattice; box (0.02 0.02 0.034) (0.08 0.08 0.054); count (3 3 1); diameter 0.01; velocity (0 -0.2 0.3); } }"
        "patches { front { type wall; } back { type exit; } }"}};
}

/// Mass of the grains, and their kinetic energy but for spins, as the report has them.
void expectMassAndEnergy(const ProgramCase& c, const std::string& startTime, const std::string& time)
{
    const scalarField density = cellValues<scalar>(c, time + "/bulkDensity.grains");
    const vectorField velocity = cellValues<vector>(c, time + "/U.grains");
    const symmTensorField stress = cellValues<symmTensor>(c, time + "/kineticStress.grains");
    EXPECT_NEAR(cellVolume*sum(density), 18*grainMass, 1e-10*grainMass);
    const scalar energy = 0.5*cellVolume*sum(density*magSqr(velocity) + tr(stress));
    const scalar reported = c.reported(startTime, "kineticEnergy").back();
    EXPECT_GT(reported, 0);
    // Spins that the fluid gave are 2e-7 of it.
    EXPECT_NEAR(energy, reported, 1e-6*reported);
    EXPECT_GT(cellVolume*sum(tr(stress)), 0.1*reported);
}

/// Momentum of the grains as written, and their energy with that of their spins, which the fields leave out.
void expectMomentumAndSpins(const ProgramCase& c, const std::string& startTime, const std::string& time)
{
    const scalarField density = cellValues<scalar>(c, time + "/bulkDensity.grains");
    const vectorField velocity = cellValues<vector>(c, time + "/U.grains");
    const vectorField ofGrains = grainVectors(c, time + "/lagrangian/grains/U"), spins = grainVectors(c, time + "/lagrangian/grains/omega");
    ASSERT_EQ(ofGrains.size(), 18);
    const vector momentum = grainMass*sum(ofGrains);
    EXPECT_LT(mag(cellVolume*sum(density*velocity) - momentum), 1e-10*mag(momentum));
    const scalar inertia = 0.4*grainMass*sqr(0.005);
    const scalar energy = 0.5*sum(grainMass*magSqr(ofGrains) + inertia*magSqr(spins));
    const scalar reported = c.reported(startTime, "kineticEnergy").back();
    EXPECT_NEAR(energy, reported, 1e-9*reported);
}

/// Mean over the rows of a vector that OpenFOAM's probes wrote, and their number.
std::pair<vector, label> meanProbed(const ProgramCase& c, const std::string& file)
{
    std::istringstream lines(c.contents(file));
    vector sum = Zero;
    label rows = 0;
    for (std::string line; std::getline(lines, line);)
    {
        if (line.empty() || line.find('#') != std::string::npos) continue;
        IStringStream is(line);
        scalar time;
        vector value;
        is >> time >> value;
        sum += value;
        ++rows;
    }
    return {sum/scalar(max(rows, label(1))), rows};
}

} // namespace

TEST(GrainFields, serveFieldAverageAndProbes)
{
    const ProgramCase c(movingFiles(), functions);
    EXPECT_TRUE(succeeds(c.run()));
    expectMassAndEnergy(c, "0", "0.01");
    expectMomentumAndSpins(c, "0", "0.01");
    const std::pair<vector, label> probed = meanProbed(c, "postProcessing/probes/0/U.grains");
    EXPECT_EQ(probed.second, 10);
    const vector mean = cellValues<vector>(c, "0.01/U.grainsMean")[1 + 4*1 + 16*1];
    EXPECT_GT(mag(mean), 0.05);
    EXPECT_LT(mag(mean - probed.first), 1e-9*mag(mean));
    EXPECT_FALSE(c.contents("0.01/T.grainsMean").empty());
    // Written with the run's own times alone.
    EXPECT_FALSE(isDir(c.path("0.001")));
    c.writeControl("endTime 0.015; writeInterval 15; " + functions);
    EXPECT_TRUE(succeeds(c.run()));
    expectMassAndEnergy(c, "0.01", "0.015");
    expectMomentumAndSpins(c, "0.01", "0.015");
}

TEST(GrainFields, areNotThereWhereTheyAreNotNamed)
{
    const ProgramCase c(movingFiles());
    EXPECT_TRUE(succeeds(c.run()));
    for (const char* field : names) EXPECT_TRUE(c.contents(std::string("0.01/") + field).empty()) << field;
}

TEST(Ranks, grainFieldsAreThoseOfOneRank)
{
    const ProgramCase alone(movingFiles(), functions), together(movingFiles(), functions);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(2, 1, 1))));
    EXPECT_TRUE(succeeds(together.runOn(2)));
    EXPECT_TRUE(succeeds(together.run("reconstructPar", "-latestTime")));
    expectMassAndEnergy(together, "0", "0.01");
    // The fluid is solved to 1e-10, and moves the grains.
    for (const char* field : {"U.grains", "U.grainsMean"})
    {
        const vectorField u = cellValues<vector>(alone, std::string("0.01/") + field);
        EXPECT_LT(max(mag(u - cellValues<vector>(together, std::string("0.01/") + field))), 1e-7*max(mag(u))) << field;
    }
    const scalarField t = cellValues<scalar>(alone, "0.01/T.grains");
    EXPECT_LT(max(mag(t - cellValues<scalar>(together, "0.01/T.grains"))), 1e-7*max(t));
}

TEST(GrainFields, refuseBadInput)
{
    const std::string start = "functions\n{\nfields\n{\ntype grainFields;\n";
    EXPECT_TRUE(isRefused(ProgramCase(movingFiles(), start + "writeContol none; } }"), {"system/controlDict", "line ", "writeContol", "nearest: writeControl"}));
    const Files dry = dryFiles(movingFiles()["constant/grainProperties"] + " fluid none;");
    EXPECT_TRUE(isRefused(ProgramCase(dry, start + "} }"), {"system/controlDict", "functions.fields", "needs a fluid", "fluid none"}));
}
