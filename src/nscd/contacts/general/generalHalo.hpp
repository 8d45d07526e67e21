// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// General bodies that contacts of several ranks move, and how their motions are kept one.
// Tested by tests/parallel/clumpsTest.cpp
#pragma once

#include "nscd/contacts/general/generalBody.hpp"
#include "nscd/scene/exchange.hpp"

#include <vector>

namespace nscd
{

/// Halo for general bodies, by the same rule: a body with contacts between ranks on n of them takes part there with n times its mobility, and moves by the
/// mean of what they make of it. It travels with one of its members that others have as ghosts, whichever they have first.
/// General bodies are numbered: own ones, ghosts, copies of own ones with n > 1 for the contacts between ranks that are solved here.
class GeneralHalo
{
public:
    /// A linear and an angular part of each general body, one behind the other: velocities, or displacements.
    using Motions = std::vector<double>;
    static constexpr int width = 6;

    /// No other ranks.
    GeneralHalo() = default;

    /// Collective. `ghosts`: grains of other ranks, connected. `sharedOwners`: of the own grains that connect() returned, the own general body each is part
    /// of, or -1. `interfaceBodies`: own general bodies with contacts between ranks that are solved here, ascending.
    GeneralHalo
    (
        Exchange& exchange, int ownBodies, const std::vector<GhostGrain>& ghosts, std::vector<int> sharedOwners, const std::vector<int>& interfaceBodies
    );

    bool isParallel() const { return exchange_ != nullptr; }
    int ownBodies() const { return ownBodies_; }
    std::size_t bodies() const { return ownBodies_ + parts_.size(); }
    /// The general body of each ghost grain, or -1.
    const std::vector<int>& bodyOfGhost() const { return bodyOfGhost_; }
    /// The body that contacts between ranks move in the place of another: its copy, if it has one.
    int inInterface(int body) const;

    /// Gives ghosts and copies the owners' free motions and mobilities, these times n.
    void giveBodies(std::vector<GeneralBody>& bodies) const;
    /// Overwrites ghosts' and copies' motions with their owners'.
    void give(Motions& motions) const;
    /// Moves the owners' motions by the means of what became of the ghosts' and copies' since they were `given`.
    void take(Motions& motions, const Motions& given) const;

private:
    int firstCopy() const { return ownBodies_ + static_cast<int>(representative_.size()); }
    void toGhosts(const std::vector<double>& ofOwn, std::vector<double>& ofGhosts, int numbers) const;
    void findGhostBodies(const std::vector<GhostGrain>& ghosts);

    Exchange* exchange_ = nullptr;
    int ownBodies_ = 0;
    std::vector<int> shared_;           ///< per own grain that others have: the own general body that travels with it, or -1
    std::vector<int> bodyOfGhost_;
    std::vector<int> representative_;   ///< of each ghost body the ghost grain that it travels with
    std::vector<int> copied_;           ///< own bodies, ascending
    std::vector<double> parts_;         ///< n of each ghost and copy
};

} // namespace nscd
