// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of walls made from boundary faces: regions, outlines, areas, and that a closed surface stays closed.
#include "caseTools.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/coplanarRegions.H"
#include "coupling/case/walls/meshWalls.H"
#include "coupling/mapping/mesh/cellLocator.H"

#include "primitivePatch.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <map>
#include <random>
#include <tuple>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;
using nscd::Vec3;

namespace
{

/// A patch built face by face from the corners' coordinates.
class PatchBuilder
{
public:
    void add(const std::vector<vector>& corners)
    {
        face f(label(corners.size()));
        forAll(f, k) f[k] = pointAt(corners[k]);
        faces_.append(f);
    }

    /// The regions of all faces added, and their area minus the faces' area.
    std::vector<nscd::WallRegion> regions() const
    {
        const primitivePatch patch(SubList<face>(faces_, faces_.size()), points_);
        return coplanarRegions(patch, 0);
    }

    scalar area() const
    {
        scalar sum = 0;
        for (const face& f : faces_) sum += f.mag(points_);
        return sum;
    }

private:
    label pointAt(const vector& x)
    {
        const auto key = std::make_tuple(x.x(), x.y(), x.z());
        const auto added = index_.emplace(key, points_.size());
        if (added.second) points_.append(x);
        return added.first->second;
    }

    std::map<std::tuple<scalar, scalar, scalar>, label> index_;
    pointField points_;
    faceList faces_;
};

scalar areaOf(const std::vector<nscd::WallRegion>& regions)
{
    scalar sum = 0;
    for (const nscd::WallRegion& region : regions) sum += regionArea(region);
    return sum;
}

/// Signed solid angle of the triangle a b c seen from the origin (van Oosterom and Strackee 1983).
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2*std::atan2(a.dot(b.cross(c)), la*lb*lc + a.dot(b)*lc + b.dot(c)*la + c.dot(a)*lb);
}

/// 1 for a point inside a closed surface whose normals point inwards, 0 outside. Independent of nearestPoint().
double inwardWinding(const std::vector<nscd::WallRegion>& regions, const Vec3& x)
{
    double sum = 0;
    for (const nscd::WallRegion& region : regions)
    {
        for (const nscd::WallEdge& edge : region.edges)
        {
            sum -= solidAngle(region.point - x, edge.start - x, edge.end - x);
        }
    }
    return sum/(4*constant::mathematical::pi);
}

/// Square cells [i, i+1] x [j, j+1] of the plane z = 0 whose faces look down, as the floor of a mesh above them does.
void addFloorCell(PatchBuilder& builder, int i, int j)
{
    const scalar x = i, y = j;
    builder.add({{x, y, 0}, {x, y + 1, 0}, {x + 1, y + 1, 0}, {x + 1, y, 0}});
}

} // namespace

TEST(MeshWalls, eachSideOfABoxIsOneRectangle)
{
    BoxMeshSettings settings;
    settings.cells = labelVector(2, 30, 90);
    settings.min = point(-0.1, 0.2, 0);
    settings.max = point(0.1, 0.7, 0.9);
    BoxMesh box(settings);
    const nscd::Walls walls = wallsOf(box);
    ASSERT_EQ(walls.regions.size(), 6u);
    ASSERT_EQ(walls.patches.size(), 6u);
    for (const nscd::WallRegion& region : walls.regions)
    {
        EXPECT_EQ(region.edges.size(), 4u);
        const polyPatch& patch = box.mesh().boundaryMesh()[walls.patches[region.patch].name];
        scalar area = 0;
        for (const vector& s : patch.faceAreas()) area += mag(s);
        EXPECT_NEAR(regionArea(region), area, 1e-12*area);
        EXPECT_NEAR(toFoam(region.normal) & patch.faceAreas()[0]/mag(patch.faceAreas()[0]), -1, 1e-12);
    }
    EXPECT_NEAR(inwardWinding(walls.regions, Vec3(0.05, 0.3, 0.8)), 1, 1e-12);
    EXPECT_NEAR(inwardWinding(walls.regions, Vec3(0.2, 0.3, 0.8)), 0, 1e-12);
}

