// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that list grains, as they should be; wrongInputs.hpp has those that are wrong.
#include "input/lists/grainFiles.hpp"

#include "input/dictionary/withoutTraps.hpp"
#include "unit/input/frontEnds.hpp"
#include "unit/input/folders.hpp"

using nscd::Vec3;

namespace
{

class GrainFiles : public folders::InFolder
{
protected:
    const input::Place source = {"scene", 4, "grains.file"};
};

} // namespace

TEST_F(GrainFiles, listsOfPositions)
{
    const std::vector<Vec3> expected = {Vec3(1, -2, 3e-3), Vec3(0.1, 0.2, +0.3)};
    const char* const list = "( (1 -2 3e-3) // first\n (0.1 0.2 +0.3) )\n";
    const std::string header = "/* x */ FoamFile { version 2.0; format ascii; class vectorField; }\n";
    for (const std::string& head : {std::string(), std::string("2\n"), header, header + "2\n"})
    {
        const std::vector<Vec3> positions = input::readPositionsFile(write("list", head + list), source);
        EXPECT_EQ(positions, expected) << head;
    }
}

TEST_F(GrainFiles, tables)
{
    const std::string path = write("table", "# x y z d\n1 2 3 0.5\n\n 4,5,6,0.25,steel # heavy\r\n7\t8\t9\t1 glass");
    const std::vector<input::TableRow> rows = input::readGrainTable(path, source);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(rows[0].diameter, 0.5);
    EXPECT_EQ(rows[0].material, "");
    EXPECT_EQ(rows[1].position, Vec3(4, 5, 6));
    EXPECT_EQ(rows[1].material, "steel");
    EXPECT_EQ(rows[2].material, "glass");
    EXPECT_EQ(rows[2].line, 5);
}

TEST_F(GrainFiles, oneThatCannotBeReadIsToldWhereItWasAskedFor)
{
    for (const std::string& path : {std::string(folder), std::string(folder/"none")})
    {
        try
        {
            input::readPositionsFile(path, source);
            ADD_FAILURE() << "read " << path;
        }
        catch (const input::InputError& error)
        {
            EXPECT_EQ(std::string(error.what()).rfind("scene, line 4: keyword grains.file names a file that does not exist", 0), 0u) << error.what();
        }
    }
}

/// OpenFOAM's programs stop at an overflow, also at that of a number in a file.
TEST_F(GrainFiles, anOverflowStopsNobody)
{
    const input::WithoutTraps restoresThem;
    feenableexcept(FE_OVERFLOW | FE_INVALID | FE_DIVBYZERO);
    EXPECT_THROW(input::readPositionsFile(write("list", "((1e999 0 0))"), source), input::InputError);
    EXPECT_THROW(input::readGrainTable(write("table", "1e999 0 0 1"), source), input::InputError);
    EXPECT_NE(fegetexcept() & FE_OVERFLOW, 0);
}
