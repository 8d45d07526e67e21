// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of the first grains of a case: where they are put, and what is refused.
#include "caseTools.H"

#include "coupling/case/start/grainScene.H"
#include "coupling/case/start/initialChecks.H"

#include "OFstream.H"
#include "OSspecific.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;
using nscd::Vec3;

namespace
{

const std::string start = "materials { glass { density 2500; } steel {} }\n"
    "contacts { default { friction 0.3; } }\nwallMaterial steel;\n";

/// A case folder with a mesh, and its grains.
struct Case
{
    explicit Case(const BoxMeshSettings& settings = BoxMeshSettings()) : box(settings) {}

    nscd::Grains grains(const std::string& text, const vector& g = vector(0, 0, -9.81))
    {
        box.writeFile("constant/grainProperties", text);
        const GrainProperties properties = readGrainProperties(box.time(), surroundingsIn(box.mesh()));
        const GrainScene scene = makeGrainScene(properties, box.mesh(), g);
        return makeFirstGrains(properties, scene, box.mesh());
    }

    std::string complaintAbout(const std::string& text, const vector& g = vector(0, 0, -9.81))
    {
        return complaint([&] { grains(text, g); });
    }

    /// Grains of a table file with these contents.
    std::string complaintAboutTable(const std::string& rows, const std::string& more = "")
    {
        writeRaw("grains.txt", rows);
        return complaintAbout(start + more + "grains { bed { type table; file \"grains.txt\"; } }");
    }

    std::string complaintAboutPositions(const std::string& list)
    {
        writeRaw("positions", list);
        return complaintAbout(start + "grains { bed { type positionsFile; file positions; diameter 0.01; } }");
    }

    void writeRaw(const fileName& name, const std::string& contents)
    {
        mkDir(box.casePath()/"constant");
        std::ofstream(box.casePath()/"constant"/name) << contents;
    }

    BoxMesh box;
};

BoxMeshSettings flatBox()
{
    BoxMeshSettings settings;
    settings.cells = labelVector(4, 4, 1);
    settings.max = point(1, 1, 0.1);
    settings.patchTypes = {"wall", "wall", "wall", "wall", "empty", "empty"};
    return settings;
}

} // namespace

