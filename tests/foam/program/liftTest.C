// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lift in runs of the program: what a grain gets, what the balance says, sub-cycles, feedback off, discs.
#include "caseTools.H"
#include "programCase.H"

#include "IFstream.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const std::string lifts = "saffmanLift on; magnusLift on;";

/// U of the start: u = (0, 0, 8 x) in the cells of ProgramCase, so that curl u = (0, -8, 0) away from walls.
std::string shearedStart()
{
    std::ostringstream text;
    text << "dimensions [0 1 -1 0 0 0 0]; internalField nonuniform List<vector> 128 (";
    for (int cell = 0; cell < 128; ++cell) text << " (0 0 " << 8*0.025*(cell % 4 + 0.5) << ")";
    text << "); boundaryField { \"(left|right|bottom|top)\" { type slip; } front { type fixedValue; value uniform (0 0 0.4); } "
        "back { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); } }";
    return text.str();
}

/// One spinning grain in the middle of the cell whose fluid moves at 0.3 m/s (of 0.1, 0.3, 0.5, 0.7), in water of nu 1e-4.
std::string oneGrain(const std::string& forces, const std::string& more)
{
    return "materials { glass { density 2500; } } contacts { default { friction 0.3; } } grains { type table; file \"grain.txt\"; "
        "velocity (0.05 0.02 0.1); omega (3 5 -2); } patches { front { type wall; } back { type exit; } } "
        "forces { drag { law none; } " + forces + " } " + more;
}

/// Force of the fluid on it in the first step.
vector firstForce(const std::string& forces, const std::string& more)
{
    const ProgramCase c
    (
        Files{{"constant/grainProperties", oneGrain(forces, more)}, {"0/U", shearedStart()}},
        "endTime 1e-4; deltaT 1e-4; writeInterval 1; writePrecision 17;"
    );
    std::ofstream(c.path("constant/grain.txt")) << "0.0375 0.0375 0.0875 0.004\n";
    EXPECT_TRUE(succeeds(c.run()));
    IFstream is(c.path("0.0001/lagrangian/grains/fFluid"));
    token head(is);
    const dictionary header(is);
    return List<vector>(is)[0];
}

const std::string suspension =
    "materials { glass { density 2500; } } contacts { default { friction 0.3; } } patches { front { type wall; } back { type exit; } } "
    "grains { type lattice; box (0.01 0.01 0.01) (0.09 0.09 0.1); count (4 4 4); diameter 0.015; jitter 0.9; "
    "velocity (0.1 0.05 -0.3); omega (20 -30 10); } ";

} // namespace

TEST(Lift, isThePapersOnAGrainInAShearHoweverTheStepIsCut)
{
    // d 4 mm, mu 0.1: of us = (-0.05, -0.02, 0.2) and curl u = (0, -8, 0), by the formulas as the papers have them.
    const vector us(-0.05, -0.02, 0.2), w(0, -8, 0), omega(3, 5, -2), W = 0.5*w - omega;
    const double d = 4e-3, rho = 1000, mu = 0.1, pi = std::acos(-1.0), slip = mag(us);
    const double Re = rho*slip*d/mu, beta = mag(w)*d/(2*slip), ReW = rho*d*d*mag(W)/mu;
    const double C = (1 - 0.3314*std::sqrt(beta))*std::exp(-Re/10) + 0.3314*std::sqrt(beta);
    const double CW = 0.45 + (ReW/Re - 0.45)*std::exp(-0.05684*std::pow(ReW, 0.4)*std::pow(Re, 0.3));
    const vector saffman = 1.615*d*d*std::sqrt(rho*mu/mag(w))*C*(us ^ w);
    const vector magnus = 0.5*rho*pi/4*d*d*CW*slip*(W ^ us)/mag(W);
    for (const std::string more : {"feedback off;", "feedback off; timeStep { subCycles 3; }"})
    {
        const vector without = firstForce("", more);
        EXPECT_LT(mag(firstForce("saffmanLift on;", more) - without - saffman), 1e-9*mag(saffman)) << more;
        EXPECT_LT(mag(firstForce("magnusLift on;", more) - without - magnus), 1e-9*mag(magnus)) << more;
        EXPECT_LT(mag(firstForce(lifts, more) - without - saffman - magnus), 1e-9*mag(magnus)) << more;
        EXPECT_EQ(firstForce("saffmanLift off;", more), without) << more;
    }
    // Towards the faster fluid, at larger x.
    EXPECT_GT(saffman.x(), 0);
}

TEST(Lift, isBalancedBetweenGrainsAndFluid)
{
    std::vector<std::vector<double>> energies;
    for (const std::string forces : {"", "saffmanLift on;", "magnusLift on;", "saffmanLift on; magnusLift on;"})
    {
        const ProgramCase c(Files
        {
            {"constant/grainProperties", suspension + "forces { " + forces + " } timeStep { subCycles 2; }"}, {"0/U", shearedStart()},
            {"system/fvSolution", solutionWith(8)}
        });
        EXPECT_TRUE(succeeds(c.run()));
        EXPECT_LT(largest(c.reported("0", "momentumError")), 1e-10) << forces;
        energies.push_back(c.reported("0", "kineticEnergy"));
        for (std::size_t other = 0; other + 1 < energies.size(); ++other)
        {
            EXPECT_GT(std::abs(energies.back().back()/energies[other].back() - 1), 1e-6) << "the lift of " << forces << " does nothing";
        }
    }
}

TEST(Lift, isRefusedForDiscsInWords)
{
    BoxMeshSettings box = programBox();
    box.cells = labelVector(5, 8, 1);
    box.max = point(0.1, 0.2, 0.02);
    box.patchTypes = {"wall", "wall", "wall", "wall", "empty", "empty"};
    const std::string discs = "materials { glass { density 2500; } } contacts { default { friction 0.3; } } "
        "grains { type lattice; box (0 0 0) (0.1 0.2 0.02); count (2 2 1); diameter 0.01; }\n";
    for (const std::string name : {"saffmanLift", "magnusLift"})
    {
        const ProgramCase c(Files
        {
            {"constant/grainProperties", discs + "forces { " + name + " on; }"}, {"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);"}
        }, "", box);
        const ProgramRun run = c.run();
        EXPECT_EQ(run.status, 1);
        EXPECT_TRUE(holds(run.log, {"forces." + name, "spheres", "discs", "constant/grainProperties"}));
        EXPECT_TRUE(c.reported("0", "time").empty());
    }
}
