// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Exact shares of balls in the cells at a corner, in the open and against three walls, to the last digits (C25, C26).

#include "mappingTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

// Integral of a function whose derivatives may be infinite at the ends (Takahasi & Mori 1974).
scalar tanhSinh(const std::function<scalar(scalar)>& f, const scalar from, const scalar to)
{
    const scalar h = 1./64;
    scalar sum = 0;
    for (int k = -256; k <= 256; ++k)
    {
        const scalar s = M_PI_2*std::sinh(k*h);
        const scalar weight = M_PI_2*std::cosh(k*h)/sqr(std::cosh(s));
        if (weight < 1e-20) continue;
        sum += weight*f(0.5*(from + to) + 0.5*(to - from)*std::tanh(s));
    }
    return 0.5*(to - from)*h*sum;
}

// Part of a circle about the origin that lies beyond x (and, in the second, beyond y too).
scalar circleBeyond(const scalar x, const scalar radius)
{
    if (x >= radius) return 0;
    if (x <= -radius) return M_PI*sqr(radius);
    return sqr(radius)*std::acos(x/radius) - x*std::sqrt(sqr(radius) - sqr(x));
}

scalar circleBeyond(const scalar x, const scalar y, const scalar radius)
{
    if (x < 0) return circleBeyond(y, radius) - circleBeyond(-x, y, radius);
    if (y < 0) return circleBeyond(x, radius) - circleBeyond(x, -y, radius);
    if (sqr(x) + sqr(y) >= sqr(radius)) return 0;
    const scalar endX = std::sqrt(sqr(radius) - sqr(y)), endY = std::sqrt(sqr(radius) - sqr(x));
    const scalar sector = 0.5*sqr(radius)*(std::acos(x/radius) - std::asin(y/radius));
    return sector - 0.5*x*(endY - y) - 0.5*y*(endX - x);
}

// Share of a ball about the origin with x > corner.x, y > corner.y, z > corner.z: discs at all heights, in pieces
// between the heights where the disc begins to reach an edge.
scalar octantShare(const Vec3& corner, const scalar radius)
{
    std::vector<scalar> heights = {corner[2], radius};
    for (const scalar reach : {std::abs(corner[0]), std::abs(corner[1]), std::hypot(corner[0], corner[1])})
    {
        if (reach > radius) continue;
        const scalar height = std::sqrt(sqr(radius) - sqr(reach));
        for (const scalar z : {-height, height}) if (z > corner[2]) heights.push_back(z);
    }
    std::sort(heights.begin(), heights.end());
    const auto slice = [&](const scalar z)
    {
        return circleBeyond(corner[0], corner[1], std::sqrt(max(scalar(0), sqr(radius) - sqr(z))));
    };
    scalar volume = 0;
    for (std::size_t k = 1; k < heights.size(); ++k) volume += tanhSinh(slice, heights[k - 1], heights[k]);
    return volume/(4./3*M_PI*pow3(radius));
}

// The eight cells around a corner of the mesh, of a ball that reaches no other cell.
void expectOctantShares(const fvMesh& mesh, const Vec3& corner, const Vec3& center, const scalar radius)
{
    GrainMapping mapping(mesh, mappingDict("exact"));
    const ::nscd::Grains grains = makeGrains({center}, radius);
    const MappingReport& report = mapping.update(grains, {});
    EXPECT_NEAR(report.lostOutside/grains.volume(0), 0, 1e-13);
    for (int octant = 0; octant < 8; ++octant)
    {
        const Vec3 side(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
        const Vec3 mirrored = side.cwiseProduct(corner - center);
        const label cell = mesh.findNearestCell(toFoam(Vec3(corner + 0.5*side)));
        EXPECT_NEAR(shareIn(mapping.weights(), 0, cell), octantShare(mirrored, radius), 1e-12)
            << "center " << center.transpose() << " octant " << side.transpose();
    }
}

TEST(mappingOctant, quadratureKnowsTheCatalogsFigures)
{
    EXPECT_NEAR(octantShare(Vec3(0, 0, 0), 0.4), 0.125, 1e-14);
    EXPECT_NEAR(octantShare(Vec3(-0.1, -0.2, -0.15), 0.4), 0.4265589, 5e-8);
    EXPECT_NEAR(octantShare(Vec3(0.1, 0.1, 0.1), 0.4), 0.0273902, 5e-8);
}

TEST(mappingOctant, sharesInTheOpenToTenDigits)
{
    BoxMesh box(unitCells(labelVector(4, 4, 4)));
    const Vec3 corner(2, 2, 2);
    for (const Vec3& offset : {Vec3(0.1, 0.2, 0.15), Vec3(-0.1, -0.1, -0.1), Vec3(0.3, -0.25, 0.02), Vec3(1e-9, 0.2, 0)})
    {
        expectOctantShares(box.mesh(), corner, corner + offset, 0.4);
        expectOctantShares(box.mesh(), corner, corner + offset, 0.65);
    }
}

// A grain that lies in the corner of three walls is wholly in the mesh, and its cells get what is theirs.
TEST(mappingOctant, sharesAgainstThreeWalls)
{
    BoxMesh box(unitCells(labelVector(4, 4, 4)));
    for (const scalar radius : {0.51, 0.7, 0.9})
    {
        const Vec3 touching = Vec3::Constant(radius);
        expectOctantShares(box.mesh(), Vec3(1, 1, 1), touching, radius);
        expectOctantShares(box.mesh(), Vec3(3, 1, 3), Vec3(4 - radius, radius, 4 - radius), radius);
    }
}

// Stress S7: grains wider than cells leave every cell its least fluid fraction, and no volume is lost.
TEST(mappingOctant, grainsWiderThanCellsKeepTheFractionInRange)
{
    BoxMesh box(unitCells(labelVector(24, 16, 16)));
    const fvMesh& mesh = box.mesh();
    volScalarField fluidFraction(IOobject("alpha", box.time().timeName(), mesh), mesh, dimensionedScalar("one", dimless, 1));
    for (const char* method : {"centroid", "satellite", "exact"})
    {
        for (const scalar diffusionLength : {0., 4.})
        {
            GrainMapping mapping(mesh, mappingDict(method, diffusionLength));
            ::nscd::Grains grains = makeGrains({Vec3(5, 5.3, 5.1), Vec3(15.2, 10.9, 8)}, 5);
            grains.add(Vec3(21, 2.5, 2.6), 2.5, 2500, 0, 7);
            const MappingReport& report = mapping.update(grains, {});
            mapping.setFluidFraction(fluidFraction);
            EXPECT_GT(min(fluidFraction).value(), 0.2 - 1e-9) << method;
            EXPECT_LE(max(fluidFraction).value(), 1) << method;
            EXPECT_EQ(report.redistribution.unresolvedVolume, 0) << method;
            EXPECT_NEAR(report.volumeDeposited/::nscd::totalVolume(grains), 1, 1e-12) << method;
        }
    }
}

} // End anonymous namespace
