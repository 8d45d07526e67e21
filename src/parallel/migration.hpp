// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains, and whatever belongs to them, on their way to new owners.
#pragma once

#include "nscd/scene/grains.hpp"
#include "nscd/scene/storedImpulse.hpp"
#include "parallel/communicator.hpp"

namespace nscd
{

/// One move of the own grains to other ranks, or to their own: all that belongs to a grain arrives in one order, sorted by the rank
/// it came from and its index there. All functions are collective.
/// Cost: one message per rank concerned and a barrier for each function.
class Migration
{
public:
    /// `destination`: a rank for each own grain. `all` must live as long as this.
    /// Errors: std::invalid_argument for a destination that is not a rank
    Migration(const Communicator& all, std::vector<int> destination);

    /// Moves one value per own grain.
    /// Errors: std::invalid_argument for another number of values
    template<class T>
    std::vector<T> move(const std::vector<T>& values) const
    {
        checkNumber(values.size());
        return valuesOf<T>(all_.exchange(messagesByRank(values, destination_)));
    }
    std::vector<Vec3> move(const std::vector<Vec3>& values) const;
    std::vector<Quaternion> move(const std::vector<Quaternion>& values) const;

    /// Moves the owned grains with all their properties, by one message per pair of ranks, and one more for clumps, which go as wholes.
    /// Errors:   std::invalid_argument for members of a clump that go to different ranks
    /// Ensures:  all that return are owned; the shape is this rank's, and so are those of clumps
    Grains moveGrains(const Grains& grains) const;

private:
    void checkNumber(std::size_t number) const;
    void moveClumps(const Grains& grains, Grains& received) const;

    const Communicator& all_;
    std::vector<int> destination_;
};

/// Brings each impulse to the rank that `destination` names for it. Collective.
std::vector<StoredImpulse> moveImpulses
(
    const Communicator& all, const std::vector<StoredImpulse>& impulses, const std::vector<int>& destination
);

} // namespace nscd
