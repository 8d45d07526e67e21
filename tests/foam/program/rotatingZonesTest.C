// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of MRFProperties in nscdDEMFoam: cylinders that turn, on one and two ranks, a grain in the flow, and bad input.
#include "annulus.H"
#include "caseTools.H"
#include "programCase.H"
#include "writtenFields.H"

#include <sstream>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

const label n = 12;

const std::string rotorZone = "rotor\n{\ncellZone rotor;\nnonRotatingPatches (right);\norigin (0 0 0);\naxis (0 0 1);\nomega 2;\n}\n";

/// A held disc near the outer cylinder, or none.
Files annulusFiles(bool hasGrain, const std::string& more = "")
{
    const std::string grain = hasGrain ? "motion fixed; grains { type lattice; box (0.898 -0.002 0) (0.902 0.002 0.1); count (1 1 1); diameter 0.004; }" : "grains {}";
    return
    {
        {"constant/grainProperties", "materials { glass { density 2500; } } contacts { default { friction 0.3; } }" + grain + more},
        {"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);"},
        {"constant/transportProperties", "transportModel Newtonian; nu 0.2; rho 1000;"},
        {"constant/MRFProperties", rotorZone},
        {"0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { \"(left|right)\" { type noSlip; } "
            "sides { type empty; } }"},
        {"0/p_rgh", "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField { \"(left|right)\" { type fixedFluxPressure; value uniform 0; } "
            "sides { type empty; } }"},
        {"system/topoSetDict", "actions ( { name rotor; type cellSet; action new; source cylinderToCell; p1 (0 0 -1); p2 (0 0 1); radius 0.75; }"
            "{ name rotor; type cellZoneSet; action new; source setToCellZone; set rotor; } );"}
    };
}

const std::string control = "deltaT 0.02; endTime 3; writeInterval 150; ";

/// Four blocks of n x n cells around the axis, without a seam: grains know periodic sides that are flat alone.
std::string blockMeshDict()
{
    std::ostringstream points, blocks, arcs, inner, outer, lower, upper;
    for (label level = 0; level < 2; ++level)
    {
        for (label k = 0; k < 8; ++k)
        {
            const scalar r = k < 4 ? innerRadius : outerRadius, angle = M_PI/2*(k % 4), half = angle + M_PI/4;
            points << " (" << r*std::cos(angle) << ' ' << r*std::sin(angle) << ' ' << 0.1*level << ")";
            arcs << " arc " << 8*level + k << ' ' << 8*level + (k/4)*4 + (k + 1) % 4 << " (" << r*std::cos(half) << ' ' << r*std::sin(half) << ' ' << 0.1*level << ")";
        }
    }
    for (label k = 0; k < 4; ++k)
    {
        const label m = (k + 1) % 4;
        blocks << " hex (" << k << ' ' << 4 + k << ' ' << 4 + m << ' ' << m << ' ' << 8 + k << ' ' << 12 + k << ' ' << 12 + m << ' ' << 8 + m << ") ("
            << n << ' ' << n << " 1) simpleGrading (1 1 1)";
        inner << " (" << k << ' ' << 8 + k << ' ' << 8 + m << ' ' << m << ")";
        outer << " (" << 4 + k << ' ' << 4 + m << ' ' << 12 + m << ' ' << 12 + k << ")";
        lower << " (" << k << ' ' << m << ' ' << 4 + m << ' ' << 4 + k << ")";
        upper << " (" << 8 + k << ' ' << 12 + k << ' ' << 12 + m << ' ' << 8 + m << ")";
    }
    return "convertToMeters 1; vertices (" + points.str() + " ); blocks (" + blocks.str() + " ); edges (" + arcs.str() + " ); boundary ( left { type wall; faces ("
        + inner.str() + " ); } right { type wall; faces (" + outer.str() + " ); } sides { type empty; faces (" + lower.str() + upper.str() + " ); } );";
}

/// With its zone of cells.
std::unique_ptr<ProgramCase> annulus(const Files& files)
{
    auto c = std::make_unique<ProgramCase>(files, control);
    c->write("system/blockMeshDict", blockMeshDict());
    EXPECT_TRUE(succeeds(c->run("blockMesh")));
    EXPECT_TRUE(succeeds(c->run("topoSet")));
    return c;
}

vectorField velocityOf(const ProgramCase& c) { return cellValues<vector>(c, "3/U", 4*n*n); }

/// Center of a cell, by its place between the cylinders and around.
point center(label cell)
{
    const scalar r = innerRadius + (cell % n + 0.5)*(outerRadius - innerRadius)/n, angle = 2*M_PI*(cell/n + 0.5)/(4*n);
    return point(r*std::cos(angle), r*std::sin(angle), 0.05);
}

