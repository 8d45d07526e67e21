// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains from all kinds of sources, in one go and a few at a time, with random numbers from elsewhere, and clumps.
#include "input/scene/sceneReader.hpp"
#include "input/start/placement.hpp"
#include "unit/input/folders.hpp"

#include <cmath>
#include <cstdint>

using input::Vec3;

namespace
{

const char* const materials = "materials { glass { density 2500; } lead { density 11000; } } contacts { default { friction 0.3; } }\n";

class Placements : public folders::InFolder
{
protected:
    input::Surroundings around() const
    {
        input::Surroundings around;
        around.pathOfGrains = [this](const std::string& path) { return folder/path; };
        return around;
    }

    input::Scene read(const std::string& grains, const input::Surroundings& around) const
    {
        const input::Dictionary dict = input::parseDictionary(materials + grains, "scene");
        input::Scene scene;
        input::readScene(input::CheckedEntries(dict), around, scene);
        return scene;
    }

    /// The batches in which grains come.
    std::vector<nscd::Grains> batches(const std::string& grains, const input::PlacementTools& tools, const input::Surroundings& around) const
    {
        std::vector<nscd::Grains> all;
        input::placeGrains(read(grains, around), around, tools, [&](nscd::Grains& batch) { all.push_back(batch); });
        return all;
    }

    nscd::Grains inOneGo(const std::string& grains) const { return batches(grains, {}, around()).at(0); }
};

const char* const threeSources =
    "grains { a { type lattice; box (0 0 0) (1 1 1); count (2 3 2); diameter 0.1; spread 0.3; jitter 1; material lead; omega (1 2 3); motion fixed; }\n"
    " b { type table; file table.txt; material glass; velocity (1 0 0); }\n"
    " c { type positionsFile; file list.txt; diameter 0.05; material glass; } }";

} // namespace

TEST_F(Placements, takeSourcesInTheirOrder)
{
    write("table.txt", "0.1 0.2 0.3 0.02\n0.4 0.5 0.6 0.04 lead # heavy\n");
    write("list.txt", "((0.7 0.1 0.2))");
    const nscd::Grains grains = inOneGo(threeSources);
    ASSERT_EQ(grains.size(), 15u);
    for (std::size_t i = 0; i < grains.size(); ++i) EXPECT_EQ(grains.id[i], static_cast<std::int64_t>(i));
    EXPECT_EQ(grains.omega[11], Vec3(1, 2, 3));
    EXPECT_EQ(grains.isFixed[11], 1);
    EXPECT_EQ(grains.material[11], 1);
    EXPECT_EQ(grains.position[12], Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(grains.velocity[12], Vec3(1, 0, 0));
    EXPECT_EQ(grains.material[12], 0);
    EXPECT_EQ(grains.radius[13], 0.02);
    EXPECT_EQ(grains.material[13], 1);
    EXPECT_EQ(grains.radius[14], 0.025);
    EXPECT_EQ(grains.isFixed[14], 0);
}

TEST_F(Placements, areTheSameInBatches)
{
    write("table.txt", "0.1 0.2 0.3 0.02\n0.4 0.5 0.6 0.04 lead\n");
    write("list.txt", "((0.7 0.1 0.2))");
    const nscd::Grains whole = inOneGo(threeSources);
    input::PlacementTools tools;
    tools.grainsInBatch = 4;
    const std::vector<nscd::Grains> parts = batches(threeSources, tools, around());
    ASSERT_EQ(parts.size(), 4u);
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
        const nscd::Grains& part = parts[i/4];
        EXPECT_EQ(part.id[i % 4], whole.id[i]);
        EXPECT_EQ(part.position[i % 4], whole.position[i]);
        EXPECT_EQ(part.mass[i % 4], whole.mass[i]);
    }
    EXPECT_EQ(parts[3].size(), 3u);
}

/// Four numbers a grain: a shift along each axis, and its diameter.
TEST_F(Placements, takeRandomNumbersFromWhoeverHasThem)
{
    input::PlacementTools tools;
    std::uint64_t seedGiven = 0;
    tools.randomNumbers = [&](std::uint64_t seed)
    {
        seedGiven = seed;
        return [n = 0]() mutable { return 0.25*(n++ % 4); };
    };
    const nscd::Grains grains = batches("grains { type lattice; box (0 0 0) (2 1 1); count (2 1 1); diameter 0.5; spread 0.2; jitter 0.5; seed 77; material glass; }",
        tools, around()).at(0);
    EXPECT_EQ(seedGiven, 77u);
    // Free gap 1 - 0.5 1.2 = 0.4; shifts 0.2 (0, 0.25, 0.5) - 0.1.
    EXPECT_NEAR((grains.position[1] - Vec3(1.4, 0.45, 0.5)).norm(), 0, 1e-15);
    EXPECT_NEAR(grains.radius[1], 0.25*(1 + 0.2*0.5), 1e-16);
}

