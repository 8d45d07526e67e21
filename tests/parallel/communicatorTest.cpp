// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reductions, sparse messages and the tree of ranks against what every rank can work out.
#include "parallel/rankTree.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace nscd;

TEST(Communicator, sumsAndMaximaOverAllRanks)
{
    const Communicator all;
    const int n = all.size();
    double sums[] = {1.0, double(all.rank())}, maxima[] = {double(all.rank()), -1.0 - all.rank()};
    all.sum(sums, 2);
    all.max(maxima, 2);
    EXPECT_EQ(sums[0], n);
    EXPECT_EQ(sums[1], n*(n - 1)/2);
    EXPECT_EQ(maxima[0], n - 1);
    EXPECT_EQ(maxima[1], -1.0);
    double both[2] = {2.0, double(all.rank())}, max = -double(all.rank());
    all.sumAndMax(both, max);
    EXPECT_EQ(both[0], 2*n);
    EXPECT_EQ(both[1], n*(n - 1)/2);
    EXPECT_EQ(max, 0.0);
}

TEST(Communicator, sumsAreTheSameBitsOnAllRanks)
{
    const Communicator all;
    std::mt19937 random(all.rank());
    std::vector<double> sums(100);
    for (double& sum : sums) sum = random()*1e-3;
    all.sum(sums.data(), 100);
    std::vector<double> bounds = sums;
    for (double sum : sums) bounds.push_back(-sum);
    all.max(bounds.data(), 200);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(bounds[i], -bounds[100 + i]);
}

TEST(Communicator, oneRankReducesWithoutMessages)
{
    const Communicator all;
    const Communicator alone = all.split(all.rank());
    double value = 3.0;
    alone.sum(&value, 1);
    alone.max(&value, 1);
    double sums[2] = {1.0, 2.0};
    alone.sumAndMax(sums, value);
    EXPECT_EQ(value, 3.0);
    EXPECT_EQ(all.traffic().reductions, 0);
}

TEST(Communicator, splitKeepsTheOrderOfRanks)
{
    const Communicator all;
    const Communicator part = all.split(all.rank() % 2);
    EXPECT_EQ(part.rank(), all.rank()/2);
    EXPECT_EQ(part.size(), (all.size() + 1 - all.rank() % 2)/2);
}

namespace
{

/// What rank `from` tells rank `to` in a round; mostly nothing.
std::vector<int> wordsFor(int round, int from, int to)
{
    std::mt19937 random(10007*round + 101*from + to);
    if (random() % 3 != 0) return {};
    std::vector<int> words(1 + random() % 2000, round);
    words.push_back(100*from + to);
    return words;
}

} // namespace

TEST(Communicator, exchangesRandomMessagesRoundAfterRound)
{
    const Communicator all;
    std::int64_t messages = 0;
    for (int round = 0; round < 200; ++round)
    {
        std::vector<int> sent, destination;
        std::vector<int> expected, senders, got;
        for (int other = all.size() - 1; other >= 0; --other)
        {
            const std::vector<int> words = wordsFor(round, all.rank(), other);
            sent.insert(sent.end(), words.begin(), words.end());
            destination.insert(destination.end(), words.size(), other);
            messages += !words.empty() && other != all.rank();
        }
        for (int other = 0; other < all.size(); ++other)
        {
            const std::vector<int> words = wordsFor(round, other, all.rank());
            if (!words.empty()) senders.push_back(other);
            expected.insert(expected.end(), words.begin(), words.end());
        }
        const std::vector<Message> received = all.exchange(messagesByRank(sent, destination));
        for (const Message& message : received) got.push_back(message.rank);
        EXPECT_EQ(got, senders);
        EXPECT_EQ(valuesOf<int>(received), expected);
    }
    EXPECT_EQ(all.traffic().messages, messages);
}

TEST(Communicator, keepsTheOrderOfASendersMessagesAndDeliversEmptyOnes)
{
    const Communicator all;
    const int next = (all.rank() + 1) % all.size(), last = (all.rank() + all.size() - 1) % all.size();
    const std::vector<Message> received = all.exchange({{next, {'a'}}, {next, {}}, {next, {'b', 'c'}}});
    ASSERT_EQ(received.size(), 3u);
    EXPECT_EQ(received[0].rank, last);
    EXPECT_EQ(received[0].bytes, std::vector<char>({'a'}));
    EXPECT_TRUE(received[1].bytes.empty());
    EXPECT_EQ(received[2].bytes, std::vector<char>({'b', 'c'}));
}

TEST(Communicator, refusesAMessageOfNoWholeNumberOfValues)
{
    std::vector<double> values;
    EXPECT_THROW(unpack(std::vector<char>(12), values), std::length_error);
}

TEST(RankTree, sendsAcrossEveryLevelToOneRankOnly)
{
    const RankTree tree{Communicator()};
    for (const RankLevel& level : tree.levels())
    {
        const double own = level.group.rank();
        double sums[] = {own, 0.0};
        for (double value : sendAcross(level, std::vector<double>{own}))
        {
            EXPECT_NE(value < level.lowSize, level.isLow());
            sums[1] += value;
        }
        level.group.sum(sums, 2);
        EXPECT_EQ(sums[0], sums[1]) << "each value arrives once";
        EXPECT_NE(tellAcross(level, int(level.isLow())), int(level.isLow()));
    }
}

TEST(RankTree, isAsDeepAsTheLogarithmOfTheRanks)
{
    const RankTree tree{Communicator()};
    int depth = 0;
    while (1 << depth < tree.all().size()) ++depth;
    EXPECT_LE(int(tree.levels().size()), depth);
    if (tree.all().rank() == 0) { EXPECT_EQ(int(tree.levels().size()), depth); }
}
