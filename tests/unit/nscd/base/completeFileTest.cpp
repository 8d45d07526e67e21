// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that are there whole or not at all.
#include "nscd/base/completeFile.hpp"
#include "unit/fileSizeLimit.hpp"
#include "unit/input/folders.hpp"

#include <sstream>

namespace
{

class CompleteFiles : public folders::InFolder
{
protected:
    void SetUp() override
    {
        InFolder::SetUp();
        path = folder/"result";
    }

    std::string content() const
    {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }

    std::string path;
};

/// What a failure to write says; empty if nothing fails.
template<class Action>
std::string failure(const Action& action)
{
    try
    {
        action();
        return "";
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
}

} // namespace

TEST_F(CompleteFiles, haveTheirNameOnceTheyAreComplete)
{
    nscd::CompleteFile file(path);
    file.stream() << "some ";
    file.write("words", 5);
    EXPECT_FALSE(std::filesystem::exists(path));
    file.complete();
    EXPECT_EQ(content(), "some words");
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST_F(CompleteFiles, leaveTheOldOneWhereTheyAreGivenUp)
{
    write("result", "old");
    {
        nscd::CompleteFile file(path);
        file.stream() << "new";
    }
    EXPECT_EQ(content(), "old");
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST_F(CompleteFiles, sayWhyTheyCannotBeWritten)
{
    const std::string nowhere = folder/"none"/"result";
    const std::string missing = failure([&] { nscd::CompleteFile file(nowhere); });
    EXPECT_EQ(missing, "cannot write " + nowhere + ": No such file or directory");

    const FileSizeLimit limit(1000);
    ASSERT_TRUE(limit.isSet());
    const std::string expected = "cannot write " + path + ": File too large", text(2000, 'x');
    EXPECT_EQ(failure([&] { nscd::CompleteFile(path).write(text.data(), text.size()); }), expected);
    nscd::CompleteFile file(path);
    for (char letter : text) file.stream().put(letter);   // into a buffer
    EXPECT_EQ(failure([&] { file.complete(); }), expected);
    EXPECT_FALSE(std::filesystem::exists(path));
}