TEST(MeshWalls, everyInnerPointSeesItsNearestSide)
{
    BoxMeshSettings settings;
    settings.cells = labelVector(3, 4, 5);
    BoxMesh box(settings);
    const nscd::Walls walls = wallsOf(box);
    const Vec3 x(0.1, 0.5, 0.7);
    for (const nscd::WallRegion& region : walls.regions)
    {
        const nscd::WallProximity near = nscd::nearestPoint(region, x);
        EXPECT_TRUE(near.isInside);
        EXPECT_GT(near.distance, 0);
        EXPECT_NEAR(near.distance, std::abs(region.normal.dot(x - region.point)), 1e-14);
    }
}

TEST(MeshWalls, anLShapedFloorHasSixEdges)
{
    PatchBuilder floor;
    for (int i = 0; i < 6; ++i)
    {
        for (int j = 0; j < 6; ++j)
        {
            if (i < 2 || j < 3) addFloorCell(floor, i, j);
        }
    }
    const auto regions = floor.regions();
    ASSERT_EQ(regions.size(), 1u);
    EXPECT_EQ(regions[0].edges.size(), 6u);
    EXPECT_NEAR(areaOf(regions), floor.area(), 1e-12*floor.area());
    EXPECT_NEAR(regions[0].normal.z(), 1, 1e-14);
    EXPECT_TRUE(nscd::nearestPoint(regions[0], Vec3(1, 5, 1)).isInside);
    EXPECT_FALSE(nscd::nearestPoint(regions[0], Vec3(3, 4, 1)).isInside);
}

TEST(MeshWalls, aHoleIsPartOfTheOutline)
{
    PatchBuilder floor;
    for (int i = 0; i < 5; ++i)
    {
        for (int j = 0; j < 4; ++j)
        {
            if (i < 2 || i > 3 || j != 2) addFloorCell(floor, i, j);
        }
    }
    const auto regions = floor.regions();
    ASSERT_EQ(regions.size(), 1u);
    EXPECT_EQ(regions[0].edges.size(), 8u);
    EXPECT_NEAR(areaOf(regions), 18, 1e-12);
    EXPECT_FALSE(nscd::nearestPoint(regions[0], Vec3(3.2, 2.5, 1)).isInside);
    EXPECT_TRUE(nscd::nearestPoint(regions[0], Vec3(3.2, 1.5, 1)).isInside);
    EXPECT_TRUE(nscd::nearestPoint(regions[0], Vec3(4.5, 2.5, 1)).isInside);
}

TEST(MeshWalls, cellsThatTouchInAPointKeepTheirCorners)
{
    PatchBuilder floor;
    addFloorCell(floor, 0, 0);
    addFloorCell(floor, 1, 0);
    addFloorCell(floor, 0, 1);
    addFloorCell(floor, 1, 2);  // meets the cell (0, 1) in a corner only
    const auto regions = floor.regions();
    EXPECT_EQ(regions.size(), 2u);
    EXPECT_NEAR(areaOf(regions), 4, 1e-12);
}

