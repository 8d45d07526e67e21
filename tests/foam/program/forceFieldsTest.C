// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Force fields in runs of the program: exact motion, momentum of grains that the fluid has no part in, ranks, restarts, bad input.
#include "caseTools.H"
#include "programCase.H"
#include "writtenFields.H"

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string head = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } patches { front { type wall; } back { type exit; } } ";
const std::string some = "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2); diameter 0.01; velocity (0.1 0 0.2); } ";
const std::string weightless = "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);";

/// 0/push [m/s2], that grows with z.
std::string pushField()
{
    std::string text = "dimensions [0 1 -2 0 0 0 0]; internalField nonuniform List<vector> 128 (";
    for (int cell = 0; cell < 128; ++cell) text += " (" + std::to_string(cell % 4) + " 0 " + std::to_string(1 + cell/16) + ")";
    return text + "); boundaryField { \".*\" { type zeroGradient; } }";
}

Files pushed() { return {{"constant/grainProperties", head + some + "forces { field { fields (push); } }"}, {"0/push", pushField()}, {"system/fvSolution", solutionWith(8)}}; }

} // namespace

/// v is the integral of the acceleration at the end of each step, whatever the step.
TEST(ForceFields, moveAGrainExactly)
{
    Files files = dryFiles("fluid none; " + head + "grains { type table; file \"grain.txt\"; } "
        "forces { field { acceleration table ((0 (0 0 0)) (0.1 (0 0 20)) (0.15 (0 0 -40)) (1 (0 0 -40))); } }");
    files["constant/g"] = weightless;
    const ProgramCase c(files, "endTime 0.2; deltaT 0.02; writeInterval 1000;");
    std::ofstream(c.path("constant/grain.txt")) << "0.05 0.05 0.05 0.004\n";
    EXPECT_TRUE(succeeds(c.run()));
    const std::vector<double> time = c.reported("0", "time"), energy = c.reported("0", "kineticEnergy"), z = c.reported("0", "massCenterZ");
    const double mass = 2500*M_PI/6*6.4e-8;
    double height = 0.05;
    for (std::size_t k = 0; k < time.size(); ++k)
    {
        const double t = time[k], u = t - 0.1, w = t - 0.15;
        const double v = t <= 0.1 ? 100*t*t : t <= 0.15 ? 1 + 20*u - 600*u*u : 0.5 - 40*w;
        height += 0.02*v;
        EXPECT_NEAR(energy[k], 0.5*mass*v*v, 1e-10*mass) << t;
        EXPECT_NEAR(z[k], height, 1e-10) << t;
    }
}

/// Weight is the field of g, less what the fluid presses: the same fall with gravity, and without it in these two fields.
TEST(ForceFields, areAsGoodAsGravity)
{
    const std::string fields = "forces { field { acceleration (0 0 -9.81); forceDensity (0 0 9810); } }";
    const ProgramCase heavy(Files{{"constant/grainProperties", head + some}, {"system/fvSolution", solutionWith(8)}});
    const ProgramCase driven(Files{{"constant/grainProperties", head + some + fields}, {"constant/g", weightless}, {"system/fvSolution", solutionWith(8)}});
    EXPECT_TRUE(succeeds(heavy.run()));
    EXPECT_TRUE(succeeds(driven.run()));
    const std::vector<double> a = heavy.reported("0", "massCenterZ"), b = driven.reported("0", "massCenterZ");
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-9) << k;
    EXPECT_LT(largest(driven.reported("0", "momentumError")), 1e-9);
    // The force of the fluid has nothing of the field in it: it lacks the buoyancy that gravity makes.
    const vectorField force = grainVectors(heavy, "0.01/lagrangian/grains/fFluid"), forceDriven = grainVectors(driven, "0.01/lagrangian/grains/fFluid");
    const scalar buoyancy = 9810*M_PI/6*1e-6;
    forAll(force, i) EXPECT_LT(mag(force[i] - forceDriven[i] - vector(0, 0, buoyancy)), 1e-5*buoyancy) << i;
}

/// Without drag, pressure and stress the grains get what the field gives, and no more.
TEST(ForceFields, giveGrainsTheirIntegralAndTheFluidNothing)
{
    const auto files = [](const std::string& field)
    {
        return Files{{"constant/grainProperties", head + some + "feedback off; forces { drag { law none; } pressureGradient off; viscous off; spinDrag off; " + field + " }"}};
    };
    const std::string control = "endTime 0.02; writeInterval 20; ";
    const ProgramCase without(files(""), control), with(files("field { acceleration table ((0 (0 0 10)) (0.02 (5 0 30))); }"), control);
    EXPECT_TRUE(succeeds(without.run()));
    EXPECT_TRUE(succeeds(with.run()));
    const vectorField before = grainVectors(without, "0.02/lagrangian/grains/U"), after = grainVectors(with, "0.02/lagrangian/grains/U");
    forAll(before, i) EXPECT_LT(mag(after[i] - before[i] - vector(0.05, 0, 0.4)), 1e-9) << i;
    EXPECT_EQ(without.contents("0.02/U"), with.contents("0.02/U"));
    EXPECT_EQ(without.contents("0.02/p_rgh"), with.contents("0.02/p_rgh"));
}

TEST(ForceFields, goOnFromAWrittenTimeToTheBit)
{
    const std::string control = "writeFormat binary; writeInterval 10; ";
    const ProgramCase whole(pushed(), control + "endTime 0.02;"), parts(pushed(), control + "endTime 0.01;");
    EXPECT_TRUE(succeeds(whole.run()));
    EXPECT_TRUE(succeeds(parts.run()));
    parts.writeControl(control + "endTime 0.02;");
    EXPECT_TRUE(succeeds(parts.run()));
    for (const char* file : {"0.02/U", "0.02/lagrangian/grains/U", "0.02/lagrangian/grains/position", "0.02/push"})
    {
        EXPECT_FALSE(whole.contents(file).empty()) << file;
        EXPECT_TRUE(whole.contents(file) == parts.contents(file)) << file;
    }
    const ProgramCase without(Files{{"constant/grainProperties", head + some}, {"system/fvSolution", solutionWith(8)}}, control + "endTime 0.02;");
    EXPECT_TRUE(succeeds(without.run()));
    EXPECT_GT(std::abs(without.reported("0", "massCenterX").back() - whole.reported("0", "massCenterX").back()), 1e-6);
}

TEST(ForceFields, refuseBadInput)
{
    Files files = pushed();
    files["0/push"] = "";
    EXPECT_TRUE(isRefused(ProgramCase(files), {"forces.field.fields", "names a field that is not there", "push", "constant/grainProperties"}));
    const std::string dry = "fluid none; " + head + some;
    EXPECT_TRUE(isRefused(ProgramCase(dryFiles(dry + "forces { field { fields (push); } }")), {"forces.field.fields", "none is solved"}));
    EXPECT_TRUE(isRefused(ProgramCase(dryFiles(dry + "forces { feild { } }")), {"forces.feild", "nearest: field"}));
}

TEST(Ranks, pushGrainsAsOneRankDoes)
{
    const ProgramCase alone(pushed()), together(pushed());
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(2, 1, 2))));
    EXPECT_TRUE(succeeds(together.runOn(4)));
    for (const char* column : {"massCenterX", "massCenterZ"})
    {
        const std::vector<double> here = alone.reported("0", column), there = together.reported("0", column);
        ASSERT_EQ(here.size(), there.size());
        for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(here[k], there[k], 1e-9) << column << ' ' << k;
    }
}
