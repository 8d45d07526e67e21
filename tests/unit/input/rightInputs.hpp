// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Texts that every front end accepts, and all that they set as one text, to be compared.
#pragma once

#include "input/scene/scene.hpp"
#include "unit/input/frontEnds.hpp"

#include <cmath>
#include <iomanip>

namespace frontEnds
{

struct Right
{
    std::string name;
    std::string from;
    std::string to;
    Space space = Space::spheres;
};

inline void PrintTo(const Right& right, std::ostream* os) { *os << right.name; }

inline Right withPlane(const char* name, const std::string& more) { return {name, "planes    { ", "planes    { p { point (0 0 0); normal (0 0 3); " + more + " } "}; }

inline std::vector<Right> rightInputs()
{
    return
    {
        {"asItIs", "NLGS", "NLGS"},
        {"dimensions", "density 2500", "density rho [1 -3 0 0 0 0 0] 2500"},
        {"fiveDimensions", "diameter 0.01", "diameter [0 1 0 0 0] 1e-2"},
        {"dimensionsOfAVector", "jitter 0.5;", "jitter 0.5; velocity [0 1 -1 0 0 0 0] (0 0 -0.1); omega (1 2 3);"},
        {"quotedWords", "type NLGS", "type \"NLGS\""},
        {"quotedName", "{ glass", "{ \"glass\""},
        {"laws", "restitution 0.2;", "rollingFriction 0.05; spinningFriction 0.02; cohesion [1 1 -2 0 0 0 0] 1e-4; cohesionRange 1e-5;"},
        {"films", "restitution 0.2;", "roughness 1e-6; lubricationRange 1e-4; lubricationViscosity [1 -1 -1 0 0 0 0] 1e-3;"},
        {"namedPair", "contacts  { ", "contacts  { steel-glass { friction 0.2; restitution 0.9; } "},
        {"severalSources", "{ type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5; }",
            "{ b { type lattice; box (0.01 0.01 0.1) (0.05 0.05 0.14); spacing 0.02; diameter 0.012; motion fixed; seed 3; }"
            " a { type lattice; box (0.01 0.01 0.15) (0.02 0.02 0.16); count (1 1 1); diameter 0.01; material glass; } }"},
        {"loose", "type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;",
            "type filling; region { type cylinder; axis (0.03 0.03 0) (0.03 0.03 0.2); radius 0.03; } mass [1 0 0 0 0 0 0] 0.05; diameter 0.01; seed 4;"},
        {"packed", "type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5;",
            "type filling; region { type box; box (0 0 0) (0.06 0.06 0.06); } packing { solidFraction 0.5; } diameter 0.01;"},
        {"held", "maxInitialOverlap 0.01;", "maxInitialOverlap 0.5; motion fixed;"},
        {"settings", "type NLGS;", "type queue; tolerance 1e-3; displacementTolerance 2e-3; maxSweeps 7; deadBand 3e-3; overlapTolerance 4e-3; skin 5e-3;"
            " accelerate no; sleep off; vectorPath portable;"},
        {"polygon", "walls     { ", "walls     { p { type polygon; vertices ((0 0 0) (0.06 0 0) (0.06 0.06 0)); material glass; } "},
        {"someSides", "(0.06 0.06 0.2);", "(0.06 0.06 0.2); sides (xMin zMin); torquePoint (1 2 3);"},
        {"acrossAPeriod", "planes    { ", "planes    { p { point (0 0 0); normal (0 0 1); sides both; motion { type rotation; origin (0 0 0); axis (0 0 1); omega 1; } } ", Space::periodicY},
        {"discs", "spread 0.2;", "spread 0.2; velocity (1 2 0); omega (0 0 3);", Space::discs},
        {"wallOfDiscs", "walls     { ", "walls     { p { type polygon; vertices ((0 0 0) (0.06 0 0)); surfaceVelocity (1 0 0); } ", Space::discs},
        withPlane("constant", "motion { type translation; velocity constant (0 0 -1); }"),
        withPlane("constantDictionary", "motion { type rotation; origin (1 0 0); axis (0 0 2); omega { type constant; value 2.5; } }"),
        withPlane("table", "motion { type translation; displacement table ((0 (0 0 0)) (2 (0 0 -1)) (3 (1 0 0))); }"),
        withPlane("countedTable", "motion { type rotation; origin (1 0 0); axis (0 0 2); angle table 2((0 0)(2 1)); }"),
        withPlane("tableDictionary", "motion { type rotation; origin (1 0 0); axis (0 0 2); angle { type table; values ((0 0) (2 1)); } }"),
        withPlane("sine", "surfaceRotation { origin (0 0 1); axis (0 0 2); omega { type sine; frequency 5; amplitude 2; scale 3; level -1; t0 0.01; } }"),
        withPlane("oscillation", "motion { type oscillation; amplitude (0 0 1e-3); frequency [0 0 -1 0 0] 5; phase 0.3; }"),
        {"driven", "driven    { ", "driven    { a { ids (7 0); velocity table ((0 (0 0 0)) (1 (0 0 2))); } b { ids 2(3 4); velocity (0 0 0); omega (0 5 0); } "}
    };
}

/// Values of functions of time may differ by round-off between programs.
inline std::string rounded(const Eigen::MatrixXd& values)
{
    std::ostringstream os;
    for (const double value : values.reshaped()) os << ' ' << std::setprecision(12) << std::round(value*1e12)/1e12 + 0.0;
    return os.str() + '\n';
}

inline void describe(const nscd::GrainLattice& lattice, std::ostream& os)
{
    os << lattice.lower.transpose() << ' ' << lattice.upper.transpose() << ' ' << lattice.count[0] << ' ' << lattice.count[1] << ' ' << lattice.count[2] << ' '
       << lattice.diameter << ' ' << lattice.spread << ' ' << lattice.jitter << ' ' << lattice.seed << '\n';
}

inline void describe(const nscd::FillingSource& filling, std::ostream& os)
{
    os << filling.region.bounds.min().transpose() << ' ' << filling.region.bounds.max().transpose() << ' ' << filling.region.volume << ' '
       << filling.sizes.smallest << ' ' << filling.sizes.largest << ' ' << filling.density << ' ' << static_cast<int>(filling.measure) << ' '
       << filling.amount << ' ' << filling.isPacked << ' ' << filling.seed << '\n';
}

/// Everything of a scene but its places and texts, numbers to the last bit; motions at a few times.
inline std::string everythingOf(const input::Scene& scene)
{
    std::ostringstream os;
    os << std::setprecision(17);
    const input::MaterialTable& materials = scene.materials;
    for (int a = 0; a < materials.table.size(); ++a)
    {
        os << "material " << materials.table.names()[a] << ' ' << materials.density[a] << '\n';
        for (int b = 0; b < materials.table.size(); ++b)
        {
            const nscd::ContactPair& pair = materials.table.pair(a, b);
            os << materials.table.isPairSet(a, b) << ' ' << pair.friction << ' ' << pair.restitution << ' ' << pair.rollingFriction << ' '
               << pair.spinningFriction << ' ' << pair.cohesion << ' ' << pair.cohesionRange << ' '
               << pair.roughness << ' ' << pair.lubricationRange << ' ' << pair.lubricationViscosity << '\n';
        }
    }
    for (const nscd::WallPatch& patch : scene.walls.patches)
    {
        os << "wall " << patch.name << ' ' << patch.material << ' ' << patch.torquePoint.transpose() << '\n';
        for (const double time : {0.0, 0.3, 2.5})
        {
            if (patch.motion) os << rounded(patch.motion(time).matrix());
            if (patch.surfaceMotion) os << rounded(patch.surfaceMotion(time).at(nscd::Vec3(1, 2, 3)));
        }
    }
    for (const nscd::WallRegion& region : scene.walls.regions)
    {
        os << "region " << region.patch << ' ' << region.isTwoSided << ' ' << region.point.transpose() << ' ' << region.normal.transpose() << '\n';
        for (const nscd::WallEdge& edge : region.edges) os << edge.start.transpose() << ' ' << edge.end.transpose() << '\n';
    }
    for (const input::GrainSource& source : scene.sources)
    {
        os << "source " << source.type << ' ' << source.file << ' ' << source.diameter << ' ' << source.material << ' ' << source.isFixed << ' '
           << source.velocity.transpose() << ' ' << source.omega.transpose() << '\n';
        if (source.type == "lattice") describe(source.lattice, os);
        if (source.type == "filling") describe(source.filling, os);
    }
    for (const input::DrivenGroup& group : scene.driven)
    {
        for (const std::int64_t id : group.grains.ids) os << id << ' ';
        os << rounded(group.grains.velocity(0.3)) << rounded(group.grains.omega ? group.grains.omega(0.3) : nscd::Vec3(0, 0, 0));
    }
    const nscd::ContactSettings& s = scene.contact;
    os << s.solver << ' ' << s.tolerance << ' ' << s.displacementTolerance << ' ' << s.maxSweeps << ' ' << s.deadBand << ' ' << s.overlapTolerance << ' '
       << s.skin << ' ' << s.accelerate << ' ' << s.vectorPath << ' ' << scene.maxInitialOverlap << ' ' << scene.wallMaterial << '\n';
    return os.str();
}

} // namespace frontEnds
