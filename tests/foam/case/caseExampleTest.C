// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests that etc/grainProperties.example is true: it is read without complaint, it shows every keyword that is read, and
// the defaults it states are the defaults.
#include "caseTools.H"

#include "coupling/case/input/grainProperties.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

dictionary exampleDict()
{
    const fileName path = fileName(Foam::getEnv("NSCDDEMFOAM_DIR"))/"etc/grainProperties.example";
    IFstream is(path);
    EXPECT_TRUE(is.good()) << path << ": source etc/bashrc";
    dictionary dict("grainProperties.example", dictionary::null, is);
    dict.remove("FoamFile");
    return dict;
}

/// A surface in place of those that the example names.
struct Surface
{
    const fileName path = cwd()/"caseExampleTest.stl";

    Surface() { std::ofstream(path) << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"; }
    ~Surface() { rm(path); }
};

GrainProperties read(const dictionary& dict)
{
    const Surface surface;
    input::Surroundings around = foamSurroundings();
    around.pathOfSurface = [&](const std::string&) { return surface.path; };
    return readGrainProperties(dict, around);
}

GrainProperties firstCase()
{
    return readGrainProperties(dictionaryOf
    (
        "materials { glass { density 2500; } }\n"
        "contacts  { default { friction 0.3; } }\n"
        "grains    { type positionsFile; file kinematicCloudPositions; diameter 2e-3; }\n"
        "patches   { inlet { type wall; } outlet { type exit; } }\n"
    ));
}

/// The words that a complaint lists as keywords allowed where it was raised.
Words allowedWords(const std::string& complaint)
{
    std::smatch line;
    Words words;
    if (!std::regex_search(complaint, line, std::regex("allowed: (.*)"))) return words;
    std::istringstream list(line[1]);
    for (std::string word; std::getline(list >> std::ws, word, ',');) words.push_back(word);
    return words;
}

/// Every keyword of the dictionary at a path such as grains/bed: what the reader says when it meets one that it does not know.
Words keywordsAt(const std::string& path)
{
    dictionary dict = exampleDict();
    dictionary* at = &dict;
    std::istringstream steps(path);
    for (std::string step; std::getline(steps, step, '/');) at = &at->subDict(step);
    at->add("notAKeyword", 1);
    const std::string text = complaint([&] { read(dict); });
    EXPECT_TRUE(holds(text, {"notAKeyword", "is not a keyword here"})) << path;
    return allowedWords(text);
}

} // namespace

TEST(ExampleFile, isReadWithoutComplaint)
{
    EXPECT_EQ(complaint([] { read(exampleDict()); }), "");
}

TEST(ExampleFile, showsEveryKeyword)
{
    const dictionary example = exampleDict();
    const std::vector<std::string> paths =
    {
        "", "materials/glass", "contacts/default", "contacts/glass-steel", "forces", "forces/drag", "forces/field",
        "voidFraction", "timeStep", "solver", "parallel", "walls/shaker/motion"
    };
    for (const std::string& path : paths)
    {
        const Words keywords = keywordsAt(path);
        EXPECT_FALSE(keywords.empty()) << path;
        const dictionary* at = &example;
        std::istringstream steps(path);
        for (std::string step; std::getline(steps, step, '/');) at = &at->subDict(step);
        for (const std::string& keyword : keywords) EXPECT_TRUE(at->found(keyword)) << path << ": " << keyword;
    }
}

TEST(ExampleFile, showsEveryKeywordOfSourcesAndPatchesInOneOfThem)
{
    const dictionary example = exampleDict();
    for (const char* list : {"grains", "patches", "walls", "planes"})
    {
        const wordList names = example.subDict(list).toc();
        // `planes` are walls of type plane.
        const bool isPlanes = list == std::string("planes");
        Words shown = isPlanes ? Words{"sides", "motion", "torquePoint", "surfaceVelocity", "surfaceRotation"} : Words(), known;
        // One of the four amounts of a filling stands there, packing; comments show the others, and clumps, which know no laws beside Coulomb's.
        if (list == std::string("grains")) shown = {"number", "mass", "solidFraction", "clump"};
        for (const word& name : names)
        {
            for (const word& keyword : example.subDict(list).subDict(name).toc()) shown.push_back(keyword);
            for (const std::string& keyword : keywordsAt(std::string(list) + "/" + name)) known.push_back(keyword);
        }
        EXPECT_GE(known.size(), names.size());
        for (const std::string& keyword : known)
        {
            EXPECT_TRUE(std::find(shown.begin(), shown.end(), keyword) != shown.end()) << list << ": " << keyword;
        }
    }
}