TEST_F(Placements, putDiscsIntoTheirPlaneAndGrainsIntoTheBox)
{
    input::Surroundings space = around();
    space.shape.dimensions = 2;
    space.shape.emptyAxis = 1;
    space.box.length[0] = 2.0;
    space.midPlane = 0.125;
    const nscd::Grains discs = batches("grains { type lattice; box (3 7 0) (5 7 1); count (2 9 1); diameter 0.5; material glass; }", {}, space).at(0);
    ASSERT_EQ(discs.size(), 2u);
    EXPECT_EQ(discs.position[0], Vec3(1.5, 0.125, 0.5));
    EXPECT_EQ(discs.position[1], Vec3(0.5, 0.125, 0.5));
}

TEST_F(Placements, putClumpsInThePlacesOfGrains)
{
    const std::string clumps = "grains { a { type lattice; box (0 0 0) (2 1 1); count (2 1 1); diameter 0.5; material glass; clump { members ((0 0 0) (0.1 0 0)); diameter 0.2; } }\n"
        " b { type lattice; box (0 2 0) (1 3 1); count (1 1 1); diameter 0.5; material lead; } }";
    const nscd::Grains grains = inOneGo(clumps);
    ASSERT_EQ(grains.clumps.size(), 2u);
    ASSERT_EQ(grains.size(), 5u);
    EXPECT_LT((grains.clumps.position[1] - Vec3(1.5, 0.5, 0.5)).norm(), 1e-15);
    for (std::size_t i = 0; i < grains.size(); ++i) EXPECT_EQ(grains.id[i], static_cast<std::int64_t>(i));
    EXPECT_EQ(grains.material[4], 1);
}

/// What another run wrote, of a program that can read it: as it was, numbered anew, a few at a time.
TEST_F(Placements, takeGrainsOfAWrittenTime)
{
    input::Surroundings reads = around();
    reads.grainsOfTime = [](const input::GrainSource& source, const input::MaterialTable& materials)
    {
        EXPECT_EQ(source.file + " " + source.time, "old 0.5");
        nscd::Grains grains;
        for (int k = 0; k < 5; ++k)
        {
            grains.add({0.1*k, 0, 0}, 0.01*(k + 1), materials.density[k % 2], k % 2, 70 + k);
            grains.velocity.back() = {1.0*k, 2, 3};
            grains.omega.back() = {0, 0, 1.0*k};
            grains.orientation.back() = nscd::Quaternion(0, 1, 0, 0);
            grains.isFixed.back() = k == 3;
        }
        return input::WrittenGrains{grains};
    };
    const std::string source = "grains { type time; case old; time 0.5; }";
    input::PlacementTools tools;
    tools.grainsInBatch = 2;
    const std::vector<nscd::Grains> all = batches(source, tools, reads);
    ASSERT_EQ(all.size(), 3u);
    const nscd::Grains& second = all[1];
    EXPECT_EQ(second.id, (std::vector<std::int64_t>{2, 3}));
    EXPECT_EQ(second.radius[1], 0.04);
    EXPECT_EQ(second.material[1], 1);
    EXPECT_EQ(second.velocity[1], Vec3(3, 2, 3));
    EXPECT_EQ(second.omega[1], Vec3(0, 0, 3));
    EXPECT_EQ(second.orientation[1].x(), 1);
    EXPECT_EQ(second.isFixed[0] + 2*second.isFixed[1], 2);
    EXPECT_NEAR(second.mass[1], 11000*M_PI/6*0.08*0.08*0.08, 1e-12);
    EXPECT_THROW(read(source, around()), input::InputError);
    // What is held here stands still, but for what was held there too, and moved as told.
    const nscd::Grains held = batches("motion fixed; " + source, {}, reads).at(0);
    EXPECT_EQ(held.isFixed, std::vector<std::uint8_t>(5, 1));
    EXPECT_EQ(held.velocity[2], Vec3(0, 0, 0));
    EXPECT_EQ(held.omega[2], Vec3(0, 0, 0));
    EXPECT_EQ(held.velocity[3], Vec3(3, 2, 3));
    reads.shape.emptyAxis = 2;
    EXPECT_THROW(batches(source, tools, reads), input::InputError);
}

