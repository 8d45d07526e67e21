// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One number for all bits of a scene, for tests of reproducibility.
#pragma once

#include "nscd/step/grainDynamics.hpp"

#include <cstring>

namespace scenes
{

/// FNV-1a over bytes.
class Hash
{
public:
    void add(const double* x, int n)
    {
        unsigned char bytes[4*sizeof(double)];
        std::memcpy(bytes, x, n*sizeof(double));
        for (std::size_t k = 0; k < n*sizeof(double); ++k) value_ = (value_ ^ bytes[k])*1099511628211ULL;
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037ULL;
};

/// Over positions, velocities, spins and orientations.
inline std::uint64_t hash(const nscd::Grains& grains)
{
    Hash hash;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        hash.add(grains.position[i].data(), 3);
        hash.add(grains.velocity[i].data(), 3);
        hash.add(grains.omega[i].data(), 3);
        hash.add(grains.orientation[i].coeffs().data(), 4);
    }
    return hash.value();
}

/// Over the impulses and normals of all contacts that carry one, in their order.
inline std::uint64_t hash(const std::vector<nscd::LoadedContact>& contacts)
{
    Hash hash;
    for (const nscd::LoadedContact& contact : contacts)
    {
        const double identities[] = {double(contact.idA), double(contact.idB), contact.gap};
        hash.add(identities, 3);
        hash.add(contact.normal.data(), 3);
        hash.add(contact.impulse.data(), 3);
    }
    return hash.value();
}

} // namespace scenes
