// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Scenes as plain text, a keyword and numbers a line, which peers/plainScene.py writes for all programs; and the options of a run.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace scenes
{

inline Vec3 vectorOf(const std::vector<double>& v, std::size_t first) { return Vec3(v.at(first), v.at(first + 1), v.at(first + 2)); }

inline std::vector<double> numbersOf(std::string words)
{
    for (char& letter : words) if (letter == ',') letter = ' ';
    std::istringstream line(words);
    std::vector<double> numbers;
    for (double x; line >> x;) numbers.push_back(x);
    return numbers;
}

/// Materials by number, each with its friction against walls and all that come after it; the wall is the last.
inline void setFriction(Scene& scene, const std::vector<double>& friction, double restitution)
{
    scene.materials = nscd::Materials();
    const int wall = static_cast<int>(friction.size());
    for (int k = 0; k < wall; ++k) scene.materials.add("grain" + std::to_string(k));
    scene.materials.add("wall");
    for (int a = 0; a < wall; ++a)
    {
        for (int b = a; b <= wall; ++b) scene.materials.setPair(a, b, {friction[a], restitution});
    }
}

/// grain: place, radius, density, material, velocity, spin.
inline void addPlainGrain(Scene& scene, const std::vector<double>& v)
{
    nscd::Grains& grains = scene.grains;
    grains.add(vectorOf(v, 0), v.at(3), v.at(4), static_cast<int>(v.at(5)), static_cast<std::int64_t>(grains.size()));
    grains.velocity.back() = vectorOf(v, 6);
    grains.omega.back() = vectorOf(v, 9);
}

/// Errors: std::invalid_argument for a line that begins with an unknown word, std::out_of_range for one with too few numbers
inline Scene readPlainScene(const std::string& path)
{
    Scene scene(3, 0.0, 0.0);
    std::ifstream file(path);
    if (!file) throw std::invalid_argument("cannot read " + path);
    std::vector<double> friction{0.0};
    std::vector<nscd::Triangle> triangles;
    std::vector<std::pair<Vec3, Vec3>> planes;
    double restitution = 0.0;
    for (std::string line, word; std::getline(file, line);)
    {
        word = line.substr(0, line.find(' '));
        const std::vector<double> v = numbersOf(line.substr(word.size()));
        if (word == "dimensions") scene.grains.shape.dimensions = static_cast<int>(v.at(0));
        else if (word == "emptyAxis") scene.grains.shape.emptyAxis = static_cast<int>(v.at(0));
        else if (word == "period") scene.box.length = vectorOf(v, 0);
        else if (word == "gravity") scene.g = vectorOf(v, 0);
        else if (word == "restitution") restitution = v.at(0);
        else if (word == "friction") friction = v;
        else if (word == "plane") planes.emplace_back(vectorOf(v, 0), vectorOf(v, 3));
        else if (word == "triangle") triangles.push_back({vectorOf(v, 0), vectorOf(v, 3), vectorOf(v, 6)});
        else if (word == "grain") addPlainGrain(scene, v);
        else throw std::invalid_argument(path + ": unknown word " + word);
    }
    setFriction(scene, friction, restitution);
    const int wall = static_cast<int>(friction.size());
    for (const auto& [point, normal] : planes)
    {
        scene.walls.addPlane(scene.walls.addPatch("wall" + std::to_string(scene.walls.patches.size()), wall), point, normal);
    }
    if (!triangles.empty()) scene.walls.addTriangles(scene.walls.addPatch("surface", wall), triangles);
    return scene;
}

struct RunOptions
{
    double deltaT = 1e-3;
    int warmUp = 0;     ///< steps before the first that counts, for costs alone
    nscd::ContactSettings contacts;
};

/// Errors: std::invalid_argument for an unknown word
inline RunOptions readOptions(int argc, char** argv, int first)
{
    RunOptions options;
    for (int k = first; k < argc; ++k)
    {
        const std::string word = argv[k], name = word.substr(0, word.find('='));
        const double value = std::stod(word.substr(name.size() + 1));
        if (name == "deltaT") options.deltaT = value;
        else if (name == "warmUp") options.warmUp = static_cast<int>(value);
        else if (name == "tolerance") options.contacts.tolerance = value;
        else if (name == "displacementTolerance") options.contacts.displacementTolerance = value;
        else if (name == "forceTolerance") options.contacts.forceTolerance = value;
        else if (name == "maxSweeps") options.contacts.maxSweeps = static_cast<int>(value);
        else if (name == "sleep") options.contacts.sleep = value != 0.0;
        else throw std::invalid_argument("unknown option " + word);
    }
    return options;
}

} // namespace scenes
