// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Films of the fluid between grains in runs of the program: their viscosity, what they take of an impact, ranks, and input that is refused.
#include "caseTools.H"
#include "rankRuns.H"

#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string film = "roughness 1e-5; lubricationRange 1e-3;";

/// Grains that fall onto the floor together, with more coefficients of contacts; water a hundred times as viscous as it is (0.1 Pa s).
Files falling(const std::string& coefficients)
{
    return
    {{"system/fvSolution", solutionWith(8)},
    {
        "constant/grainProperties",
        "materials { glass { density 2500; } } contacts { default { friction 0.3; restitution 0.4; " + coefficients + " } }"
        "grains { type lattice; box (0 0 0) (0.1 0.1 0.06); count (5 5 3); diameter 0.0195; velocity (0 0 -0.5); spread 0.002; jitter 0.5; }"
        "patches { front { type wall; } back { type exit; } } "
    }};
}

} // namespace

TEST(Lubrication, hasTheViscosityOfTheFluidUnlessItIsGivenOne)
{
    const std::string control = "endTime 0.02;";
    const ProgramCase ofFluid(falling(film), control), given(falling(film + " lubricationViscosity 0.1;"), control),
        thicker(falling(film + " lubricationViscosity 0.2;"), control), none(falling(""), control);
    for (const ProgramCase* c : {&ofFluid, &given, &thicker, &none}) EXPECT_TRUE(succeeds(c->run()));
    EXPECT_EQ(ofFluid.contents("postProcessing/grains/0/report.csv"), given.contents("postProcessing/grains/0/report.csv"));
    const auto energy = [](const ProgramCase& c) { return c.reported("0", "kineticEnergy").back(); };
    EXPECT_LT(energy(thicker), 0.99*energy(given));
    EXPECT_LT(energy(given), 0.99*energy(none));
    EXPECT_LT(largest(ofFluid.reported("0", "momentumError")), 1e-5);
}

TEST(Lubrication, isRefusedWhereItCannotAct)
{
    const auto refused = [](const std::string& coefficients, const Files& more, const std::vector<std::string>& pieces)
    {
        Files files = falling(coefficients);
        files.insert(more.begin(), more.end());
        return isRefused(ProgramCase(files), pieces);
    };
    EXPECT_TRUE(refused("roughness 1e-5;", {}, {"grainProperties", "lubricationRange", "missing"}));
    EXPECT_TRUE(refused("roughness -1e-6; lubricationRange 1e-3;", {}, {"roughness", "out of range"}));
    EXPECT_TRUE(refused("lubricationRange 1e-3;", {}, {"contacts.default.roughness is missing"}));
    EXPECT_TRUE(refused(film + " rollingFriction 0.1;", {}, {"has a roughness beside rolling or spinning friction"}));
    const Files powerLaw = {{"constant/transportProperties",
        "transportModel powerLaw; rho 1000; powerLawCoeffs { nuMax 1e-3; nuMin 1e-5; k 1e-4; n 0.8; } "}};
    EXPECT_TRUE(refused(film, powerLaw, {"transportProperties", "no one viscosity for the films", "powerLaw"}));
}

TEST(Ranks, haveFilmsBetweenGrainsAsOneRankHas)
{
    const std::string control = "writeFormat binary; endTime 0.02; writeInterval 10;";
    // Solved to round-off, or nearly: what is left is what ranks may differ by.
    Files files = falling(film);
    files["constant/grainProperties"] += "solver { tolerance 1e-8; displacementTolerance 1e-11; maxSweeps 100000; }";
    const ProgramCase alone(files, control);
    EXPECT_TRUE(succeeds(alone.run()));
    runOnTwoAndThree(files, control, [&](const ProgramCase& together) { expectSameMotion(alone, together, 0.0195, 12); });
    const ProgramCase whole(falling(film), control), stopped(falling(film), "writeFormat binary; endTime 0.01; writeInterval 10;");
    runWholeAndInParts(whole, stopped, labelVector(2, 1, 1), control);
    EXPECT_EQ(filesThatDiffer(whole, stopped, 2, "0.02"), std::vector<std::string>());
}
