// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The seam between the grain library and other ranks: everything it asks of them, and the answer of a serial run.
#pragma once

#include "grains.hpp"

#include <vector>

namespace nscd
{

/// What the grain library needs from other ranks. One object per run, handed to GrainDynamics; the base class is serial.
class Exchange
{
public:
    virtual ~Exchange() = default;

    virtual double sum(double value) const { return value; }
    virtual double max(double value) const { return value; }

    /// Adds what was collected on ghosts to their owners' entries.
    virtual void sumToOwners(std::vector<Vec3>&) const {}
    /// Overwrites ghosts' entries with their owners' values.
    virtual void copyToGhosts(std::vector<Vec3>&) const {}
    virtual void copyToGhosts(std::vector<double>&) const {}
};

} // namespace nscd
