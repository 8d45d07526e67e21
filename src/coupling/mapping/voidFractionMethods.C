// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The ways to share a grain's volume among cells.
#include "coupling/mapping/voidFractionMethods.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

scalar centroidShares(ShareTools&, const LocatedBall& ball, std::vector<CellShare>& shares)
{
    shares.push_back({ball.cell, 1});
    return 1;
}

// Equal-weight rule for the unit ball, exact for polynomials up to degree 5: the center, the 12 vertices of an icosahedron and
// the 20 of a dodecahedron. Both solids are spherical 5-designs; the radii give the moments <r^2> = 3/5 and <r^4> = 3/7.
std::vector<Vec3> ballPoints()
{
    const scalar golden = 0.5*(1 + std::sqrt(5.0));
    const scalar inner = std::sqrt(99.0/160 - std::sqrt(123585.0)/1120);
    const scalar outer = std::sqrt(99.0/160 + 3*std::sqrt(123585.0)/5600);
    const Vec3 onIcosahedron = inner*Vec3(0, 1, golden).normalized();
    const Vec3 onDodecahedron = outer*Vec3(0, 1/golden, golden).normalized();

    std::vector<Vec3> points = {Vec3::Zero()};
    const auto addSigns = [&points](const Vec3& p)
    {
        for (int bits = 0; bits < 8; ++bits)
        {
            const Vec3 q((bits & 1) ? -p[0] : p[0], (bits & 2) ? -p[1] : p[1], (bits & 4) ? -p[2] : p[2]);
            if (std::find(points.begin(), points.end(), q) == points.end())
            {
                points.push_back(q);
            }
        }
    };
    for (int turn = 0; turn < 3; ++turn)
    {
        const auto turned = [turn](const Vec3& p) { return Vec3(p[turn], p[(turn + 1) % 3], p[(turn + 2) % 3]); };
        addSigns(turned(onIcosahedron));
        addSigns(turned(onDodecahedron));
    }
    addSigns(outer*Vec3(1, 1, 1).normalized());
    return points;
}

// Equal-weight rule for the unit disc, exact up to degree 5: the center and rings of 6 and 12, <r^2> = 1/2, <r^4> = 1/3.
std::vector<Vec3> discPoints(const int emptyAxis)
{
    const scalar outerSquared = (38 + std::sqrt(190.0))/72;
    const scalar innerSquared = 19.0/12 - 2*outerSquared;
    std::vector<Vec3> points = {Vec3::Zero()};
    const auto addRing = [&](const int n, const scalar radius)
    {
        for (int k = 0; k < n; ++k)
        {
            const scalar angle = 2*M_PI*k/n;
            Vec3 p = Vec3::Zero();
            p[(emptyAxis + 1) % 3] = radius*std::cos(angle);
            p[(emptyAxis + 2) % 3] = radius*std::sin(angle);
            points.push_back(p);
        }
    };
    addRing(6, std::sqrt(innerSquared));
    addRing(12, std::sqrt(outerSquared));
    return points;
}

const std::vector<Vec3>& samplePoints(const bool areDiscs, const int emptyAxis)
{
    static const std::vector<Vec3> ball = ballPoints();
    static const std::vector<Vec3> discs[] = {discPoints(0), discPoints(1), discPoints(2)};
    return areDiscs ? discs[emptyAxis] : ball;
}

void addToCell(const label cell, const scalar share, const std::size_t rowStart, std::vector<CellShare>& shares)
{
    for (std::size_t k = rowStart; k < shares.size(); ++k)
    {
        if (shares[k].cell == cell)
        {
            shares[k].share += share;
            return;
        }
    }
    shares.push_back({cell, share});
}

// 33 sample points of equal weight (19 for discs), each given to the cell it lies in.
scalar satelliteShares(ShareTools& tools, const LocatedBall& ball, std::vector<CellShare>& shares)
{
    const std::vector<Vec3>& points = samplePoints(tools.areDiscs, tools.mesh.emptyAxis);
    const std::size_t rowStart = shares.size();
    const scalar weight = 1.0/scalar(points.size());
    std::size_t nInside = 0;
    for (const Vec3& point : points)
    {
        const label cell = tools.locator.walkThroughCyclic(ball.cell, tools.mesh.inPlane(ball.center + ball.radius*point)).cell;
        if (cell >= 0)
        {
            addToCell(cell, weight, rowStart, shares);
            ++nInside;
        }
    }
    return weight*scalar(nInside);
}

scalar exactShares(ShareTools& tools, const LocatedBall& ball, std::vector<CellShare>& shares)
{
    return tools.overlap.appendShares(ball.center, ball.radius, ball.cell, shares);
}

constexpr VoidFractionMethod methods[] =
{
    {"centroid", centroidShares},
    {"satellite", satelliteShares},
    {"exact", exactShares},
};

} // namespace

wordList voidFractionMethodNames()
{
    wordList names;
    for (const VoidFractionMethod& method : methods) names.append(method.name);
    return names;
}

const VoidFractionMethod& readVoidFractionMethod(const dictionary& dict)
{
    const word name = dict.getOrDefault<word>("method", "exact");
    for (const VoidFractionMethod& method : methods)
    {
        if (name == method.name)
        {
            return method;
        }
    }
    FatalIOErrorInFunction(dict)
        << "unknown void-fraction method " << name << "; known are: " << voidFractionMethodNames() << exit(FatalIOError);
    return methods[0];
}

} // namespace nscdCoupling
} // namespace Foam
