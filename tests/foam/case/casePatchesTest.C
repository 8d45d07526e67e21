// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of what patches are to the grains, by their type and by name, and of patches that are refused.
#include "caseTools.H"

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;
using nscd::Vec3;

TEST(MeshWalls, wallsPeriodsAndShapeComeFromThePatchTypes)
{
    BoxMeshSettings settings;
    settings.max = point(2, 1, 0.1);
    settings.cells = labelVector(8, 4, 1);
    settings.patchTypes = {"cyclic", "cyclic", "wall", "symmetryPlane", "empty", "empty"};
    BoxMesh box(settings);
    const nscd::Walls walls = wallsOf(box);
    ASSERT_EQ(walls.patches.size(), 2u);
    EXPECT_EQ(walls.patches[0].name, "bottom");
    EXPECT_EQ(walls.patches[1].name, "top");
    const nscd::PeriodicBox period = periodicBox(box.mesh());
    EXPECT_TRUE(period.isPeriodic(0) && !period.isPeriodic(1) && !period.isPeriodic(2));
    EXPECT_NEAR(period.length[0], 2, 1e-14);
    const nscd::GrainShape shape = grainShape(box.mesh());
    EXPECT_EQ(shape.dimensions, 2);
    EXPECT_NEAR(shape.thickness, 0.1, 1e-15);
    EXPECT_EQ(emptyAxis(box.mesh()), 2);
}

TEST(MeshWalls, rulesNamePatchesAndPlanesAreAdded)
{
    BoxMeshSettings settings;
    settings.patchTypes = {"wall", "wall", "patch", "patch", "wall", "wall"};
    BoxMesh box(settings);
    const nscd::Walls walls = wallsOf
    (
        box,
        "patches { \"(top|left)\" { type exit; } left { type wall; } bottom { type wall; } }"
        "planes { ramp { point (0 0 0.5); normal (0 0 3); } }"
    );
    Words names;
    for (const nscd::WallPatch& patch : walls.patches) names.push_back(patch.name);
    EXPECT_EQ(names, Words({"left", "right", "bottom", "front", "back", "ramp"}));
    EXPECT_TRUE(walls.regions.back().edges.empty());
    EXPECT_EQ(walls.regions.back().normal, Vec3(0, 0, 1));
}

TEST(BadPatches, saysWhichPatchAndWhatWouldBeRight)
{
    BoxMeshSettings settings;
    settings.patchTypes = {"wall", "wall", "patch", "patch", "cyclic", "cyclic"};
    BoxMesh box(settings);
    const auto about = [&](const std::string& more) { return complaint([&] { wallsOf(box, more); }); };
    const std::string rest = "bottom { type wall; } top { type exit; }";
    EXPECT_TRUE(holds(about(""), {"patches", "bottom", "type wall", "type exit"}));
    EXPECT_TRUE(holds(about("patches { bottom { type wall; } }"), {"patches", "top"}));
    EXPECT_TRUE(holds(about("patches { " + rest + " botom { type wall; } }"), {"patches.botom", "nearest: bottom", "left, right"}));
    EXPECT_TRUE(holds(about("patches { " + rest + " front { type wall; } }"), {"patches.front", "cyclic"}));
    EXPECT_EQ(about("patches { " + rest + " }"), "");
    const std::string twoMaterials = complaint([&]
    {
        const GrainProperties properties = readGrainProperties(dictionaryOf
        (
            "materials { glass { density 1; } steel {} } contacts {} grains { type table; file x; }"
            "patches { bottom { type wall; material steel; } top { type exit; } }"
        ));
        assignPatchRoles(properties, box.mesh());
    });
    EXPECT_TRUE(holds(twoMaterials, {"no material", "left", "wallMaterial", "glass, steel"}));
}

TEST(BadPatches, wedgesAreRefused)
{
    BoxMeshSettings settings;
    settings.cells = labelVector(4, 4, 1);
    settings.min = point(0, 0.1, -0.5);
    settings.max = point(1, 1, 0.5);
    settings.patchTypes = {"wall", "wall", "wall", "wall", "wedge", "wedge"};
    settings.movePoint = [](const point& x) { return point(x.x(), x.y(), 0.1*x.z()*x.y()); };
    BoxMesh box(settings);
    const std::string text = complaint([&] { wallsOf(box); });
    EXPECT_TRUE(holds(text, {"front", "type that grains do not know", "value:   wedge", "symmetryPlane"}));
}

/// What is said of a box whose front and back are coupled patches of this type, with these entries.
std::string aboutCoupled(const word& type, const std::string& entries)
{
    BoxMesh box;
    fvMesh& mesh = box.mesh();
    PtrList<polyPatch> patches(6);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const label side = patch.index();
        dictionary dict = side < 4 ? dictionary() : dictionaryOf(entries);
        dict.add("type", side < 4 ? patch.type() : type);
        dict.add("nFaces", patch.size());
        dict.add("startFace", patch.start());
        if (side >= 4) dict.add("neighbourPatch", mesh.boundaryMesh()[side ^ 1].name());
        patches.set(side, polyPatch::New(patch.name(), dict, side, mesh.boundaryMesh()));
    }
    mesh.removeFvBoundary();
    mesh.addFvPatches(patches);
    return complaint([&] { wallsOf(box); });
}

/// Grains pass an interface between halves that touch, and no other: they would leave the mesh by it.
TEST(BadPatches, interfacesThatMoveWhatGoesThroughAreRefused)
{
    EXPECT_EQ(aboutCoupled("cyclicAMI", "transform noOrdering;"), "");
    EXPECT_EQ(aboutCoupled("cyclicAMI", ""), "");
    const std::string turned = aboutCoupled("cyclicAMI", "transform rotational; rotationAxis (0 0 1); rotationCentre (0 0 0); rotationAngle 90;");
    EXPECT_TRUE(holds(turned, {"boundary", "front", "apart from its partner", "value:   rotational", "noOrdering", "cyclic"}));
    EXPECT_TRUE(holds(aboutCoupled("cyclicAMI", "transform translational; separationVector (0 0 1);"), {"front", "value:   translational"}));
    EXPECT_TRUE(holds(aboutCoupled("cyclicSlip", ""), {"front", "type that grains do not know", "value:   cyclicSlip"}));
    EXPECT_TRUE(holds(aboutCoupled("cyclicPeriodicAMI", "periodicPatch left;"), {"front", "type that grains do not know", "value:   cyclicPeriodicAMI"}));
}

TEST(BadPatches, discsOnA3DMeshAreRefused)
{
    BoxMesh box;
    GrainProperties properties;
    properties.shape = "disc";
    EXPECT_TRUE(holds(complaint([&] { checkShape(properties, box.mesh()); }), {"2D", "value:   disc", "allowed: sphere"}));
}
