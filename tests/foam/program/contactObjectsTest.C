// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of contactStress and contactForces in nscdDEMFoam: a column at rest against its weight, on two ranks, over restarts, and bad input.
#include "caseTools.H"
#include "programCase.H"
#include "unit/nscd/tools/vtpFile.hpp"
#include "writtenFields.H"

#include "OSspecific.H"

#include <cmath>
#include <numeric>

using namespace Foam;
using namespace Foam::nscdCoupling::testing;

namespace
{

// Cells as high and as wide as a grain is.
constexpr scalar diameter = 0.025, cellVolume = diameter*diameter*diameter;
constexpr label nColumn = 6;

/// A column of grains that touch, each in the middle of a cell, at rest in water at rest.
Files columnFiles()
{
    return {{"constant/grainProperties",
        "materials { glass { density 2500; } } contacts { default { friction 0.3; } } solver { tolerance 1e-8; forceTolerance 1e-6; maxSweeps 100000; } voidFraction { filterWidth 0; }"
        "grains { type lattice; box (0.025 0.025 0) (0.05 0.05 0.15); count (1 1 6); diameter 0.025; }"
        "patches { front { type wall; } back { type exit; } }"}};
}

/// Weight less that of the water [N].
constexpr scalar weight = (2500 - 1000)*M_PI/6*cellVolume*9.81;

const std::string both = "functions\n{\nstress { type contactStress; }\npictures { type contactForces; }\n}\n";

/// Grains that fall into a heap between the walls, without a fluid.
Files heapFiles()
{
    Files files = dryFiles("materials { glass { density 2500; } } contacts { default { friction 0.3; restitution 0.2; } } fluid none; solver { tolerance 1e-9; forceTolerance 1e-7; displacementTolerance 1e-9; maxSweeps 100000; }"
        "grains { type lattice; box (0.0 0.0 0.0) (0.1 0.1 0.09); count (4 4 4); diameter 0.022; velocity (0.1 0.05 -1); }"
        "patches { front { type wall; } back { type exit; } }");
    return files;
}

const std::string pictures = "functions\n{\npictures { type contactForces; }\n}\n";

/// Cell of grain k of the column.
label cellOf(label k) { return 1 + 4*1 + 16*k; }

void expectWeightAbove(const ProgramCase& c, const std::string& time)
{
    const tensorField stress = cellValues<tensor>(c, time + "/contactStress.grains");
    const scalar area = diameter*diameter;
    for (label k = 0; k < nColumn; ++k)
    {
        const tensor sigma = stress[cellOf(k)];
        EXPECT_NEAR(sigma.zz(), (nColumn - k - 0.5)*weight/area, 1e-4*nColumn*weight/area) << k;
        EXPECT_LT(mag(sigma - tensor(0, 0, 0, 0, 0, 0, 0, 0, sigma.zz())), 1e-4*sigma.zz()) << k;
    }
    EXPECT_LT(mag(sum(stress).zz() - nColumn*nColumn*0.5*weight/area), 1e-4*nColumn*nColumn*weight/area);
}

vtp::VtpFile picture(const ProgramCase& c, const std::string& file) { return vtp::VtpFile(c.path("postProcessing/pictures/" + file)); }

/// Of both files: what is in them fits together, and each contact is there once.
void expectWhole(const ProgramCase& c, const std::string& time)
{
    const vtp::VtpFile points = picture(c, time + "/contacts.vtp"), lines = picture(c, time + "/forceChains.vtp");
    const std::vector<std::int64_t> a = points.array<std::int64_t>("idA"), b = points.array<std::int64_t>("idB");
    ASSERT_EQ(long(a.size()), points.number("NumberOfPoints"));
    EXPECT_EQ(lines.number("NumberOfLines"), long(a.size()));
    EXPECT_EQ(lines.array<std::int64_t>("idA"), a);
    EXPECT_EQ(lines.array<std::int64_t>("idB"), b);
    for (std::size_t k = 1; k < a.size(); ++k) EXPECT_LT(std::make_pair(a[k - 1], b[k - 1]), std::make_pair(a[k], b[k]));
}

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

/// What the files say in all of it.
double sumOf(const ProgramCase& c, const std::string& time, const std::string& array)
{
    const std::vector<double> values = picture(c, time + "/contacts.vtp").array<double>(array);
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The same contacts at the same places, but for what solves on other numbers of ranks differ by.
void expectSameContacts(const ProgramCase& one, const ProgramCase& two, const std::string& time)
{
    const vtp::VtpFile a = picture(one, time + "/contacts.vtp"), b = picture(two, time + "/contacts.vtp");
    EXPECT_GT(a.number("NumberOfPoints"), 30);
    EXPECT_EQ(a.array<std::int64_t>("idA"), b.array<std::int64_t>("idA"));
    EXPECT_EQ(a.array<std::int64_t>("idB"), b.array<std::int64_t>("idB"));
    const std::vector<double> x = a.array<double>("position"), y = b.array<double>("position");
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], y[k], 1e-4*diameter);
}

} // namespace

