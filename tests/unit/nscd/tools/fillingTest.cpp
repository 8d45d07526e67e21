// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Fillings: amounts to one grain, no overlap by looking at all pairs, sizes as asked, the same from the same seed, solid fractions measured on a grid.
#include "nscd/tools/filling.hpp"

#include "unit/nscd/tools/closedSurfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using nscd::Vec3;

namespace
{

const nscd::Walls noWalls;
const nscd::PeriodicBox open;

nscd::FillingPlace inSpace(const nscd::Walls& walls = noWalls, const nscd::PeriodicBox& box = open, std::size_t number = 0)
{
    return {walls, box, nscd::GrainShape(), 0.0, number};
}

nscd::FillingSource sourceOf(const nscd::Region& region, nscd::FillingAmount measure, double amount)
{
    nscd::FillingSource source;
    source.region = region;
    source.sizes = nscd::tabulatedSizes({{0.08, 1.0}, {0.16, 1.0}});
    source.density = 2500.0;
    source.measure = measure;
    source.amount = amount;
    return source;
}

nscd::FillingSource numberOf(const nscd::Region& region, double number) { return sourceOf(region, nscd::FillingAmount::number, number); }

nscd::FillingSource packingOf(const nscd::Region& region, double fraction, const nscd::SizeDistribution& sizes)
{
    nscd::FillingSource source = sourceOf(region, nscd::FillingAmount::solidFraction, fraction);
    source.sizes = sizes;
    source.isPacked = true;
    return source;
}

nscd::Region unitBox() { return nscd::boxRegion(Vec3::Zero(), Vec3::Ones()); }

nscd::PeriodicBox periodicOf(double length, int axis)
{
    nscd::PeriodicBox box;
    box.length[axis] = length;
    return box;
}

double volumeOf(double radius) { return 4.0/3.0*M_PI*radius*radius*radius; }

double volumeOf(const nscd::Spheres& grains)
{
    double sum = 0.0;
    for (const double radius : grains.radius) sum += volumeOf(radius);
    return sum;
}

/// The least gap of all pairs [m].
double leastGap(const nscd::Spheres& a, const nscd::Spheres& b, bool isSame, const nscd::PeriodicBox& box)
{
    double least = 1e30;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        for (std::size_t j = isSame ? i + 1 : 0; j < b.size(); ++j)
        {
            least = std::min(least, box.nearestImage(a.center[i] - b.center[j]).norm() - a.radius[i] - b.radius[j]);
        }
    }
    return least;
}

double leastGap(const nscd::Spheres& grains, const nscd::PeriodicBox& box = open) { return leastGap(grains, grains, true, box); }

/// The least distance of a grain's surface from what tells a center's distance inwards.
template<class Inside>
double leastClearance(const nscd::Spheres& grains, const Inside& inside)
{
    double least = 1e30;
    for (std::size_t i = 0; i < grains.size(); ++i) least = std::min(least, inside(grains.center[i]) - grains.radius[i]);
    return least;
}

double insideBox(const Vec3& x, const Vec3& size) { return std::min(x.minCoeff(), (size - x).minCoeff()); }

/// Of a cube, the share of points of a grid that lie in grains.
double fractionOnGrid(const nscd::Spheres& grains, double lower, double upper)
{
    constexpr int parts = 60;
    int solid = 0;
    for (int k = 0; k < parts*parts*parts; ++k)
    {
        const Vec3 x = Vec3::Constant(lower) + (upper - lower)/parts*Vec3(k % parts + 0.5, k/parts % parts + 0.5, k/parts/parts + 0.5);
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            if ((x - grains.center[i]).squaredNorm() >= grains.radius[i]*grains.radius[i]) continue;
            ++solid;
            break;
        }
    }
    return solid/std::pow(parts, 3);
}

/// Largest distance of two distributions (Kolmogorov and Smirnov).
double distanceOf(std::vector<double> a, std::vector<double> b)
{
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    double most = 0.0;
    for (const double x : a)
    {
        const auto below = [x](const std::vector<double>& v) { return (std::upper_bound(v.begin(), v.end(), x) - v.begin())/double(v.size()); };
        most = std::max(most, std::abs(below(a) - below(b)));
    }
    return most;
}

