// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes that are wrong in one place, and what must be said of them.
#pragma once

#include "sceneFiles.hpp"

#include "grainSources.hpp"
#include "motionReader.hpp"

#include <ostream>
#include <vector>

namespace sceneFiles
{

struct BadScene
{
    std::string name;
    std::string from;                    ///< in the good scene
    std::string to;
    int line;                            ///< 0: the scene as a whole
    std::vector<std::string> mentions;   ///< what the message must hold
};

inline void PrintTo(const BadScene& bad, std::ostream* os) { *os << bad.name; }

/// All that is done with a scene before its first step.
inline void readAndPlace(const std::string& text)
{
    const nscdGrains::SceneSettings scene = nscdGrains::parseScene(text, "folder/bad.scene");
    nscd::Grains grains = nscdGrains::placeGrains(scene);
    nscdGrains::holdDriven(scene, grains);
    nscdGrains::checkGrains(scene, grains);
}

inline void expectRefused(const BadScene& bad)
{
    const std::string text = changed(goodScene(), bad.from, bad.to);
    std::string message;
    try
    {
        readAndPlace(text);
    }
    catch (const nscdGrains::SceneError& error)
    {
        message = error.what();
    }
    ASSERT_FALSE(message.empty()) << "was accepted:\n" << text;
    const std::string place = bad.line > 0 ? "folder/bad.scene, line " + std::to_string(bad.line) + ": " : "folder/bad.scene: ";
    EXPECT_EQ(message.compare(0, place.size(), place), 0) << message;
    for (const std::string& words : bad.mentions) EXPECT_NE(message.find(words), std::string::npos) << message;
}

} // namespace sceneFiles
