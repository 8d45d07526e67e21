// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that list grains, as they should be and as they should not.
#include "grainFiles.hpp"
#include "grainSources.hpp"
#include "sceneFiles.hpp"

using nscd::Vec3;

namespace
{

class GrainFiles : public sceneFiles::InFolder
{
protected:
    /// The message about a file, which must name the file and the line.
    template<class Read>
    void expectRefused(const Read& read, const std::string& text, int line, const std::string& problem) const
    {
        const std::string path = write("file", text);
        try
        {
            read(path, source);
            ADD_FAILURE() << "was accepted: " << text;
        }
        catch (const nscdGrains::SceneError& error)
        {
            const std::string message = error.what();
            const std::string place = line > 0 ? path + ", line " + std::to_string(line) + ":" : "scene, line 4:";
            EXPECT_EQ(message.compare(0, place.size(), place), 0) << message;
            EXPECT_NE(message.find(problem), std::string::npos) << message;
        }
    }

    nscdGrains::Place source = {"scene", 4, "grains.file"};
};

} // namespace

TEST_F(GrainFiles, listsOfPositions)
{
    const std::vector<Vec3> expected = {Vec3(1, -2, 3e-3), Vec3(0.1, 0.2, +0.3)};
    const char* const list = "( (1 -2 3e-3) // first\n (0.1 0.2 +0.3) )\n";
    const std::string header = "/* x */ FoamFile { version 2.0; format ascii; class vectorField; }\n";
    for (const std::string& head : {std::string(), std::string("2\n"), header, header + "2\n"})
    {
        const std::vector<Vec3> positions = nscdGrains::readPositionsFile(write("list", head + list), source);
        EXPECT_EQ(positions, expected) << head;
    }
}

TEST_F(GrainFiles, badListsOfPositions)
{
    const auto read = nscdGrains::readPositionsFile;
    expectRefused(read, "", 1, "is cut short");
    expectRefused(read, "x", 1, "does not begin with a list");
    expectRefused(read, "(\n(1 2 3)\n(1 2)\n)", 3, "not a finite number");
    expectRefused(read, "(\n(1 2 3)\n(1 nan 2)\n)", 3, "not a finite number");
    expectRefused(read, "(\n(1 2 3 4)\n)", 2, "without three coordinates");
    expectRefused(read, "(\n(1 2 3)\n(1 2", 3, "is cut short");
    expectRefused(read, "(\n(1 2 3)\n5\n)", 3, "no position");
    expectRefused(read, "3 ( (1 2 3) (4 5 6) )\n", 2, "states 3 positions and holds 2");
    expectRefused(read, "( (1 2 3) ) ( (4 5 6) )", 1, "goes on after its list");
    expectRefused(read, "()", 0, "holds no grain");
    expectRefused(read, "FoamFile { format binary; }\n(x)", 1, "binary");
    expectRefused(read, "/* (1 2 3)", 1, "cut short");
}

TEST_F(GrainFiles, tables)
{
    const std::string path = write("table", "# x y z d\n1 2 3 0.5\n\n 4,5,6,0.25,steel # heavy\r\n7\t8\t9\t1 glass");
    const std::vector<nscdGrains::TableRow> rows = nscdGrains::readGrainTable(path, source);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(rows[0].diameter, 0.5);
    EXPECT_EQ(rows[0].material, "");
    EXPECT_EQ(rows[1].position, Vec3(4, 5, 6));
    EXPECT_EQ(rows[1].material, "steel");
    EXPECT_EQ(rows[2].material, "glass");
    EXPECT_EQ(rows[2].line, 5);
}

TEST_F(GrainFiles, badTables)
{
    const auto read = nscdGrains::readGrainTable;
    expectRefused(read, "1 2 3 4\n1 2 3\n", 2, "without four finite numbers");
    expectRefused(read, "1 2 3 inf\n", 1, "without four finite numbers");
    expectRefused(read, "1 2 3x 4\n", 1, "without four finite numbers");
    expectRefused(read, "1 2 3 -4\n", 1, "diameter that is not positive");
    expectRefused(read, "1 2 3 4 glass 5\n", 1, "more than five columns");
    expectRefused(read, "# nothing\n", 0, "holds no grain");
}

TEST_F(GrainFiles, areFoundBesideTheScene)
{
    write("grains.txt", "0 0 0 0.1\n0.3 0 0 0.1 wood\n");
    const std::string text = "materials { glass { density 1; } } contacts { default { friction 0; } } deltaT 1; endTime 1;\n"
        "grains { type table; file grains.txt; }";
    try
    {
        nscdGrains::placeGrains(nscdGrains::parseScene(text, folder/"scene"));
        ADD_FAILURE() << "took an unknown material";
    }
    catch (const nscdGrains::SceneError& error)
    {
        EXPECT_NE(std::string(error.what()).find("grains.txt, line 2"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("wood"), std::string::npos) << error.what();
    }
    write("grains.txt", "0 0 0 0.1\n0.3 0 0 0.1 glass\n");
    EXPECT_EQ(nscdGrains::placeGrains(nscdGrains::parseScene(text, folder/"scene")).size(), 2u);
    EXPECT_THROW(nscdGrains::readPositionsFile(folder, source), nscdGrains::SceneError);
}