std::string refusal(const nscd::FillingSource& source)
{
    try
    {
        nscd::fill(source, inSpace(), {});
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "was accepted";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST(Filling, hasItsAmountToOneGrain)
{
    EXPECT_EQ(nscd::fill(numberOf(unitBox(), 137), inSpace(), {}).grains.size(), 137u);
    const double largest = volumeOf(0.08);
    const nscd::Filling byMass = nscd::fill(sourceOf(unitBox(), nscd::FillingAmount::mass, 500.0), inSpace(), {});
    EXPECT_LE(2500.0*volumeOf(byMass.grains), 500.0);
    EXPECT_GT(2500.0*volumeOf(byMass.grains), 500.0 - 2500.0*largest);
    const nscd::Filling byFraction = nscd::fill(sourceOf(unitBox(), nscd::FillingAmount::solidFraction, 0.25), inSpace(), {});
    EXPECT_LE(volumeOf(byFraction.grains), 0.25);
    EXPECT_GT(volumeOf(byFraction.grains), 0.25 - largest);
    EXPECT_NEAR(byFraction.solidFraction, volumeOf(byFraction.grains), 1e-12);
}

TEST(Filling, ofOneSizeHasTheNumberThatAMassIs)
{
    nscd::FillingSource source = sourceOf(unitBox(), nscd::FillingAmount::mass, 100*2500.0*volumeOf(0.05));
    source.sizes = nscd::oneSize(0.1);
    EXPECT_EQ(nscd::fill(source, inSpace(), {}).grains.size(), 100u);
}

TEST(Filling, liesWholeInItsRegionAndNothingOverlaps)
{
    const nscd::Spheres box = nscd::fill(numberOf(unitBox(), 200), inSpace(), {}).grains;
    EXPECT_GE(leastClearance(box, [](const Vec3& x) { return insideBox(x, Vec3::Ones()); }), 0.0);
    EXPECT_GE(leastGap(box), 0.0);
    const nscd::Spheres ball = nscd::fill(numberOf(nscd::sphereRegion({1, 2, 3}, 0.6), 150), inSpace(), {}).grains;
    EXPECT_GE(leastClearance(ball, [](const Vec3& x) { return 0.6 - (x - Vec3(1, 2, 3)).norm(); }), -1e-15);
    EXPECT_GE(leastGap(ball), 0.0);
    const nscd::Spheres tube = nscd::fill(numberOf(nscd::cylinderRegion({1, 0, 0}, {1, 2, 0}, 0.3), 100), inSpace(), {}).grains;
    EXPECT_GE(leastClearance(tube, [](const Vec3& x) { return std::min({x[1], 2.0 - x[1], 0.3 - std::hypot(x[0] - 1.0, x[2])}); }), -1e-15);
    const nscd::Spheres surface = nscd::fill(numberOf(nscd::surfaceRegion(closedSurfaces::boxOfTriangles()), 500), inSpace(), {}).grains;
    EXPECT_GE(leastClearance(surface, [](const Vec3& x) { return insideBox(x, Vec3(1, 2, 3)); }), -1e-15);
    EXPECT_GE(leastGap(surface), 0.0);
}

TEST(Filling, keepsOffWallsAndOtherGrains)
{
    nscd::Walls walls;
    walls.addPlane(walls.addPatch("slope", 0), {0.5, 0.5, 0.5}, Vec3(1, 0, 1).normalized());
    walls.addPolygon(walls.addPatch("plate", 0), {{0, 0, 0.8}, {1, 0, 0.8}, {1, 1, 0.8}, {0, 1, 0.8}});
    const nscd::Spheres others{{{0.7, 0.5, 0.6}, {1.05, 1.05, 1.05}}, {0.15, 0.1}};
    for (const bool isPacked : {false, true})
    {
        nscd::FillingSource source = isPacked ? packingOf(unitBox(), 0.15, nscd::oneSize(0.06)) : numberOf(unitBox(), 60);
        const nscd::Spheres grains = nscd::fill(source, inSpace(walls), others).grains;
        EXPECT_GE(leastClearance(grains, [](const Vec3& x) { return (x[0] + x[2] - 1.0)/std::sqrt(2.0); }), -1e-15);
        EXPECT_GE(leastClearance(grains, [](const Vec3& x) { return std::abs(x[2] - 0.8); }), -1e-15);
        EXPECT_GE(leastGap(grains, others, false, open), 0.0);
        EXPECT_GE(leastGap(grains), 0.0);
    }
}

TEST(Filling, goesRoundPeriods)
{
    nscd::PeriodicBox box = periodicOf(1.0, 0);
    box.lower[0] = 0.3;
    // The region goes over the end of the box; along z it is smaller than the period.
    box.length[2] = 5.0;
    const nscd::Region region = nscd::boxRegion({-0.5, 0, -0.5}, {0.5, 1, 0.5});
    for (const bool isPacked : {false, true})
    {
        nscd::FillingSource source = isPacked ? packingOf(region, 0.5, nscd::oneSize(0.1)) : numberOf(region, 200);
        const nscd::Spheres grains = nscd::fill(source, inSpace(noWalls, box), {}).grains;
        EXPECT_GE(leastGap(grains, box), 0.0);
        EXPECT_TRUE(std::all_of(grains.center.begin(), grains.center.end(), [](const Vec3& x) { return x[0] >= 0.3 && x[0] < 1.3; }));
        EXPECT_TRUE(std::any_of(grains.center.begin(), grains.center.end(), [](const Vec3& x) { return x[0] < 0.34 || x[0] > 1.26; }));
        EXPECT_TRUE(std::any_of(grains.center.begin(), grains.center.end(), [](const Vec3& x) { return x[2] > 4.5; }));
    }
}

TEST(Filling, hasTheSizesThatWereAskedFor)
{
    // Two samples of 2000 differ by more than this once in a thousand.
    const double allowed = 1.95*std::sqrt(2.0/2000.0);
    nscd::FillingSource source = numberOf(nscd::boxRegion(Vec3::Zero(), Vec3::Constant(3)), 2000);
    source.sizes = nscd::logNormalSizes(0.1, 1.3, 0.05, 0.3);
    std::vector<double> asked, other;
    const nscd::RandomNumbers random = nscd::randomNumbers(99);
    for (int k = 0; k < 2000; ++k) asked.push_back(0.5*source.sizes.draw(random));
    EXPECT_LT(distanceOf(nscd::fill(source, inSpace(), {}).grains.radius, asked), allowed);
    for (const double radius : asked) other.push_back(1.1*radius);
    EXPECT_GT(distanceOf(other, asked), allowed);
}

TEST(Filling, isUniform)
{
    // Of 2000 at a solid fraction of 0.05, halves differ by less than four deviations of free points.
    nscd::FillingSource source = numberOf(nscd::boxRegion(Vec3::Zero(), Vec3::Constant(2)), 2000);
    source.sizes = nscd::oneSize(0.072);
    const nscd::Spheres grains = nscd::fill(source, inSpace(), {}).grains;
    for (int k = 0; k < 3; ++k)
    {
        const auto below = std::count_if(grains.center.begin(), grains.center.end(), [k](const Vec3& x) { return x[k] < 1.0; });
        EXPECT_NEAR(double(below), 1000.0, 4.0*std::sqrt(500.0));
    }
}

TEST(Filling, isTheSameFromTheSameSeed)
{
    for (const bool isPacked : {false, true})
    {
        nscd::FillingSource source = isPacked ? packingOf(unitBox(), 0.5, nscd::oneSize(0.1)) : numberOf(unitBox(), 100);
        const nscd::Spheres first = nscd::fill(source, inSpace(), {}).grains;
        EXPECT_EQ(nscd::fill(source, inSpace(), {}).grains.center, first.center);
        EXPECT_NE(nscd::fill(source, inSpace(noWalls, open, 1), {}).grains.center, first.center);
        source.seed = 2;
        EXPECT_NE(nscd::fill(source, inSpace(), {}).grains.center, first.center);
    }
}

TEST(Packing, hasItsSolidFractionInAPeriodicBox)
{
    nscd::PeriodicBox box;
    box.length = Vec3::Ones();
    const nscd::Filling filling = nscd::fill(packingOf(unitBox(), 0.6, nscd::oneSize(0.08)), inSpace(noWalls, box), {});
    EXPECT_NEAR(volumeOf(filling.grains), 0.6, 0.006);
    EXPECT_GE(leastGap(filling.grains, box), 0.0);
}

TEST(Packing, hasItsSolidFractionInTheInterior)
{
    for (const nscd::SizeDistribution& sizes : {nscd::oneSize(0.05), nscd::tabulatedSizes({{0.04, 1.0}, {0.06, 1.0}})})
    {
        const nscd::Filling filling = nscd::fill(packingOf(unitBox(), 0.6, sizes), inSpace(), {});
        const double margin = 2.0*sizes.largest;
        EXPECT_NEAR(fractionOnGrid(filling.grains, margin, 1.0 - margin), 0.6, 0.006);
        EXPECT_GT(filling.interiorFraction, 0.0);
        EXPECT_LT(filling.solidFraction, filling.interiorFraction);
        EXPECT_GE(leastGap(filling.grains), 0.0);
        EXPECT_GE(leastClearance(filling.grains, [](const Vec3& x) { return insideBox(x, Vec3::Ones()); }), 0.0);
    }
}

TEST(Packing, ofASmallRegionHasItsFractionAsAWhole)
{
    const nscd::Filling filling = nscd::fill(packingOf(nscd::sphereRegion({0, 0, 0}, 0.5), 0.55, nscd::oneSize(0.1)), inSpace(), {});
    EXPECT_EQ(filling.interiorFraction, 0.0);
    EXPECT_NEAR(volumeOf(filling.grains)/volumeOf(0.5), 0.55, volumeOf(0.05)/volumeOf(0.5));
    EXPECT_GE(leastClearance(filling.grains, [](const Vec3& x) { return 0.5 - x.norm(); }), -1e-15);
    EXPECT_GE(leastGap(filling.grains), 0.0);
}

/// Four spheres of 0.2 in a periodic box take 0.017 of 0.55.
TEST(Packing, countsTheGrainsOfOthers)
{
    nscd::PeriodicBox box;
    box.length = Vec3::Ones();
    const nscd::Spheres others{{{0.2, 0.2, 0.2}, {0.7, 0.3, 0.4}, {0.4, 0.8, 0.9}, {0.9, 0.9, 0.5}}, {0.1, 0.1, 0.1, 0.1}};
    const nscd::Spheres grains = nscd::fill(packingOf(unitBox(), 0.55, nscd::oneSize(0.07)), inSpace(noWalls, box), others).grains;
    EXPECT_NEAR(volumeOf(grains) + volumeOf(others), 0.55, 0.0055);
    EXPECT_GE(leastGap(grains, others, false, box), 0.0);
    EXPECT_GE(leastGap(grains, box), 0.0);
}

TEST(Packing, packsDiscs)
{
    nscd::GrainShape discs;
    discs.dimensions = 2;
    discs.emptyAxis = 2;
    nscd::FillingSource source = packingOf(nscd::inPlane(unitBox(), 2, 0.0), 0.8, nscd::tabulatedSizes({{0.015, 1.0}, {0.03, 1.0}}));
    const nscd::Filling filling = nscd::fill(source, {noWalls, open, discs, 0.5, 0}, {});
    EXPECT_NEAR(filling.interiorFraction, 0.8, 0.008);
    EXPECT_GE(leastGap(filling.grains), 0.0);
    for (const Vec3& x : filling.grains.center) EXPECT_EQ(x[2], 0.0);
}

TEST(Packing, saysWhatWasNotReached)
{
    // 0.64 of equal spheres within walls.
    EXPECT_TRUE(holds(refusal(packingOf(nscd::sphereRegion({0, 0, 0}, 0.4), 0.64, nscd::oneSize(0.1))), "still overlap by")) ;
}

TEST(Filling, saysWhatFindsNoPlace)
{
    const std::string text = refusal(sourceOf(unitBox(), nscd::FillingAmount::solidFraction, 0.6));
    EXPECT_TRUE(holds(text, "found places for")) << text;
    EXPECT_TRUE(holds(text, "packing { solidFraction")) << text;
    EXPECT_TRUE(holds(refusal(sourceOf(unitBox(), nscd::FillingAmount::mass, 1e-3)), "not enough for one grain"));
    EXPECT_TRUE(holds(refusal(numberOf(nscd::boxRegion(Vec3::Zero(), {1, 1, 0.05}), 3)), "found places for 0"));
}
