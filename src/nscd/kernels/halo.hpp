// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Bodies that contacts of several ranks move: ghosts of other ranks' grains, and how their velocities are kept one.
#pragma once

#include "nscd/kernels/contactBlock.hpp"
#include "nscd/scene/exchange.hpp"

#include <cstdint>
#include <vector>

namespace nscd
{

/// An interface contact joins grains of two ranks and is solved by one of them. A body with interface contacts on n ranks takes part
/// there with n times its mobility, and moves by the mean of what they make of it (mass splitting: sum of r/m, whatever n).
/// With n = 1, as away from the corners of ranks, that is Gauss-Seidel.
/// Bodies are numbered: own grains, ghosts, copies of own grains with n > 1 for the interface contacts here, the static body.
class Halo
{
public:
    /// No other ranks.
    Halo() = default;

    /// `shared`: own bodies, as connect() returned the grains. `interfaceBodies`: own bodies with interface contacts here, ascending.
    Halo(Exchange& exchange, int ownBodies, std::size_t ghosts, std::vector<int> shared, const std::vector<int>& interfaceBodies);

    bool isParallel() const { return exchange_ != nullptr; }
    int firstGhost() const { return ownBodies_; }
    int firstCopy() const { return ownBodies_ + static_cast<int>(ghosts_); }
    std::size_t bodies() const { return ownBodies_ + ghosts_ + copied_.size(); }

    /// Own bodies that have copies, in the order of these.
    const std::vector<int>& copied() const { return copied_; }
    /// Own bodies that other ranks have as ghosts.
    const std::vector<int>& shared() const { return shared_; }
    /// n of each ghost and copy.
    double parts(int body) const { return parts_[body - ownBodies_]; }

    /// Gives ghosts and copies the owners' velocities and mobilities, these times n.
    void giveBodies(std::vector<Body>& bodies);
    /// Gives ghosts and copies the owners' velocities, before interface contacts are looked at.
    void giveVelocities(std::vector<Body>& bodies);
    /// Moves the owners' velocities by what became of the ghosts' and copies' since they were given.
    void takeVelocities(std::vector<Body>& bodies);

    /// Overwrites ghosts' and copies' entries with their owners'.
    void give(std::vector<Vec3>& perBody) const;
    /// Moves the owners' entries by the means of what became of the ghosts' and copies' since give(), whose `given` entries were theirs, ghosts first.
    void takeChanges(std::vector<Vec3>& perBody, const std::vector<Vec3>& given) const;
    /// Adds ghosts' and copies' entries to their owners'.
    void take(std::vector<Vec3>& perBody) const;

    /// Makes owners' entries the smallest, or largest, of theirs and of those of their ghosts and copies.
    void takeSmallest(std::vector<double>& perBody) const;
    void takeLargest(std::vector<double>& perBody) const;

    /// Overwrites ghosts' and copies' flags with their owners'; sets owners' flags where one of theirs is set.
    void giveFlags(std::vector<std::uint8_t>& perBody) const;
    void takeFlags(std::vector<std::uint8_t>& perBody) const;

    double sum(double value) const;
    double max(double value) const;
    bool any(bool value) const { return max(value ? 1.0 : 0.0) > 0.0; }
    void sum(double* values, int count) const { if (exchange_) exchange_->sum(values, count); }
    void max(double* values, int count) const { if (exchange_) exchange_->max(values, count); }
    void sumAndMax(double (&sums)[2], double& max) const { if (exchange_) exchange_->sumAndMax(sums, max); }

private:
    Exchange* exchange_ = nullptr;
    int ownBodies_ = 0;
    std::size_t ghosts_ = 0;
    std::vector<int> shared_;
    std::vector<int> copied_;
    std::vector<double> parts_;
    mutable std::vector<double> toOthers_, fromOthers_;
    std::vector<double> given_;   ///< velocities at the last giving, 6 of each ghost and copy
};

} // namespace nscd