TEST(FirstGrains, comeFromAllSourcesInTheirOrder)
{
    Case c;
    c.writeRaw("table.txt", "# x y z d material\n0.1, 0.2, 0.3, 0.02\n0.4 0.5 0.6 0.04 lead # heavy\n\n");
    c.box.writeFile("constant/positions", "3\n(\n(0.7 0.1 0.2)\n(0.8 0.1 0.2) // a comment\n(0.9 0.1 0.2)\n)\n");
    const nscd::Grains grains = c.grains
    (
        "materials { glass { density 2500; } lead { density 11000; } } contacts { default { friction 0.3; } }"
        "wallMaterial glass;"
        "grains { a { type table; file \"table.txt\"; material glass; velocity (1 0 0); }"
        "         b { type positionsFile; file positions; diameter 0.05; material glass; motion fixed; } }"
    );
    ASSERT_EQ(grains.size(), 5u);
    EXPECT_EQ(grains.position[0], Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(grains.radius[1], 0.02);
    EXPECT_EQ(grains.material[1], 1);
    EXPECT_NEAR(grains.mass[1], 11000*4.0/3*constant::mathematical::pi*8e-6, 1e-12);
    EXPECT_EQ(grains.velocity[1], Vec3(1, 0, 0));
    EXPECT_EQ(grains.position[4], Vec3(0.9, 0.1, 0.2));
    EXPECT_EQ(grains.isFixed[1], 0);
    EXPECT_EQ(grains.isFixed[4], 1);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(grains.id[i], std::int64_t(i));
}

TEST(FirstGrains, binaryPositionsAreRead)
{
    Case c;
    const List<vector> positions({vector(0.1, 0.2, 0.3), vector(0.4, 0.5, 1.0/3)});
    {
        OFstream os(c.box.casePath()/"positions", IOstream::BINARY);
        os << "FoamFile { version 2.0; format binary; class vectorField; object positions; }" << nl << positions;
    }
    const nscd::Grains grains = c.grains
    (
        start + "grains { type positionsFile; file \"" + c.box.casePath() + "/positions\"; diameter 0.01; }"
    );
    ASSERT_EQ(grains.size(), 2u);
    EXPECT_EQ(grains.position[1].z(), 1.0/3);
}

TEST(FirstGrains, aLatticeFillsItsBoxAndJitterMakesNoOverlap)
{
    Case c;
    const std::string lattice = "grains { type lattice; box (0 0 0) (1 1 0.5); spacing 0.1; diameter 0.08; ";
    const nscd::Grains regular = c.grains(start + lattice + "}");
    ASSERT_EQ(regular.size(), 500u);
    EXPECT_NEAR((regular.position[0] - Vec3(0.05, 0.05, 0.05)).norm(), 0, 1e-14);
    EXPECT_NEAR((regular.position[499] - Vec3(0.95, 0.95, 0.45)).norm(), 0, 1e-14);

    const nscd::Grains shaken = c.grains("maxInitialOverlap 0;" + start + lattice + "jitter 1; spread 0.2; seed 3; }");
    const nscd::Grains same = c.grains(start + lattice + "jitter 1; spread 0.2; seed 3; }");
    const nscd::Grains other = c.grains(start + lattice + "jitter 1; spread 0.2; seed 4; }");
    EXPECT_EQ(shaken.position[77], same.position[77]);
    EXPECT_NE(shaken.position[77], other.position[77]);
    EXPECT_NE(shaken.radius[77], shaken.radius[78]);
}

TEST(FirstGrains, discsLieInTheMidPlane)
{
    Case c(flatBox());
    const nscd::Grains grains = c.grains
    (
        start + "grains { type lattice; box (0 0 0) (1 1 1); count (3 2 5); diameter 0.1; }", vector(0, -9.81, 0)
    );
    ASSERT_EQ(grains.size(), 6u);
    EXPECT_NEAR(grains.position[3].z(), 0.05, 1e-15);
    EXPECT_NEAR(grains.mass[0], 2500*constant::mathematical::pi*0.0025*0.1, 1e-10);
}

TEST(FirstGrains, spheresMayLieInTheMidPlane)
{
    Case c(flatBox());
    const std::string spheres = "shape sphere;" + start + "grains { type lattice; box (0 0 0) (1 1 1); count (3 2 1); velocity (0.1 0 0); diameter ";
    const nscd::Grains grains = c.grains(spheres + "0.1; }", vector(0, -9.81, 0));
    ASSERT_EQ(grains.size(), 6u);
    EXPECT_EQ(grains.shape.emptyAxis, 2);
    EXPECT_NEAR(grains.position[3].z(), 0.05, 1e-15);
    EXPECT_NEAR(grains.mass[0], 2500*constant::mathematical::pi/6*1e-3, 1e-10);
    EXPECT_TRUE(holds(c.complaintAbout(spheres + "0.11; }", vector(0, -9.81, 0)), {"shape", "spheres up to 0.11 m", "0.1 m thick", "disc"}));
    EXPECT_TRUE(holds(c.complaintAbout(spheres + "0.1; omega (1 0 0); }", vector(0, -9.81, 0)), {"grains.omega", "out of the plane"}));
}

TEST(FirstGrains, thereMayBeNone)
{
    BoxMeshSettings settings;
    settings.patchTypes = {"wall", "wall", "patch", "patch", "wall", "wall"};
    Case c(settings);
    EXPECT_EQ(c.grains(start + "grains {}").size(), 0u);
}

/// Further wrong files are in sharedInputTest.C.
TEST(BadStart, filesThatAreMissingOrEmpty)
{
    Case c;
    c.writeRaw("bed.txt", "");
    EXPECT_TRUE(holds(c.complaintAbout(start + "grains { bed { type table; file \"bad.txt\"; } }"),
        {"grains.bed.file", "does not exist", "nearest: bed.txt", "constant/grainProperties"}));
    EXPECT_TRUE(holds(c.complaintAboutTable("# x y z d\n"), {"grains.bed.file", "holds no grain", "grains.txt", "constant/grainProperties"}));
    EXPECT_TRUE(holds(c.complaintAboutPositions("()"), {"grains.bed.file", "holds no grain"}));
    EXPECT_TRUE(holds(c.complaintAboutPositions("FoamFile { format ascii; }\n((0.1 0.1 0.1))\n((0.2 0.2 0.2))"), {"positions", "goes on after its list", "line 3"}));
}

TEST(FirstGrains, compressedPositionsAreRead)
{
    Case c;
    mkDir(c.box.casePath()/"constant");
    OFstream(c.box.casePath()/"constant/positions", IOstream::ASCII, IOstream::currentVersion, IOstream::COMPRESSED)() << "((0.1 0.2 0.3) (0.4 0.5 0.6))";
    ASSERT_TRUE(isFile(c.box.casePath()/"constant/positions.gz", false));
    EXPECT_EQ(c.grains(start + "grains { type positionsFile; file positions; diameter 0.01; }").size(), 2u);
}

TEST(BadStart, binaryFilesThatAreTruncatedOrHoldNoNumbers)
{
    Case c;
    const fileName path = c.box.casePath()/"constant/positions";
    const auto about = [&](const List<vector>& positions, std::size_t cut)
    {
        mkDir(path.path());
        {
            OFstream os(path, IOstream::BINARY);
            os << "FoamFile { version 2.0; format binary; class vectorField; object positions; }" << nl << positions;
        }
        std::ifstream whole(path);
        const std::string contents((std::istreambuf_iterator<char>(whole)), std::istreambuf_iterator<char>());
        std::ofstream(path) << contents.substr(0, contents.size() - cut);
        return c.complaintAbout(start + "grains { type positionsFile; file positions; diameter 0.01; }");
    };
    const List<vector> positions(100, vector(0.5, 0.5, 0.5));
    EXPECT_TRUE(holds(about(positions, 300), {"constant/positions"}));
    EXPECT_TRUE(holds(about(List<vector>(1, vector(0.5, std::nan(""), 0.5)), 0), {"constant/positions", "finite number"}));
}

TEST(BadStart, grainsOutsideTheMesh)
{
    Case c;
    EXPECT_TRUE(holds(c.complaintAboutTable("0.5 0.5 0.5 0.01\n0.5 0.5 1.5 0.01"), {"outside the mesh", "grain 1", "(0.5 0.5 1.5)", "(1 1 1)"}));
}

TEST(BadStart, overlapsAreNamedWithTheirIds)
{
    Case c;
    const std::string rows = "0.5 0.5 0.5 0.02\n0.8 0.5 0.5 0.02\n0.515 0.5 0.5 0.02\n";
    EXPECT_TRUE(holds(c.complaintAboutTable(rows), {"maxInitialOverlap", "grains 0 and 2 overlap by 0.25", "0.01"}));
    EXPECT_EQ(c.complaintAboutTable(rows, "maxInitialOverlap 0.26;"), "");
    EXPECT_TRUE(holds(c.complaintAboutTable("0.5 0.5 0.5 0.02\n0.5 0.5 0.5 0.03\n", "maxInitialOverlap 9;"), {"grains 0 and 1 have the same center"}));
    EXPECT_TRUE(holds(c.complaintAboutTable("0.5 0.5 0.005 0.02\n"), {"grain 0 and the wall front overlap by 0.25"}));
}

TEST(BadStart, overlapsAcrossACyclicBorderCount)
{
    BoxMeshSettings settings;
    settings.patchTypes = {"cyclic", "cyclic", "wall", "wall", "wall", "wall"};
    Case c(settings);
    EXPECT_TRUE(holds(c.complaintAboutTable("0.005 0.5 0.5 0.02\n0.995 0.5 0.5 0.02\n"), {"grains 0 and 1 overlap by 0.5"}));
    EXPECT_EQ(c.complaintAboutTable("0.012 0.5 0.5 0.02\n0.99 0.5 0.5 0.02\n"), "");
    EXPECT_TRUE(holds(c.complaintAboutTable("0.5 0.5 0.5 1.2\n"), {"period shorter than a grain", "1.2"}));
}

TEST(BadStart, aPlaneHasNothingBehindIt)
{
    Case c;
    const std::string plane = "planes { floor { point (0 0 0.3); normal (0 0 1); } }\n";
    EXPECT_TRUE(holds(c.complaintAboutTable("0.5 0.5 0.2 0.02\n", plane), {"grain 0 and the wall floor"}));
    EXPECT_EQ(c.complaintAboutTable("0.5 0.5 0.4 0.02\n", plane), "");
}

TEST(BadStart, fixedGrainsMayOverlapEachOtherAndWalls)
{
    Case c;
    EXPECT_EQ(c.complaintAboutTable("0.5 0.5 0 0.02\n0.51 0.5 0 0.02\n", "motion fixed;"), "");
}

TEST(BadStart, pairsThatCanMeetMustBeKnown)
{
    Case c;
    const std::string grains = "grains { type lattice; box (0 0 0) (1 1 1); count (1 1 1); diameter 0.01; }";
    const std::string materials = "materials { glass { density 2500; } steel {} foam {} } wallMaterial steel;";
    EXPECT_TRUE(holds(c.complaintAbout(materials + "contacts { glass-glass { friction 1; } }" + grains), {"contacts", "glass-steel", "default"}));
    EXPECT_EQ(c.complaintAbout(materials + "contacts { glass-glass { friction 1; } steel-glass { friction 1; } }" + grains), "");
}

TEST(BadStart, motionOutOfThePlaneOfA2DCase)
{
    Case c(flatBox());
    const std::string lattice = "grains { bed { type lattice; box (0 0 0) (1 1 1); count (1 1 1); diameter 0.1; ";
    EXPECT_TRUE(holds(c.complaintAbout(start + lattice + "} }", vector(0, -9.81, 1)), {"constant/g", "empty direction", "(0 -9.81 1)"}));
    EXPECT_TRUE(holds(c.complaintAbout(start + lattice + "velocity (0 0 1); } }", vector(0, -9.81, 0)), {"grains.bed.velocity", "leaves the plane"}));
    EXPECT_TRUE(holds(c.complaintAbout(start + lattice + "omega (1 0 0); } }", vector(0, -9.81, 0)), {"grains.bed.omega", "out of the plane"}));
    EXPECT_EQ(c.complaintAbout(start + lattice + "omega (0 0 1); } }", vector(0, -9.81, 0)), "");
    EXPECT_EQ(c.complaintAbout("shape sphere;" + start + lattice + "} }", vector(0, -9.81, 0)), "");
}

TEST(BadStart, aMeanFlowNeedsCyclicPatches)
{
    BoxMeshSettings settings;
    settings.patchTypes = {"cyclic", "cyclic", "wall", "wall", "wall", "wall"};
    Case c(settings);
    const std::string grains = start + "grains {}\n";
    EXPECT_EQ(c.complaintAbout(grains + "meanFlow (0.1 0 0);"), "");
    EXPECT_TRUE(holds(c.complaintAbout(grains + "meanFlow (0.1 0 0.2);"),
        {"meanFlow", "(0.1 0 0.2)", "cyclic", "component z", "constant/grainProperties line 6"}));
}

TEST(BadStart, timeStepMustBePositive)
{
    BoxMeshSettings settings;
    settings.deltaT = 0;
    EXPECT_TRUE(holds(complaint([&] { BoxMesh box(settings); checkTimeControls(box.time()); }), {"deltaT", "out of range", "value:   0", "> 0"}));
    settings.deltaT = -1e-3;
    EXPECT_TRUE(holds(complaint([&] { BoxMesh box(settings); checkTimeControls(box.time()); }), {"deltaT", "value:   -0.001"}));
}

TEST(BadStart, gravityHasDimensions)
{
    BoxMesh box;
    box.writeFile("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);");
    EXPECT_EQ(readGravity(box.time()), vector(0, 0, -9.81));
    box.writeFile("constant/g", "dimensions [0 1 -1 0 0 0 0]; value (0 0 -9.81);");
    EXPECT_TRUE(holds(complaint([&] { readGravity(box.time()); }), {"wrong dimensions", "[0 1 -2 0 0 0 0]"}));
}
