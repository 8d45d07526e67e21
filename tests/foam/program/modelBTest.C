// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of `forces { model B; }` against model A where both must agree: a bed's pressure drop, a suspension that sinks, the balance of momentum.
#include "caseTools.H"
#include "programCase.H"
#include "writtenFields.H"

#include <algorithm>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// A grain in each cell, so that the fluid fraction is the same everywhere: 1 - pi/6 0.6^3 = 0.887.
std::string lattice(const std::string& motion, const std::string& forces, const std::string& more)
{
    return "materials { glass { density 2500; } } contacts { default { friction 0.3; } } motion " + motion + "; forces { " + forces + " }"
        "grains { type lattice; box (0 0 0) (0.1 0.1 0.2); count (4 4 8); diameter 0.015; }" + more;
}

const std::string viscous = "transportModel Newtonian; nu 1e-2; rho 1000;";

/// Held grains that fluid passes at 0.1 m/s between them, walls slip.
Files bedFiles(const std::string& forces)
{
    return
    {
        {"constant/grainProperties", lattice("fixed", forces, "patches { front { type wall; } back { type exit; } }")},
        {"constant/transportProperties", viscous}, {"system/fvSolution", solutionWith(8)},
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0.1); boundaryField { "
            "\"(left|right|bottom|top)\" { type slip; } front { type fixedValue; value uniform (0 0 0.1); } back { type zeroGradient; } }"},
    };
}

/// All sides are periodic, and the mixture as a whole is held.
ProgramCase suspension(const std::string& forces)
{
    BoxMeshSettings box = programBox();
    box.patchTypes = wordList(6, word("cyclic"));
    const std::string cyclic = "boundaryField { \".*\" { type cyclic; } }";
    const Files files
    {
        {"constant/grainProperties", lattice("free", forces, "meanFlow (0 0 0);")},
        {"constant/transportProperties", viscous},
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);" + cyclic},
        {"0/p_rgh", "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;" + cyclic},
    };
    return ProgramCase(files, "endTime 0.06; writeInterval 60; ", box);
}

/// Mean pressure gradient between the first and the last layer of cells [Pa/m].
scalar gradientOf(const ProgramCase& c)
{
    const scalarField p = cellValues<scalar>(c, "0.02/p_rgh");
    return (p[0] - p[16*7])/(7*0.025);
}

const std::string steady = "endTime 0.02; writeInterval 20; ";

/// Slip of the grains against the fluid [m/s].
scalar slipOf(const ProgramCase& c)
{
    return (cellValues<vector>(c, "0.06/U")[0] - grainVectors(c, "0.06/lagrangian/grains/U")[0]).z();
}

} // namespace

TEST(ModelB, hasThePressureDropOfModelAInAUniformBed)
{
    const ProgramCase a(bedFiles("model A;"), steady), b(bedFiles("model B;"), steady);
    EXPECT_TRUE(succeeds(a.run()));
    EXPECT_TRUE(succeeds(b.run()));
    EXPECT_GT(gradientOf(a), 100);
    EXPECT_NEAR(gradientOf(b)/gradientOf(a), 1, 1e-6);
    // On the grain: drag over alpha, which in model A is drag and pressure.
    const vectorField forceA = grainVectors(a, "0.02/lagrangian/grains/fFluid"), forceB = grainVectors(b, "0.02/lagrangian/grains/fFluid");
    EXPECT_NEAR(sum(forceB).z()/sum(forceA).z(), 1, 1e-6);
    EXPECT_LT(largest(b.reported("0", "momentumError")), 1e-9) << largest(a.reported("0", "momentumError"));
}

TEST(ModelB, letsAUniformSuspensionSinkAsModelADoes)
{
    const ProgramCase a = suspension("model A;"), b = suspension("model B;");
    EXPECT_TRUE(succeeds(a.run()));
    EXPECT_TRUE(succeeds(b.run()));
    EXPECT_GT(slipOf(a), 0.01);
    EXPECT_NEAR(slipOf(b)/slipOf(a), 1, 1e-5);
    EXPECT_LT(largest(b.reported("0", "momentumError")), 1e-7);
}

/// Grains that fall through water, far from uniform.
TEST(ModelB, balancesMomentum)
{
    const std::string base = "materials { glass { density 2500; } } contacts { default { friction 0.3; } }"
        "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2); diameter 0.01; }"
        "patches { front { type wall; } back { type exit; } }";
    Files files{{"constant/grainProperties", base + "forces { model B; }"}, {"system/fvSolution", solutionWith(8)}};
    const ProgramCase b(files, "endTime 0.02; ");
    const ProgramRun run = b.run();
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.log.find("model B"), std::string::npos);
    EXPECT_LT(largest(b.reported("0", "momentumError")), 1e-6);
}

TEST(Ranks, modelBIsThatOfOneRank)
{
    const ProgramCase alone(bedFiles("model B;"), steady), together(bedFiles("model B;"), steady);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(1, 1, 2))));
    EXPECT_TRUE(succeeds(together.runOn(2)));
    EXPECT_TRUE(succeeds(together.run("reconstructPar", "-latestTime")));
    EXPECT_NEAR(gradientOf(together)/gradientOf(alone), 1, 1e-6);
}

TEST(ModelB, refusesBadInput)
{
    const auto isRefusedWith = [](const std::string& forces, std::vector<std::string> pieces)
    {
        pieces.push_back("constant/grainProperties");
        return isRefused(ProgramCase(bedFiles(forces), steady), pieces);
    };
    EXPECT_TRUE(isRefusedWith("model C;", {"forces.model", "C", "A, B"}));
    EXPECT_TRUE(isRefusedWith("modle B;", {"forces.modle", "nearest: model"}));
    EXPECT_TRUE(isRefusedWith("model B; pressureGradient on;", {"forces.pressureGradient", "belongs to model A"}));
    EXPECT_TRUE(isRefusedWith("model B; viscous on;", {"forces.viscous", "belongs to model A"}));
    EXPECT_TRUE(isRefusedWith("model B; saffmanLift on;", {"forces.saffmanLift", "not part of model B"}));
    EXPECT_TRUE(isRefusedWith("model B; } feedback off; dummy {", {"forces.model", "feedback off"}));
}
