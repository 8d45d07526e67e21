// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Values of grains to their homes and back, whoever owns them and wherever they are at home.
#include "parallel/grainLink.hpp"

#include <gtest/gtest.h>

#include <random>

using nscd::Communicator;
using nscd::GrainLink;

namespace
{

/// Of the grains of a rank; every tenth has none.
std::vector<int> homesOf(int rank, int size, unsigned seed)
{
    std::mt19937 random(100*seed + rank);
    std::vector<int> homes(rank == 1 ? 0 : 20 + random() % 30);
    for (int& home : homes) home = random() % 10 == 0 ? -1 : static_cast<int>(random() % size)/2*2 % size;
    return homes;
}

} // namespace

TEST(GrainLink, rowsAreSortedByOwnerAndValuesReturn)
{
    const Communicator all;
    GrainLink link(all);
    for (unsigned seed = 1; seed < 4; ++seed)
    {
        const std::vector<int> homes = homesOf(all.rank(), all.size(), seed);
        link.connect(homes);
        std::vector<double> owner(homes.size(), all.rank()), places;
        for (std::size_t i = 0; i < homes.size(); ++i) places.insert(places.end(), {double(i), -double(i)});
        std::vector<double> ownerOfRow(link.rows()), placeOfRow(2*link.rows());
        link.toHomes({{owner.data(), homes.size(), ownerOfRow.data(), 1}, {places.data(), homes.size(), placeOfRow.data(), 2}});

        std::vector<double> owners, expected;
        for (int rank = 0; rank < all.size(); ++rank)
        {
            const std::vector<int> theirs = homesOf(rank, all.size(), seed);
            for (std::size_t i = 0; i < theirs.size(); ++i)
            {
                if (theirs[i] != all.rank()) continue;
                owners.push_back(rank);
                expected.insert(expected.end(), {double(i), -double(i)});
            }
        }
        EXPECT_EQ(ownerOfRow, owners);
        EXPECT_EQ(placeOfRow, expected);

        std::vector<double> ownerBack(link.grains(), -1.0), placeBack(2*link.grains(), -1.0);
        link.toOwners({{ownerOfRow.data(), link.rows(), ownerBack.data(), 1}, {placeOfRow.data(), link.rows(), placeBack.data(), 2}});
        ASSERT_EQ(link.grains(), homes.size());
        for (std::size_t i = 0; i < homes.size(); ++i)
        {
            EXPECT_EQ(ownerBack[i], homes[i] < 0 ? 0.0 : all.rank());
            EXPECT_EQ(placeBack[2*i], homes[i] < 0 ? 0.0 : static_cast<double>(i));
            EXPECT_EQ(placeBack[2*i + 1], homes[i] < 0 ? 0.0 : -static_cast<double>(i));
        }
    }
}

TEST(GrainLink, refusesWhatIsNoRankOrDoesNotFit)
{
    const Communicator all;
    GrainLink link(all);
    EXPECT_THROW(link.connect({all.size()}), std::invalid_argument);
    EXPECT_THROW(link.connect({-2}), std::invalid_argument);
    link.connect({all.rank()});
    const double from[2] = {1.0, 2.0};
    double to[2];
    EXPECT_THROW(link.toHomes({{from, 2, to, 1}}), std::invalid_argument);
    EXPECT_THROW(link.toHomes({{from, 1, to, 1}, {from, 2, to, 1}}), std::invalid_argument);
    EXPECT_THROW(link.toOwners({{from, 0, to, 1}}), std::invalid_argument);
}
