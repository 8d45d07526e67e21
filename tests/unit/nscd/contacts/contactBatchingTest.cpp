// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Batches: every contact once, and no two of a block with a body in common.
#include "nscd/contacts/contactBatching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

using namespace nscd;

namespace
{

std::vector<std::uint32_t> inOrder(std::size_t number)
{
    std::vector<std::uint32_t> order(number);
    std::iota(order.begin(), order.end(), 0);
    return order;
}

/// Pairs of neighbors in a row of bodies, some farther pairs, and walls, which are the static body.
std::vector<Candidate> contactsOf(int bodies)
{
    std::mt19937 random(2);
    std::uniform_int_distribution<int> shift(1, 12);
    std::vector<Candidate> contacts;
    for (int a = 0; a < bodies; ++a)
    {
        for (int b = a + shift(random); b < bodies && b < a + 12; b += shift(random)) contacts.push_back({a, b, -1, {0, 0, 0}});
        if (a % 3 == 0) contacts.push_back({a, bodies, 0, {0, 0, 0}});
    }
    return contacts;
}

void expectIndependentLanes(const std::vector<Candidate>& contacts, const Batches& batches, int staticBody)
{
    std::set<std::uint32_t> slots;
    std::set<std::pair<std::uint32_t, int>> bodiesOfBlocks;
    for (std::size_t k = 0; k < contacts.size(); ++k)
    {
        const std::uint32_t block = batches.slotOf[k]/blockLanes;
        EXPECT_LT(block, batches.blocks);
        EXPECT_TRUE(slots.insert(batches.slotOf[k]).second) << "slot " << batches.slotOf[k];
        for (int body : {contacts[k].a, contacts[k].b})
        {
            if (body != staticBody) { EXPECT_TRUE(bodiesOfBlocks.insert({block, body}).second) << "body " << body << " twice in " << block; }
        }
    }
}

} // namespace

TEST(ContactBatching, noTwoContactsOfABlockShareABody)
{
    const int bodies = 1000;
    const std::vector<Candidate> contacts = contactsOf(bodies);
    std::vector<std::uint32_t> order = inOrder(contacts.size());
    for (int trial = 0; trial < 3; ++trial)
    {
        const Batches batches = batchContacts(contacts, order, bodies);
        expectIndependentLanes(contacts, batches, bodies);
        EXPECT_LT(batches.blocks*blockLanes, 1.25*contacts.size());
        std::shuffle(order.begin(), order.end(), std::mt19937(trial));
    }
}

TEST(ContactBatching, contactsWithoutACommonBodyKeepTheirOrder)
{
    std::vector<Candidate> contacts;
    for (int k = 0; k < 1203; ++k) contacts.push_back({2*k, 2*k + 1, -1, {0, 0, 0}});
    const Batches batches = batchContacts(contacts, inOrder(contacts.size()), 2406);
    EXPECT_EQ(batches.slotOf, inOrder(contacts.size()));
    EXPECT_EQ(batches.blocks, 151u);
}

TEST(ContactBatching, aBodyWithManyContactsHasABlockForEach)
{
    std::vector<Candidate> contacts;
    for (int k = 1; k <= 200; ++k) contacts.push_back({0, k, -1, {0, 0, 0}});
    const Batches batches = batchContacts(contacts, inOrder(contacts.size()), 201);
    expectIndependentLanes(contacts, batches, 201);
    EXPECT_EQ(batches.blocks, 200u);
    EXPECT_EQ(batchContacts({}, {}, 0).blocks, 0u);
}

TEST(ContactBatching, emptyBlocksJoinTheStaticBodyToItself)
{
    const ContactBlock block = emptyBlock(17);
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        EXPECT_EQ(block.a[lane], 17);
        EXPECT_EQ(block.b[lane], 17);
        EXPECT_EQ(block.invWn[lane], 0.0);
    }
}
