// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls in files for ParaView: where they are, and nothing that has no shape.
#include "nscd/scene/wallFile.hpp"

#include <gtest/gtest.h>

#include <sstream>

using namespace nscd;

namespace
{

std::string written(const Walls& walls, int patch)
{
    std::ostringstream os;
    writeVtk(os, walls, patch);
    return os.str();
}

const std::string head = "# vtk DataFile Version 3.0\nsheet\nASCII\nDATASET POLYDATA\n";

} // namespace

TEST(WallFile, showsThePolygonsOfAPatchWhereTheyAre)
{
    Walls walls;
    const int patch = walls.addPatch("sheet", 0), other = walls.addPatch("other", 0);
    walls.addTriangles(patch, {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0)}});
    walls.addPolygon(other, {Vec3(0, 0, 9), Vec3(1, 0, 9), Vec3(0, 1, 9)});
    walls.addPolygon(patch, {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)});
    walls.addPlane(patch, Vec3::Zero(), Vec3::UnitZ());
    walls.setMotion(patch, translation(Vec3(0, 0, 2)));
    moveWalls(walls, 1.5);
    EXPECT_EQ(written(walls, patch), head + "POINTS 7 double\n0 0 3\n1 0 3\n0 2 3\n0 0 4\n1 0 4\n1 1 4\n0 1 4\nPOLYGONS 2 9\n3 0 1 2\n4 3 4 5 6\n");
}

TEST(WallFile, showsHolesAsPolygonsOfTheirOwn)
{
    Walls walls;
    const int patch = walls.addPatch("sheet", 0);
    walls.addPolygon(patch, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)});
    const Vec3 hole[3] = {Vec3(0.2, 0.2, 0), Vec3(0.2, 0.8, 0), Vec3(0.8, 0.8, 0)};
    for (int k = 0; k < 3; ++k) walls.regions[0].edges.push_back({hole[k], hole[(k + 1) % 3]});
    const std::string text = written(walls, patch);
    EXPECT_NE(text.find("POINTS 7 double"), std::string::npos) << text;
    EXPECT_NE(text.find("POLYGONS 2 9\n4 0 1 2 3\n3 4 5 6\n"), std::string::npos) << text;
}

TEST(WallFile, ofPlanesAloneIsEmpty)
{
    Walls walls;
    walls.addPlane(walls.addPatch("sheet", 0), Vec3::Zero(), Vec3::UnitZ());
    EXPECT_EQ(written(walls, 0), head + "POINTS 0 double\nPOLYGONS 0 0\n");
}
