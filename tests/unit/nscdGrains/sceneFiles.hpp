// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes for the tests of nscdGrains: a text that runs, changes to it, and folders that go away.
#pragma once

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace sceneFiles
{

/// One keyword a line, for tests of line numbers.
inline std::string goodScene()
{
    return
        "materials { glass { density 2500; } steel {} }\n"
        "contacts  { default { friction 0.3; restitution 0.2; } }\n"
        "grains    { type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5; }\n"
        "wallMaterial steel;\n"
        "walls     { tray { type box; box (0 0 0) (0.06 0.06 0.2); } }\n"
        "periodic  { }\n"
        "solver    { type NLGS; }\n"
        "deltaT    1e-3;\n"
        "endTime   0.09;\n"
        "writeInterval 0.03;\n"
        "gravity   (0 0 -9.81);\n";
}

/// The text with the first `from` replaced.
inline std::string changed(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

inline std::string bytesOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return std::string(std::istreambuf_iterator<char>(file), {});
}

/// A folder of its own for each test.
class InFolder : public testing::Test
{
protected:
    void SetUp() override
    {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder = std::filesystem::temp_directory_path()/("nscdGrains." + name + std::to_string(::getpid()));
        std::filesystem::create_directory(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::string write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder/name, std::ios::binary) << text;
        return folder/name;
    }

    std::filesystem::path folder;
};

} // namespace sceneFiles