/// Largest error where x < limit, over the speed of the inner cylinder.
scalar errorOf(const vectorField& u, scalar limit)
{
    const CouetteFlow flow(2, 0);
    scalar largest = 0;
    forAll(u, cell) if (center(cell).x() < limit) largest = max(largest, mag(u[cell] - flow.velocity(center(cell))));
    return largest/(2*innerRadius);
}

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

} // namespace

TEST(RotatingZones, driveTheFluidAndTellWhatGrainsSee)
{
    const auto c = annulus(annulusFiles(true));
    const ProgramRun run = c->run();
    EXPECT_TRUE(succeeds(run));
    EXPECT_TRUE(has(run.log, "rotating zone rotor"));
    EXPECT_TRUE(has(run.log, "patch left turns with it for the fluid; to the grains it stands still"));
    EXPECT_FALSE(has(run.log, "patch right turns"));
    // Far from the grain.
    EXPECT_LT(errorOf(velocityOf(*c), -0.2), 0.02);
    // The grain feels the absolute velocity: it is pushed around the axis.
    const std::string text = c->contents("3/lagrangian/grains/fFluid");
    IStringStream values(text.substr(text.find('(')));
    vector force;
    token open;
    values >> open >> force;
    EXPECT_GT(force.y(), 0);
    EXPECT_GT(force.y(), 3*mag(force.x()));
}

TEST(RotatingZones, driveTheFluidAlone)
{
    const auto c = annulus(annulusFiles(false));
    EXPECT_TRUE(succeeds(c->run()));
    EXPECT_LT(errorOf(velocityOf(*c), 2), 0.012);
}

TEST(Ranks, rotatingZonesAreThoseOfOneRank)
{
    for (const bool hasGrain : {false, true})
    {
        const auto alone = annulus(annulusFiles(hasGrain)), together = annulus(annulusFiles(hasGrain));
        EXPECT_TRUE(succeeds(alone->run()));
        EXPECT_TRUE(succeeds(together->decompose(labelVector(2, 1, 1), "-force")));
        EXPECT_TRUE(succeeds(together->runOn(2)));
        EXPECT_TRUE(succeeds(together->run("reconstructPar", "-latestTime")));
        EXPECT_LT(max(mag(velocityOf(*alone) - velocityOf(*together))), 1e-6) << hasGrain;
    }
}

TEST(RotatingZones, refuseBadInput)
{
    const auto c = annulus(annulusFiles(true));
    const auto isRefusedAs = [&](const std::string& right, const std::string& wrong, std::vector<std::string> pieces)
    {
        std::string text = rotorZone;
        text.replace(text.find(right), right.size(), wrong);
        c->write("constant/MRFProperties", text);
        pieces.push_back("constant/MRFProperties");
        pieces.push_back("line ");
        return isRefused(*c, pieces);
    };
    EXPECT_TRUE(isRefusedAs("cellZone rotor", "cellZone rotr", {"rotor.cellZone", "rotr", "nearest: rotor"}));
    EXPECT_TRUE(isRefusedAs("cellZone rotor;", "", {"cellZone"}));
    EXPECT_TRUE(isRefusedAs("(right)", "(rihgt)", {"rotor.nonRotatingPatches", "names no patch", "rihgt", "nearest: right"}));
    EXPECT_TRUE(isRefusedAs("nonRotatingPatches", "nonRotatingPatch", {"nonRotatingPatch", "nearest: nonRotatingPatches"}));
    EXPECT_TRUE(isRefusedAs("axis (0 0 1)", "axis (0 0 0)", {"rotor.axis", "has no direction"}));
    EXPECT_TRUE(isRefusedAs("origin (0 0 0)", "origin (0 0)", {"rotor.origin"}));
    EXPECT_TRUE(isRefusedAs("omega 2;", "", {"omega"}));
    EXPECT_TRUE(isRefusedAs("omega 2", "active maybe; omega 2", {"rotor.active", "maybe"}));
    c->write("constant/MRFProperties", "");
    c->write("system/MRFProperties", rotorZone);
    EXPECT_TRUE(isRefused(*c, {"system/MRFProperties", "rotor", "constant/MRFProperties"}));
    const Files dry = dryFiles("materials { glass { density 2500; } } contacts { default { friction 0.3; } } fluid none;"
        "grains { type lattice; box (0.02 0.02 0.02) (0.08 0.08 0.06); count (3 3 2); diameter 0.01; } patches { front { type wall; } back { type exit; } }");
    Files withZone = dry;
    withZone["constant/MRFProperties"] = rotorZone;
    EXPECT_TRUE(isRefused(ProgramCase(withZone), {"constant/MRFProperties", "rotor", "fluid none"}));
}