/// Diameters are those of real grains, places those of parcels; which are which is told by their numbers.
TEST_F(Placements, makeParcelsOfSourcesThatAreCoarse)
{
    write("table.txt", "0.1 0.2 0.3 0.02\n");
    write("list.txt", "((0.7 0.1 0.2))");
    input::Surroundings coarse = around();
    coarse.hasCoarseGrains = true;
    coarse.grainsOfTime = [](const input::GrainSource&, const input::MaterialTable&)
    {
        input::WrittenGrains written;
        for (int k = 0; k < 3; ++k) written.grains.add({0.1*k, 0, 0}, 0.01, 2500, 0, k);
        written.coarseGraining = {3, 3, 1};
        return written;
    };
    const std::string sources =
        "grains { a { type lattice; box (0 0 0) (1 1 1); count (2 1 1); diameter 0.1; material glass; coarseGraining 2; }\n"
        " b { type table; file table.txt; material glass; coarseGraining 1.5; } c { type positionsFile; file list.txt; diameter 0.05; material glass; coarseGraining 4; }"
        " d { type time; case old; time 0.5; } e { type filling; region { type box; box (2 0 0) (3 1 1); } number 81; diameter 0.1; material glass; coarseGraining 2; }"
        " f { type entering; region { type box; box (0 0 0) (1 1 1); } rate 80; number 17; diameter 0.1; material glass; coarseGraining 2; } }";
    input::PlacementTools tools;
    input::PlacedFactors factors;
    tools.factors = &factors;
    const nscd::Grains grains = batches(sources, tools, coarse).at(0);
    ASSERT_EQ(grains.size(), 17u);
    const std::vector<double> diameters = {0.2, 0.2, 0.03, 0.2, 0.02, 0.02, 0.02, 0.2}, expected = {2, 2, 1.5, 4, 3, 3, 1, 2};
    for (std::size_t i = 0; i < diameters.size(); ++i)
    {
        EXPECT_NEAR(2*grains.radius[i], diameters[i], 1e-15) << i;
        EXPECT_EQ(factors.of(grains.id[i]), expected[i]) << i;
    }
    const input::Scene scene = read(sources, coarse);
    EXPECT_TRUE(scene.hasCoarseGrains);
    EXPECT_EQ(scene.entries.at(0).number, 2);
    EXPECT_NEAR(scene.entries.at(0).amount(1), 10, 1e-9);
    EXPECT_EQ(scene.entries.at(0).sizes.largest, 0.2);
    EXPECT_THROW(read(sources, around()), input::InputError) << "of a program without parcels";
}

TEST_F(Placements, clumpsOfMembersThatAreLightYearsApartAreAMistake)
{
    const std::string source = "grains { type lattice; box (0 0 0) (1 1 1); count (1 1 1); diameter 0.5; material glass; clump { file pebble.txt; } }";
    write("pebble.txt", "0 0 0 0.1\n0.1 0 0 0.1\n");
    EXPECT_NO_THROW(read(source, around()));
    for (const char* const far : {"0 0 0 0.1\n1e12 0 0 0.1\n", "0 0 0 0.1\n0 0 0 1e12\n", "0 0 0 0.1\n0 0 0 1e-12\n"})
    {
        write("pebble.txt", far);
        EXPECT_THROW(read(source, around()), input::InputError) << far;
    }
}

/// With many draws between wide ends mean and deviation come back.
TEST_F(Placements, logNormalSizesByMeanAndDeviationHaveThese)
{
    const std::string start = "grains { type entering; region { type box; box (0 0 0) (1 1 1); } rate 80; number 17; material glass; sizes { type logNormal; min 1e-4; max 1; ";
    const input::Scene scene = read(start + "mean 0.0041; deviation 0.001; } }", around());
    std::uint64_t state = 1;
    const nscd::RandomNumbers random = [&] { return ((state = state*6364136223846793005ULL + 1442695040888963407ULL) >> 11)*0x1p-53; };
    const int draws = 100000;
    double sum = 0, squares = 0;
    for (int k = 0; k < draws; ++k)
    {
        const double d = scene.entries.at(0).sizes.draw(random);
        sum += d;
        squares += d*d;
    }
    const double mean = sum/draws;
    EXPECT_NEAR(mean, 0.0041, 0.00002);
    EXPECT_NEAR(std::sqrt(squares/draws - mean*mean), 0.001, 0.00002);
    EXPECT_THROW(read(start + "mean 0.0041; median 0.004; deviation 0.001; } }", around()), input::InputError);
    EXPECT_THROW(read(start + "median 0.0041; deviation 0.001; } }", around()), input::InputError);
}
