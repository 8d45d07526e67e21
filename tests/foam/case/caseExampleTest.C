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
    const std::string text = complaint([&] { readGrainProperties(dict); });
    EXPECT_TRUE(holds(text, {"notAKeyword", "is not a keyword here"})) << path;
    return allowedWords(text);
}

} // namespace

TEST(ExampleFile, isReadWithoutComplaint)
{
    EXPECT_EQ(complaint([] { readGrainProperties(exampleDict()); }), "");
}

TEST(ExampleFile, showsEveryKeyword)
{
    const dictionary example = exampleDict();
    const std::vector<std::string> paths =
    {
        "", "materials/glass", "contacts/default", "contacts/glass-steel", "planes/lid", "forces", "forces/drag",
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
    for (const char* list : {"grains", "patches", "walls"})
    {
        const wordList names = example.subDict(list).toc();
        Words shown, known;
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
    const GrainProperties example = readGrainProperties(exampleDict());
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
    EXPECT_EQ(example.forces.dragLaw, first.forces.dragLaw);
    EXPECT_EQ(example.forces.dragWeight, first.forces.dragWeight);
    for (const auto& [force, given] : example.forces.switches) EXPECT_EQ(given.isOn, first.forces.isOn(force)) << force;
    EXPECT_EQ(example.time.maxGrainDisplacement, first.time.maxGrainDisplacement);
    EXPECT_EQ(example.time.subCycles, first.time.subCycles);
    EXPECT_EQ(example.maxInitialOverlap, first.maxInitialOverlap);
    EXPECT_EQ(example.solvesFluid, first.solvesFluid);
    EXPECT_EQ(example.hasFeedback, first.hasFeedback);
    EXPECT_EQ(example.maxLoadImbalance, first.maxLoadImbalance);
    EXPECT_EQ(example.materials.table.pair(0, 0).restitution, first.materials.table.pair(0, 0).restitution);

    const GrainSource& bed = example.sources.at(0);
    EXPECT_EQ(bed.velocity, first.sources.at(0).velocity);
    EXPECT_EQ(bed.omega, first.sources.at(0).omega);
    EXPECT_EQ(bed.isFixed, first.sources.at(0).isFixed);
    const LatticeSettings& lattice = example.sources.at(2).lattice;
    EXPECT_EQ(lattice.spread, LatticeSettings().spread);
    EXPECT_EQ(lattice.jitter, LatticeSettings().jitter);
    EXPECT_EQ(lattice.seed, LatticeSettings().seed);
}

TEST(ExampleFile, theFirstCaseAtItsHeadIsEnough)
{
    const GrainProperties first = firstCase();
    EXPECT_EQ(first.sources.at(0).type, "positionsFile");
    EXPECT_EQ(first.wallMaterial, 0);
    EXPECT_FALSE(first.holdsMeanFlow);
}
