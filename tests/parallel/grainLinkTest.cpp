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
        std::vector<double> values;
        for (std::size_t i = 0; i < homes.size(); ++i)
        {
            values.push_back(all.rank());
            values.push_back(static_cast<double>(i));
        }
        const std::vector<double> rows = link.toHomes(values, 2);

        std::vector<double> expected;
        for (int owner = 0; owner < all.size(); ++owner)
        {
            const std::vector<int> theirs = homesOf(owner, all.size(), seed);
            for (std::size_t i = 0; i < theirs.size(); ++i)
            {
                if (theirs[i] == all.rank()) expected.insert(expected.end(), {double(owner), double(i)});
            }
        }
        EXPECT_EQ(rows, expected);
        EXPECT_EQ(2*link.rows(), expected.size());

        std::vector<double> back = link.toOwners(rows, 2);
        for (std::size_t i = 0; i < homes.size(); ++i)
        {
            EXPECT_EQ(back[2*i], homes[i] < 0 ? 0.0 : all.rank());
            EXPECT_EQ(back[2*i + 1], homes[i] < 0 ? 0.0 : static_cast<double>(i));
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
    EXPECT_THROW(link.toHomes({1.0, 2.0}, 1), std::invalid_argument);
    EXPECT_THROW(link.toOwners({}, 1), std::invalid_argument);
}
