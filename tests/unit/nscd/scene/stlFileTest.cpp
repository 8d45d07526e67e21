// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// STL files: both forms, several solids, and what is wrong with a file in words that name the place.
#include "nscd/scene/stlFile.hpp"

#include "nscd/scene/walls.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

using nscd::Triangle;
using nscd::Vec3;

namespace
{

/// A file that is there as long as the object is.
class TemporaryFile
{
public:
    explicit TemporaryFile(const std::string& content) : path_(testing::TempDir() + std::to_string(::getpid()) + ".nscdStlTest.stl")
    {
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~TemporaryFile() { std::remove(path_.c_str()); }
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

std::vector<Triangle> readText(const std::string& content, double scale = 1.0)
{
    return nscd::readStl(TemporaryFile(content).path(), scale);
}

/// What a refusal says; empty if nothing is refused.
std::string refusal(const std::string& content)
{
    try
    {
        readText(content);
        return "";
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
}

void expectSaid(const std::string& text, const std::vector<std::string>& parts)
{
    for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
}

const std::string facet =
    "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1 0 0\n      vertex 0 1.5e0 0\n    endloop\n  endfacet\n";

std::string binary(const std::vector<Triangle>& triangles, const std::string& head, std::uint32_t stated)
{
    std::string content = head;
    content.resize(80, ' ');
    content.append(reinterpret_cast<const char*>(&stated), 4);
    for (const Triangle& t : triangles)
    {
        float values[12] = {0, 0, 0};
        for (int k = 0; k < 9; ++k) values[3 + k] = static_cast<float>(t[k/3][k % 3]);
        content.append(reinterpret_cast<const char*>(values), sizeof(values));
        content.append(2, '\0');
    }
    return content;
}

const std::vector<Triangle> two = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1.5, 0)}, {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0.25)}};

} // namespace

TEST(Stl, readsAsciiOfSeveralSolids)
{
    const std::string twice = "solid first part\n" + facet + "endsolid first part\nSOLID\r\n" + facet + facet + "endsolid\n";
    const std::vector<Triangle> triangles = readText(twice, 0.001);
    ASSERT_EQ(triangles.size(), 3u);
    for (const Triangle& t : triangles) EXPECT_EQ(t[2], Vec3(0, 1.5*0.001, 0));
}

TEST(Stl, readsBinaryEvenIfItBeginsWithSolid)
{
    for (const char* head : {"made by hand", "solid but binary"})
    {
        const std::vector<Triangle> triangles = readText(binary(two, head, 2));
        ASSERT_EQ(triangles.size(), 2u);
        for (int k = 0; k < 3; ++k) EXPECT_EQ(triangles[1][k], two[1][k]);
    }
}

TEST(Stl, saysWhatIsWrongAndWhere)
{
    expectSaid(refusal("solid a\n" + facet + "  facet normal 0 0 1\n outer loop\n vertex 0 0\n"), {"nscdStlTest.stl, line 12", "the file ends"});
    expectSaid(refusal("solid a\n" + facet), {"line 9", "the file ends", "endsolid"});
    expectSaid(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n"), {"line 4", "nan", "finite"});
    expectSaid(refusal("solid a\nfacet normal 0 0 1\nouter lop\n"), {"line 3", "'lop'", "'loop'"});
    expectSaid(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1,5\n"), {"line 4", "'1,5'", "coordinate"});
    expectSaid(refusal("solid a\nendsolid a\n"), {"holds no triangle"});
    expectSaid(refusal("v 0 0 0\nv 1 0 0\n"), {"neither an ASCII nor a binary"});
    expectSaid(refusal(""), {"neither"});
    expectSaid(refusal(binary(two, "cut", 5)), {"states 5 triangles", "holds 2", "truncated"});
    expectSaid(refusal(binary(two, "solid cut", 3)), {"states 3 triangles", "truncated"});
    std::vector<Triangle> bad = two;
    bad[1][2][0] = std::numeric_limits<double>::quiet_NaN();
    expectSaid(refusal(binary(bad, "nan", 2)), {"triangle 2 of 2", "finite"});
    EXPECT_THROW(nscd::readStl("/no/such/file.stl"), std::invalid_argument);
    EXPECT_THROW(readText("solid a\n" + facet + "endsolid\n", 0.0), std::invalid_argument);
}

TEST(Stl, leavesOutTrianglesWithoutArea)
{
    nscd::Walls walls;
    const int patch = walls.addPatch("sheet", 0);
    std::vector<Triangle> triangles = two;
    triangles.push_back({Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)});
    triangles.push_back({Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)});
    EXPECT_EQ(walls.addTriangles(patch, triangles), 2u);
    EXPECT_EQ(walls.regions.size(), 2u);
    EXPECT_THROW(walls.addTriangles(patch, {triangles[2], triangles[3]}), std::invalid_argument);
    triangles[0][0][0] = std::numeric_limits<double>::infinity();
    EXPECT_THROW(walls.addTriangles(patch, triangles), std::invalid_argument);
}