TEST(ExampleFile, statesTheDefaults)
{
    const GrainProperties example = read(exampleDict());
    const GrainProperties first = firstCase();
    EXPECT_EQ(example.contact.solver, first.contact.solver);
    EXPECT_EQ(example.contact.tolerance, first.contact.tolerance);
    EXPECT_EQ(example.contact.displacementTolerance, first.contact.displacementTolerance);
    EXPECT_EQ(example.contact.maxSweeps, first.contact.maxSweeps);
    EXPECT_EQ(example.contact.deadBand, first.contact.deadBand);
    EXPECT_EQ(example.contact.overlapTolerance, first.contact.overlapTolerance);
    EXPECT_EQ(example.contact.skin, first.contact.skin);
    EXPECT_EQ(example.contact.accelerate, first.contact.accelerate);
    EXPECT_EQ(example.contact.vectorPath, first.contact.vectorPath);
    EXPECT_EQ(example.voidFraction.method, first.voidFraction.method);
    EXPECT_EQ(example.voidFraction.diffusion, first.voidFraction.diffusion);
    EXPECT_EQ(example.voidFraction.minFluidFraction, first.voidFraction.minFluidFraction);
    EXPECT_EQ(example.forces.drag.law, first.forces.drag.law);
    EXPECT_EQ(example.forces.drag.weight, first.forces.drag.weight);
    EXPECT_EQ(example.forces.drag.isPolydisperse, first.forces.drag.isPolydisperse);
    for (const auto& [force, given] : example.forces.switches)
    {
        if (force == "field") continue;
        EXPECT_EQ(given.isOn, first.forces.isOn(force)) << force;
    }
    EXPECT_TRUE(example.forces.field.acceleration(1).isZero(0) && example.forces.field.forceDensity(1).isZero(0));
    EXPECT_EQ(example.time.maxGrainDisplacement, first.time.maxGrainDisplacement);
    EXPECT_EQ(example.time.maxGrainImpacts, first.time.maxGrainImpacts);
    EXPECT_EQ(example.time.subCycles, first.time.subCycles);
    EXPECT_EQ(example.maxInitialOverlap, first.maxInitialOverlap);
    EXPECT_EQ(example.solvesFluid, first.solvesFluid);
    EXPECT_EQ(example.hasFeedback, first.hasFeedback);
    EXPECT_EQ(example.maxLoadImbalance, first.maxLoadImbalance);
    EXPECT_EQ(example.materials.table.pair(0, 0).restitution, first.materials.table.pair(0, 0).restitution);

    const input::GrainSource& bed = example.sources.at(0);
    EXPECT_EQ(bed.velocity, first.sources.at(0).velocity);
    EXPECT_EQ(bed.omega, first.sources.at(0).omega);
    EXPECT_EQ(bed.isFixed, first.sources.at(0).isFixed);
    EXPECT_EQ(bed.coarseGraining, first.sources.at(0).coarseGraining);
    const nscd::GrainLattice& lattice = example.sources.at(2).lattice;
    EXPECT_EQ(lattice.spread, nscd::GrainLattice().spread);
    EXPECT_EQ(lattice.jitter, nscd::GrainLattice().jitter);
    EXPECT_EQ(lattice.seed, nscd::GrainLattice().seed);
}

TEST(ExampleFile, theFirstCaseAtItsHeadIsEnough)
{
    const GrainProperties first = firstCase();
    EXPECT_EQ(first.sources.at(0).type, "positionsFile");
    EXPECT_EQ(first.wallMaterial, 0);
    EXPECT_FALSE(first.holdsMeanFlow);
}