TEST(ContactObjects, showTheWeightAboveInAColumnAtRest)
{
    const ProgramCase c(columnFiles(), both);
    EXPECT_TRUE(succeeds(c.run()));
    expectWeightAbove(c, "0.01");
    expectWhole(c, "0.01");
    const vtp::VtpFile lines = picture(c, "0.01/forceChains.vtp");
    const std::vector<double> force = lines.array<double>("forceMagnitude");
    ASSERT_EQ(force.size(), std::size_t(nColumn));
    for (label k = 0; k < nColumn; ++k) EXPECT_NEAR(force[std::size_t(k)], (nColumn - k)*weight, 1e-4*nColumn*weight) << k;
    EXPECT_FALSE(isDir(c.path("0.001")));
}

TEST(ContactObjects, goOnAfterARestart)
{
    const ProgramCase c(columnFiles(), both);
    EXPECT_TRUE(succeeds(c.run()));
    c.writeControl("endTime 0.015; writeInterval 5; " + both);
    EXPECT_TRUE(succeeds(c.run()));
    expectWeightAbove(c, "0.015");
    expectWhole(c, "0.015");
    const std::string series = c.contents("postProcessing/pictures/contacts.pvd");
    for (const char* time : {"0.01", "0.015"}) EXPECT_TRUE(has(series, std::string("file=\"") + time + "/contacts.vtp\"")) << series;
    EXPECT_TRUE(has(c.contents("postProcessing/pictures/forceChains.pvd"), "file=\"0.015/forceChains.vtp\""));
    // Begun anew, the series forgets what came later.
    c.writeControl("startFrom startTime; endTime 0.005; writeInterval 5; " + both);
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_FALSE(has(c.contents("postProcessing/pictures/contacts.pvd"), "0.01"));
}

TEST(ContactObjects, areNotThereWhereTheyAreNotNamed)
{
    const ProgramCase c(columnFiles());
    EXPECT_TRUE(succeeds(c.run()));
    EXPECT_TRUE(c.contents("0.01/contactStress.grains").empty());
    EXPECT_FALSE(isDir(c.path("postProcessing/pictures")));
}

TEST(ContactObjects, seeContactsOfGrainsAloneAndChangeNothing)
{
    const ProgramCase watched(heapFiles(), "endTime 0.06; writeInterval 60; " + pictures), alone(heapFiles(), "endTime 0.06; writeInterval 60; ");
    EXPECT_TRUE(succeeds(watched.run()));
    EXPECT_TRUE(succeeds(alone.run()));
    expectWhole(watched, "0.06");
    EXPECT_EQ(watched.contents("0.06/lagrangian/grains/U"), alone.contents("0.06/lagrangian/grains/U"));
    EXPECT_GT(sumOf(watched, "0.06", "normalForce"), 0);
}

TEST(Ranks, contactObjectsAreThoseOfOneRank)
{
    const ProgramCase column(columnFiles(), both), alone(heapFiles(), "endTime 0.03; writeInterval 30; " + pictures);
    EXPECT_TRUE(succeeds(column.decompose(labelVector(1, 1, 2))));
    EXPECT_TRUE(succeeds(column.runOn(2)));
    EXPECT_TRUE(succeeds(column.run("reconstructPar", "-latestTime")));
    expectWeightAbove(column, "0.01");
    expectWhole(column, "0.01");
    const ProgramCase together(heapFiles(), "endTime 0.03; writeInterval 30; " + pictures);
    EXPECT_TRUE(succeeds(alone.run()));
    EXPECT_TRUE(succeeds(together.decompose(labelVector(2, 1, 1))));
    EXPECT_TRUE(succeeds(together.runOn(2)));
    expectWhole(together, "0.03");
    expectSameContacts(alone, together, "0.03");
}

TEST(ContactObjects, refuseBadInput)
{
    for (const std::string type : {"contactStress", "contactForces"})
    {
        const std::string start = "functions\n{\nshown\n{\ntype " + type + ";\n";
        EXPECT_TRUE(isRefused(ProgramCase(columnFiles(), start + "writeContol none; } }"), {"system/controlDict", "line ", "writeContol", "nearest: writeControl"}));
    }
    const Files dry = dryFiles(columnFiles()["constant/grainProperties"] + " fluid none;");
    EXPECT_TRUE(isRefused(ProgramCase(dry, "functions { shown { type contactStress; } }"), {"system/controlDict", "functions.shown", "needs a fluid", "fluid none"}));
    const ProgramCase foreign(heapFiles(), pictures);
    mkDir(foreign.path("postProcessing/pictures"));
    foreign.write("postProcessing/pictures/contacts.pvd", "<DataSet of another program>");
    EXPECT_TRUE(isRefused(foreign, {"contacts.pvd, line ", "is not what an earlier run wrote"}));
}
