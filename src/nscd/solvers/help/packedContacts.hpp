// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contacts that matter in a step, in full blocks of their own: in flows three lanes of ten of a list's active blocks carry nothing.
#pragma once

#include "nscd/contacts/contactBatching.hpp"
#include "nscd/solvers/problem/stopRule.hpp"

namespace nscd
{

/// A solve's problem is packed, solved, and given back. Meanwhile the lanes of packed contacts in the list's blocks have a bias that no motion
/// reaches, so that the list's blocks tell which further contacts should be packed. Keeps its memory from solve to solve.
class PackedContacts : public ContactsLeftOut
{
public:
    /// Whether packing pays: in a large flow whose last solve of its kind was long. It costs as much as five sweeps. Collective.
    bool isWorthwhile(const ContactProblem& whole, const SolverStrategy::Packing& strategy) const;

    /// The contacts of the active blocks that carry an impulse, are closed, or close in the present motion.
    /// Ensures: until giveBack() the packed problem stands for the whole one, which must not be touched
    ContactProblem pack(ContactProblem& whole, double nearlyClosing);

    bool wake(ContactProblem& packed) override;
    DefectSums defects(const ContactProblem& packed) const override;

    /// Gives the impulses to the whole problem, whose active blocks then hold all that is loaded.
    void giveBack(ContactProblem& whole) const;

    /// Takes note of how long the last solve of its kind was.
    void note(bool isShock, int sweeps) { lastSweeps_[isShock] = sweeps; }
    void forget() { lastSweeps_[0] = lastSweeps_[1] = 0; }

private:
    void append(const std::vector<std::uint32_t>& slots, ContactProblem& packed);
    void insert(const std::vector<std::uint32_t>& slots, std::size_t before, int staticBody);
    BlockRange lookedAt(const ContactProblem& packed) const;

    int lastSweeps_[2] = {0, 0};   ///< of motions, of shocks; 0: not known
    std::vector<ContactBlock>* home_ = nullptr;
    std::size_t homeInterface_ = 0;       ///< of the list's blocks, the first that joins grains of two ranks
    std::vector<ContactBlock> blocks_;
    std::vector<LawBlock>* homeLaw_ = nullptr;   ///< null where contacts bear none
    std::vector<LawBlock> ofLaw_;
    std::vector<std::uint32_t> awake_;    ///< all of them
    std::vector<std::uint32_t> slotOf_;   ///< of each packed lane; lanes that are not used have none
    std::vector<std::uint32_t> awakeAtHome_;  ///< of the list's blocks, in a shock: it lets no others carry anything
};

} // namespace nscd
