// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Columns of discs and their shape.
#include "columns.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>

namespace columns
{

namespace
{

constexpr double deltaT = 1e-3, pi = 3.14159265358979323846;

/// Calls use(a, b, c, d) for each row of four numbers; lines that begin with # are comments.
template<class Use>
void readRows(const std::string& name, const Use& use)
{
    std::ifstream file(name);
    if (!file) throw std::runtime_error("cannot read " + name);
    for (std::string line; std::getline(file, line);)
    {
        double v[4];
        std::istringstream row(line);
        if (line.empty() || line[0] == '#') continue;
        if (!(row >> v[0] >> v[1] >> v[2] >> v[3])) throw std::runtime_error(name + " has a row that is not four numbers: " + line);
        use(v[0], v[1], v[2], v[3]);
    }
}

} // namespace

std::vector<Disc> readGerris(const std::string& file)
{
    std::vector<Disc> discs;
    readRows(file, [&](double x, double y, double r, double) { if (r > 0.0) discs.push_back({x, y, r}); });
    return discs;
}

std::vector<Disc> readTutorial(const std::string& file)
{
    std::vector<Disc> discs;
    readRows(file, [&](double x, double y, double, double d) { discs.push_back({x, y, 0.5*d}); });
    return discs;
}

std::vector<Disc> pack(int number, double aspect, unsigned seed)
{
    constexpr double smallest = 2e-3, largest = 3e-3, solidFraction = 0.83, pitch = 2.02*largest;
    const double area = pi*(largest*largest + largest*smallest + smallest*smallest)/3.0;
    const double half = std::sqrt(number*area/(2.0*aspect*solidFraction));
    const int perRow = static_cast<int>(2.0*half/pitch);
    scenes::Scene scene(2, 0.2, 0.0);
    scene.materials.setPair(0, 1, {0.0, 0.0});
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(smallest, largest), shift(-0.02, 0.02);
    for (int k = 0; k < number; ++k)
    {
        const double x = -half + 2.0*half*(k % perRow + 0.5)/perRow;
        scene.addGrain(Vec3(x + shift(random)*largest, 0, pitch*(k/perRow + 0.5)), radius(random));
    }
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3(-half, 0, 0), Vec3::UnitX());
    scene.addPlane(Vec3(half, 0, 0), -Vec3::UnitX());
    auto dynamics = scene.build(nscd::ContactSettings());
    // A row falls by less than a fifth of the height of the lattice; then it needs some time to come to rest.
    const int steps = static_cast<int>((std::sqrt(0.4*pitch*number/perRow/scenes::gravity) + 0.4)/deltaT);
    for (int k = 0; k < steps; ++k) scenes::step(dynamics, scene.g, deltaT);
    std::vector<Disc> discs;
    for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
    {
        const Vec3& x = dynamics.grains().position[i];
        discs.push_back({x[0], x[2], dynamics.grains().radius[i]});
    }
    return discs;
}

scenes::Scene collapseScene(const std::vector<Disc>& discs, double friction, double restitution)
{
    scenes::Scene scene(2, friction, restitution);
    for (const Disc& disc : discs) scene.addGrain(Vec3(disc.x, 0, disc.z), disc.radius);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    return scene;
}

Shape shapeOf(const std::vector<Vec3>& position, const std::vector<double>& radius)
{
    Shape shape{0, 0, 0, 0};
    std::vector<double> away;
    for (std::size_t i = 0; i < position.size(); ++i)
    {
        shape.height += position[i][2]/static_cast<double>(position.size());
        away.push_back(std::abs(position[i][0]));
        shape.distance += away.back()/static_cast<double>(position.size());
        shape.top = std::max(shape.top, position[i][2] + radius[i]);
    }
    std::sort(away.begin(), away.end());
    shape.reach = away[static_cast<std::size_t>(0.99*static_cast<double>(away.size() - 1))];
    return shape;
}

double deposit(const std::vector<Vec3>& position, const std::vector<double>& radius)
{
    double mean = 0.0;
    for (double r : radius) mean += r/static_cast<double>(radius.size());
    const double width = 8.0*mean;  // four discs side by side are one layer
    std::map<int, double> area;
    for (std::size_t i = 0; i < position.size(); ++i)
    {
        area[static_cast<int>(std::floor(position[i][0]/width))] += pi*radius[i]*radius[i];
    }
    const double layer = 4.0*pi*mean*mean;
    int first = 0, last = 0;
    while (area[first - 1] >= layer) --first;
    while (area[last + 1] >= layer) ++last;
    return 0.5*width*(last + 1 - first);
}

} // namespace columns
