// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files of named arrays: what goes in comes out, and nothing else is taken for it.
#include "nscd/base/sectionFile.hpp"
#include "nscd/base/vec3.hpp"
#include "unit/input/folders.hpp"

#include <iterator>

using namespace nscd;

namespace
{

class SectionFiles : public folders::InFolder
{
protected:
    void SetUp() override
    {
        InFolder::SetUp();
        path = folder/"arrays";
        SectionFileWriter writer(path, "nscdTest", 3);
        writer.section("position", positions);
        writer.section("number", numbers);
        writer.section("nothing", std::vector<double>());
        writer.complete();
    }

    std::string bytes() const
    {
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }

    /// The words of the refusal of a file with these bytes; empty if it is taken.
    std::string refusal(const std::string& content)
    {
        write("arrays", content);
        return refusalOf("number");
    }

    /// The same of the file as it is, whose second section is expected to have this name.
    std::string refusalOf(const std::string& second, std::uint64_t version = 3)
    {
        try
        {
            SectionFileReader reader(path, "nscdTest", version);
            std::vector<double> none;
            reader.section("position", readPositions);
            reader.section(second.c_str(), readNumbers);
            reader.section("nothing", none);
            reader.finish();
            return none.empty() ? "" : "more than was written";
        }
        catch (const std::invalid_argument& error)
        {
            return error.what();
        }
    }

    std::string path;
    const std::vector<Vec3> positions = {Vec3(1, 2, 3), Vec3(-0.1, 1e300, 0)};
    const std::vector<int> numbers = {5, -6, 7};
    std::vector<Vec3> readPositions;
    std::vector<int> readNumbers;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_F(SectionFiles, giveBackWhatWasWritten)
{
    EXPECT_EQ(refusalOf("number"), "");
    EXPECT_EQ(readPositions, positions);
    EXPECT_EQ(readNumbers, numbers);
}

TEST_F(SectionFiles, refuseWhatIsTorn)
{
    const std::string whole = bytes();
    for (std::size_t length = 0; length < whole.size(); length += 3) EXPECT_NE(refusal(whole.substr(0, length)), "") << length;
    EXPECT_TRUE(has(refusal(whole.substr(0, whole.size() - 1)), "cut short"));
    EXPECT_TRUE(has(refusal(whole + '\0'), "longer"));
}

TEST_F(SectionFiles, refuseAnyChangedBit)
{
    const std::string whole = bytes();
    for (std::size_t k = 0; k < whole.size(); k += 3)
    {
        std::string changed = whole;
        changed[k] = static_cast<char>(changed[k] ^ (1 << k % 8));
        EXPECT_NE(refusal(changed), "") << "byte " << k;
    }
}

TEST_F(SectionFiles, refuseAnotherNameSizeOrVersion)
{
    EXPECT_TRUE(has(refusalOf("velocity"), "damaged where 'velocity' should begin"));
    EXPECT_TRUE(has(refusalOf("number", 4), "of version 3"));
    std::vector<Vec3> wrong;
    SectionFileReader reader(path, "nscdTest", 3);
    reader.section("position", readPositions);
    EXPECT_THROW(reader.section("number", wrong), std::invalid_argument);  // 12 bytes are no vectors
}

TEST(SectionFileNames, areCutAtSixteenLettersAndComparedWhole)
{
    using nscd::sectionFile::Name;
    EXPECT_TRUE(Name("mass") == Name("mass"));
    EXPECT_FALSE(Name("mass") == Name("masses"));
    EXPECT_TRUE(Name("abcdefghijklmnop") == Name("abcdefghijklmnopq"));
}
