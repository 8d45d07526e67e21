// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The table of laws beside Coulomb's, and which of them a scene has.
#include "nscd/contacts/contactLaw.hpp"
#include "nscd/contacts/listLaws.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace nscd;

namespace
{

Materials withPair(const ContactPair& pair)
{
    Materials materials;
    materials.add("one");
    materials.add("other");
    materials.setPair(0, 1, pair);
    return materials;
}

ContactPair cohesive(double range) { return {0.0, 0.0, 0.0, 0.0, 1e-3, range}; }
const ContactPair rolling{0.0, 0.0, 0.1, 0.0, 0.0, 0.0};
const ContactPair spinning{0.0, 0.0, 0.0, 0.1, 0.0, 0.0};

std::vector<std::string> wordsOf(const Materials& materials)
{
    std::vector<std::string> words;
    for (const ContactLawRow* row : lawsInUse(materials)) words.push_back(row->words);
    return words;
}

using Words = std::vector<std::string>;

} // namespace

TEST(ContactLaws, aSceneHasThoseWhoseCoefficientsAreSetAndNoOthers)
{
    EXPECT_EQ(wordsOf(Materials()), Words());
    EXPECT_EQ(wordsOf(withPair({0.5, 0.8})), Words());
    EXPECT_EQ(wordsOf(withPair(cohesive(0.0))), Words{"cohesion"});
    EXPECT_EQ(wordsOf(withPair(rolling)), Words{"rolling or spinning friction"});
    EXPECT_EQ(wordsOf(withPair(spinning)), Words{"rolling or spinning friction"});
    EXPECT_EQ(wordsOf(withPair({0.5, 0.0, 0.1, 0.0, 1e-3, 0.0})), (Words{"cohesion", "rolling or spinning friction"}));
}

TEST(ContactLaws, rangeIsTheLargestOfThoseThatAct)
{
    EXPECT_EQ(rangeOfLaws(withPair(rolling)), 0.0);
    EXPECT_EQ(rangeOfLaws(withPair({0.0, 0.0, 0.0, 0.0, 0.0, 2e-3})), 0.0);
    EXPECT_EQ(rangeOfLaws(withPair(cohesive(2e-3))), 2e-3);
}

TEST(ContactLaws, spinsAreActedOnByFrictionOfAnyKind)
{
    EXPECT_FALSE(actsOnSpins(withPair({0.0, 1.0})));
    EXPECT_FALSE(actsOnSpins(withPair(cohesive(1e-3))));
    EXPECT_TRUE(actsOnSpins(withPair({0.1, 0.0})));
    EXPECT_TRUE(actsOnSpins(withPair(rolling)));
}

TEST(ContactLaws, rowsHaveWordsOfTheirOwnAndAPlaceForEachImpulseKept)
{
    std::set<std::string> words;
    std::size_t kept = 0;
    for (const ContactLawRow& row : contactLaws())
    {
        EXPECT_TRUE(words.insert(row.words).second) << row.words;
        EXPECT_NE(row.make(), nullptr);
        kept += row.impulseName != nullptr;
    }
    EXPECT_EQ(kept, lawImpulses);
}

TEST(ListLaws, ofPlainScenesAreNone)
{
    const ListLaws laws(withPair({0.5, 0.8}));
    EXPECT_TRUE(laws.empty());
    EXPECT_FALSE(laws.areOfSpins() || laws.areOfStart() || laws.haveImpulses());
    EXPECT_EQ(laws.known(3), Vec3::Zero());
}

TEST(ListLaws, keepTheImpulsesOfEachSlotAndTakeThoseOfAnother)
{
    const Materials materials = withPair({0.5, 0.0, 0.1, 0.0, 1e-3, 0.0});
    ListLaws laws(materials), others(materials);
    EXPECT_TRUE(laws.areOfSpins() && laws.areOfStart() && laws.haveImpulses());
    laws.resize(4);
    others.resize(2);
    for (std::size_t slot = 0; slot < 4; ++slot) laws.set(slot, materials.pair(0, 1), 0.1, 0.2);
    LawImpulses kept = noLawImpulses();
    kept[0] = Vec3(1, 2, 3);
    laws.setImpulses(2, kept);
    EXPECT_EQ(laws.impulses(2)[0], Vec3(1, 2, 3));
    EXPECT_EQ(laws.impulses(1)[0], Vec3::Zero());
    others.copy(laws, 2, 1);
    EXPECT_EQ(others.impulses(1)[0], Vec3(1, 2, 3));
    EXPECT_EQ((-kept)[0], Vec3(-1, -2, -3));
}
