// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of `walls` in grainProperties: surfaces and planes beside the mesh, their motions and belts, and what is said about bad ones.
#include "caseTools.H"

#include "OSspecific.H"

#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

using nscd::Vec3;

namespace
{

const std::string lidPlane = "type plane; point (0 0 1); normal (0 0 -1); ";

/// The walls of a box of one cell with a plane `lid` of `walls`.
nscd::Walls withLid(const std::string& more)
{
    BoxMesh box;
    return wallsOf(box, "walls { lid { " + lidPlane + more + " } }");
}

std::string complaintAboutWalls(const std::string& walls)
{
    return complaint([&] { BoxMesh box; wallsOf(box, "walls { " + walls + " }"); });
}

/// An STL file of two triangles that is there as long as the object is.
struct StlFile
{
    const fileName path = cwd()/"caseFreeWallsTest.stl";

    explicit StlFile(const std::string& secondVertex = "vertex 2 0 0")
    {
        std::ofstream os(path);
        os << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n" << secondVertex << "\nvertex 0 2 0\nendloop\nendfacet\n"
           << "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 1\nvertex 2 2 2\nendloop\nendfacet\nendsolid a\n";
    }
    ~StlFile() { rm(path); }
};

const nscd::WallPatch& lidAt(nscd::Walls& walls, double time)
{
    nscd::moveWalls(walls, time);
    return walls.patches.back();
}

} // namespace

TEST(FreeWalls, speedsAreIntegratedAndPlacesTaken)
{
    nscd::Walls walls = withLid("motion { type translation; velocity table ((0 (0 0 0)) (2 (0 0 -1))); }");
    EXPECT_EQ(walls.patches.back().name, "lid");
    EXPECT_NEAR(lidAt(walls, 2).pose.translation()[2], -1, 1e-11);
    EXPECT_NEAR(lidAt(walls, 3).pose.translation()[2], -2, 1e-11);   // the last speed goes on
    walls = withLid("motion { type translation; displacement table ((0 (0 0 0)) (2 (0 0 -1))); }");
    EXPECT_NEAR(lidAt(walls, 1).pose.translation()[2], -0.5, 1e-14);
    walls = withLid("motion { type oscillation; amplitude (0 0 0.1); frequency [0 0 -1 0 0] 5; phase 0.3; }");
    EXPECT_NEAR(lidAt(walls, 0.07).pose.translation()[2], 0.1*std::sin(2*M_PI*5*0.07 + 0.3), 1e-14);
    walls = withLid("motion { type rotation; origin (1 0 0); axis (0 0 2); omega { type sine; frequency 1; amplitude 2; scale 1; level 0; } }");
    const double angle = 2*(1 - std::cos(2*M_PI*0.4))/(2*M_PI);
    EXPECT_NEAR((lidAt(walls, 0.4).pose*Vec3(2, 0, 0) - Vec3(1 + std::cos(angle), std::sin(angle), 0)).norm(), 0, 1e-11);
    EXPECT_EQ(walls.patches.back().torquePoint, Vec3(1, 0, 0));
}

TEST(FreeWalls, beltsAreForMeshPatchesToo)
{
    BoxMesh box;
    const std::string name = box.mesh().boundaryMesh()[0].name();
    nscd::Walls walls = wallsOf(box, "patches { " + name + " { type wall; surfaceVelocity (1 2 3); torquePoint (0 0 1); } }");
    EXPECT_EQ(walls.patches[0].surfaceMotion(7).at(Vec3::Zero()), Vec3(1, 2, 3));
    EXPECT_EQ(walls.patches[0].torquePoint, Vec3(0, 0, 1));
    EXPECT_FALSE(walls.patches[1].hasVelocity());
    walls = withLid("surfaceRotation { origin (0 0 0); axis (0 0 3); omega 2; }");
    EXPECT_EQ(walls.patches.back().surfaceMotion(0).at(Vec3(1, 0, 0)), Vec3(0, 2, 0));
}

TEST(FreeWalls, surfacesComeFromFiles)
{
    const StlFile file;
    BoxMesh box;
    const nscd::Walls walls = wallsOf(box, "walls { sheet { type stl; file \"" + file.path + "\"; scale 0.5; } }");
    ASSERT_EQ(walls.regions.back().edges.size(), 3u);
    EXPECT_EQ(walls.regions.back().edges[0].end, Vec3(1, 0, 0));
    EXPECT_TRUE(walls.regions.back().isTwoSided);
    EXPECT_FALSE(wallsOf(box, "walls { s { type stl; file \"" + file.path + "\"; sides one; } }").regions.back().isTwoSided);
}

/// Further wrong walls are in sharedInputTest.C.
TEST(FreeWalls, badOnesAreRefusedInWords)
{
    EXPECT_TRUE(holds(complaintAboutWalls("a { type stl; file \"none.stl\"; }"), {"walls.a.file", "triSurface/none.stl", "does not exist"}));
    const StlFile bad("vertex 2 0");
    EXPECT_TRUE(holds(complaintAboutWalls("a { type stl; file \"" + bad.path + "\"; }"), {"walls.a.file", "line 6", "'vertex'"}));
    BoxMesh box;
    const std::string name = box.mesh().boundaryMesh()[0].name();
    EXPECT_TRUE(holds(complaintAboutWalls(name + " { " + lidPlane + " }"), {"walls." + name, "another wall"}));
}

TEST(FreeWalls, boxesAndPolygonsAreWallsToo)
{
    BoxMesh box;
    const nscd::Walls walls = wallsOf(box, "walls { b { type box; box (0.1 0.1 0.1) (0.9 0.9 0.9); } p { type polygon; vertices ((0 0 0.5) (1 0 0.5) (1 1 0.5)); } }");
    ASSERT_EQ(walls.patches.size(), 8u);
    EXPECT_EQ(walls.patches[7].name, "p");
    EXPECT_EQ(walls.regions.size(), 6u + 6u + 1u);
    EXPECT_EQ(walls.regions.back().patch, 7);
    EXPECT_EQ(walls.regions.back().normal, Vec3(0, 0, 1));
}
