// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes for the tests of nscdGrains: a text that runs, and changes to it.
#pragma once

#include "sceneSettings.hpp"
#include "unit/input/folders.hpp"
#include "unit/input/frontEnds.hpp"

#include <gtest/gtest.h>

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

/// All that is done with a scene before its first step.
inline nscd::Grains readAndPlace(const std::string& text, const std::string& file = "folder/scene")
{
    const nscdGrains::SceneSettings scene = nscdGrains::parseScene(text, file);
    const nscd::Grains grains = nscdGrains::placeGrains(scene);
    nscdGrains::checkGrains(scene, grains);
    return grains;
}

/// The good scene with another source of grains.
inline std::string sceneWith(const std::string& source)
{
    return changed(goodScene(), "type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;", source);
}

/// What is said of a scene; no text where nothing is wrong.
inline frontEnds::Complaint complaint(const std::string& text, const std::string& file = "folder/scene")
{
    try
    {
        readAndPlace(text, file);
    }
    catch (const input::InputError& error)
    {
        return {error.mistake().place.file, error.mistake().place.line, input::describe(error.mistake())};
    }
    return {};
}

/// Refused for what is wrong in a line, with these pieces of text.
inline void expectRefused(const std::string& text, int line, const std::vector<std::string>& mentions)
{
    const frontEnds::Complaint said = complaint(text);
    ASSERT_FALSE(said.text.empty()) << "was accepted";
    EXPECT_EQ(said.line, line) << said.text;
    frontEnds::expectMentions(said, mentions);
}

inline std::string bytesOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return std::string(std::istreambuf_iterator<char>(file), {});
}

using folders::InFolder;

} // namespace sceneFiles
