// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files of rows of numbers: as they should be, and what is said of wrong ones.
#include "input/lists/textRows.hpp"

#include "unit/input/folders.hpp"

#include <gtest/gtest.h>

namespace
{

class TextRows : public folders::InFolder
{
protected:
    const input::Place source = {"scene", 4, "forces.drag.table"};

    std::string complaintAbout(const std::string& text)
    {
        try
        {
            input::readNumberTable(write("table", text), {"Re", "alpha", "Cd"}, source);
        }
        catch (const input::InputError& error)
        {
            return error.what();
        }
        return "";
    }
};

} // namespace

TEST_F(TextRows, numbersWithTheirLines)
{
    const std::string path = write("table", "# Re alpha Cd\n1 0.4 200\n\n 1e2,0.4,\t2e1, # last\r\n");
    const std::vector<input::NumberRow> rows = input::readNumberTable(path, {"Re", "alpha", "Cd"}, source);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].values, (std::vector<double>{1, 0.4, 200}));
    EXPECT_EQ(rows[1].values, (std::vector<double>{100, 0.4, 20}));
    EXPECT_EQ(rows[1].place.line, 4);
}

TEST_F(TextRows, wrongOnesAreToldWithTheirLine)
{
    for (const char* row : {"1 0.4", "1 0.4 2 3", "1 0.4 x", "1 0.4 2x", "1 nan 2", "1 0.4 1e99"})
    {
        const std::string complaint = complaintAbout(std::string("1 0.4 200\n") + row + "\n");
        EXPECT_NE(complaint.find("table"), std::string::npos) << row;
        EXPECT_NE(complaint.find("without 3 finite numbers"), std::string::npos) << row << ": " << complaint;
        EXPECT_NE(complaint.find("rows of Re alpha Cd"), std::string::npos) << row;
        EXPECT_NE(complaint.find("line 2"), std::string::npos) << row << ": " << complaint;
    }
    EXPECT_NE(complaintAbout("# nothing\n").find("without rows"), std::string::npos);
    EXPECT_NE(complaintAbout(std::string("1 0.4\0 2", 8)).find("no text"), std::string::npos);
}