TEST(MeshWalls, aCylinderKeepsItsFacetsAndItsCapsAreWhole)
{
    const int n = 40, layers = 5;
    const scalar height = 3;
    PatchBuilder wall;
    const auto at = [&](int k, scalar r, scalar z)
    {
        const scalar angle = constant::mathematical::twoPi*(k % n)/n;
        return vector(r*Foam::cos(angle), r*Foam::sin(angle), z);
    };
    for (int k = 0; k < n; ++k)
    {
        for (int l = 0; l < layers; ++l)
        {
            const scalar z0 = height*l/layers, z1 = height*(l + 1)/layers;
            wall.add({at(k, 1, z0), at(k + 1, 1, z0), at(k + 1, 1, z1), at(k, 1, z1)});
        }
        for (const scalar r : {0.5, 1.0})
        {
            const auto inner = [&](int j, scalar z) { return at(j, r - 0.5, z); };
            std::vector<vector> top = {inner(k, height), at(k, r, height), at(k + 1, r, height), inner(k + 1, height)};
            std::vector<vector> bottom = {inner(k, 0), inner(k + 1, 0), at(k + 1, r, 0), at(k, r, 0)};
            if (r < 0.75)
            {
                top.pop_back();
                bottom.erase(bottom.begin());
                bottom = {inner(k, 0), at(k + 1, r, 0), at(k, r, 0)};
            }
            wall.add(top);
            wall.add(bottom);
        }
    }
    const auto regions = wall.regions();
    EXPECT_EQ(regions.size(), std::size_t(n + 2));
    EXPECT_NEAR(areaOf(regions), wall.area(), 1e-12*wall.area());
    EXPECT_NEAR(inwardWinding(regions, Vec3(0.3, -0.4, 2.9)), 1, 1e-12);
    EXPECT_NEAR(inwardWinding(regions, Vec3(0.3, -0.4, 3.1)), 0, 1e-12);
}

namespace
{

point twisted(const point& x)
{
    const scalar angle = 0.4*x.z();
    const scalar a = x.x() - 0.5, b = x.y() - 0.5;
    return point(a*Foam::cos(angle) - b*Foam::sin(angle), a*Foam::sin(angle) + b*Foam::cos(angle), x.z());
}

BoxMesh twistedBox()
{
    BoxMeshSettings settings;
    settings.cells = labelVector(3, 3, 3);
    settings.movePoint = twisted;
    return BoxMesh(settings);
}

} // namespace

TEST(MeshWalls, twistedFacesBecomeTrianglesThatCloseTheSurface)
{
    BoxMesh box = twistedBox();
    const nscd::Walls walls = wallsOf(box);
    // The four twisted sides: 9 faces of 4 triangles each; top and bottom stay flat.
    EXPECT_EQ(walls.regions.size(), 4u*36 + 2);
    EXPECT_NEAR(inwardWinding(walls.regions, Vec3(0.1, 0.1, 0.5)), 1, 1e-12);
    EXPECT_NEAR(inwardWinding(walls.regions, Vec3(0.9, 0.1, 0.5)), 0, 1e-12);
}

TEST(MeshWalls, whatTwistedWallsHoldIsInACell)
{
    BoxMesh box = twistedBox();
    const nscd::Walls walls = wallsOf(box);
    const MappingMesh mappingMesh = makeMappingMesh(box.mesh());
    const CellLocator locator(mappingMesh, box.mesh());
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> random(0, 1);
    int held = 0, missed = 0;
    const int number = 3000;
    for (int k = 0; k < number; ++k)
    {
        // About a side, whose faces are twisted by 5e-3.
        const Vec3 x = toVec3(twisted({1 + 1e-2*(random(generator) - 0.5), random(generator), random(generator)}));
        const bool isHeld = inwardWinding(walls.regions, x) > 0.5;
        held += isHeld;
        missed += isHeld && locator.find(x, -1) < 0;
    }
    EXPECT_EQ(missed, 0);
    EXPECT_GT(held, number/4);
    EXPECT_LT(held, number*3/4);
}

TEST(MeshWalls, aSlantedWallIsOneRegionInSpiteOfTenDigitPoints)
{
    BoxMeshSettings settings;
    settings.cells = labelVector(60, 3, 40);
    settings.movePoint = [](const point& x)
    {
        const scalar z = x.z() + 0.37*x.x() + 0.11*x.y();
        return point(x.x(), x.y(), std::round(z*1e10)*1e-10);
    };
    BoxMesh box(settings);
    const nscd::Walls walls = wallsOf(box);
    EXPECT_EQ(walls.regions.size(), 6u);
    for (const nscd::WallRegion& region : walls.regions) EXPECT_EQ(region.edges.size(), 4u);
}
