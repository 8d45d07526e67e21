// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Giving and taking between owners, ghosts and copies of general bodies.
#include "nscd/contacts/general/generalHalo.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace nscd
{

namespace
{

constexpr int numbersOfBody = 16;

/// Mobilities and free motion.
void pack(const GeneralBody& body, double* to)
{
    *to++ = body.invMass;
    to = std::copy_n(body.invInertia.data(), 9, to);
    to = std::copy_n(body.freeV.data(), 3, to);
    std::copy_n(body.freeOmega.data(), 3, to);
}

GeneralBody unpacked(const double* from, double parts)
{
    GeneralBody body;
    body.invMass = parts*from[0];
    body.invInertia = parts*Eigen::Map<const Eigen::Matrix3d>(from + 1);
    body.v = body.freeV = Vec3(from + 10);
    body.omega = body.freeOmega = Vec3(from + 13);
    // What ghosts and copies stand for is moved where it is owned.
    body.inertia = Eigen::Matrix3d::Zero();
    body.freeMomentum = Vec3::Zero();
    return body;
}

} // namespace

GeneralHalo::GeneralHalo
(
    Exchange& exchange, int ownBodies, const std::vector<GhostGrain>& ghosts, std::vector<int> sharedOwners, const std::vector<int>& interfaceBodies
)
:
    exchange_(&exchange),
    ownBodies_(ownBodies),
    shared_(std::move(sharedOwners))
{
    findGhostBodies(ghosts);
    std::vector<double> travels(ghosts.size(), 0.0), areWanted(shared_.size());
    for (int ghost : representative_) travels[ghost] = 1.0;
    exchange_->toOwners(travels, areWanted, 1);
    std::vector<double> ranks(ownBodies, 0.0);
    for (int body : interfaceBodies) ranks[body] += 1.0;
    for (std::size_t k = 0; k < shared_.size(); ++k)
    {
        if (areWanted[k] == 0.0) shared_[k] = -1;
        if (shared_[k] >= 0) ranks[shared_[k]] += 1.0;
    }
    toGhosts(ranks, parts_, 1);
    for (int body : interfaceBodies)
    {
        if (ranks[body] <= 1.0) continue;
        copied_.push_back(body);
        parts_.push_back(ranks[body]);
    }
}

void GeneralHalo::findGhostBodies(const std::vector<GhostGrain>& ghosts)
{
    std::map<std::pair<int, int>, int> number;
    for (std::size_t g = 0; g < ghosts.size(); ++g)
    {
        bodyOfGhost_.push_back(-1);
        if (ghosts[g].clump < 0) continue;
        const auto [body, isNew] = number.try_emplace({ghosts[g].owner, ghosts[g].clump}, firstCopy());
        if (isNew) representative_.push_back(static_cast<int>(g));
        bodyOfGhost_.back() = body->second;
    }
}

int GeneralHalo::inInterface(int body) const
{
    const auto copy = std::lower_bound(copied_.begin(), copied_.end(), body);
    return copy != copied_.end() && *copy == body ? firstCopy() + static_cast<int>(copy - copied_.begin()) : body;
}

/// Numbers of own bodies to those of the ghost bodies.
void GeneralHalo::toGhosts(const std::vector<double>& ofOwn, std::vector<double>& ofGhosts, int numbers) const
{
    std::vector<double> sent(numbers*shared_.size(), 0.0), received;
    for (std::size_t k = 0; k < shared_.size(); ++k)
    {
        if (shared_[k] >= 0) std::copy_n(&ofOwn[numbers*shared_[k]], numbers, &sent[numbers*k]);
    }
    received.resize(numbers*bodyOfGhost_.size());
    exchange_->toGhosts(sent, received, numbers);
    ofGhosts.resize(numbers*representative_.size());
    for (std::size_t g = 0; g < representative_.size(); ++g) std::copy_n(&received[numbers*representative_[g]], numbers, &ofGhosts[numbers*g]);
}

void GeneralHalo::giveBodies(std::vector<GeneralBody>& bodies) const
{
    if (!exchange_) return;
    std::vector<double> own(numbersOfBody*ownBodies_), given;
    for (int body = 0; body < ownBodies_; ++body) pack(bodies[body], &own[numbersOfBody*body]);
    toGhosts(own, given, numbersOfBody);
    for (int body : copied_) given.insert(given.end(), &own[numbersOfBody*body], &own[numbersOfBody*body] + numbersOfBody);
    for (std::size_t k = 0; k < parts_.size(); ++k) bodies[ownBodies_ + k] = unpacked(&given[numbersOfBody*k], parts_[k]);
}

void GeneralHalo::give(Motions& motions) const
{
    if (!exchange_) return;
    std::vector<double> given;
    toGhosts(motions, given, width);
    std::copy(given.begin(), given.end(), motions.begin() + width*ownBodies_);
    for (std::size_t c = 0; c < copied_.size(); ++c) std::copy_n(&motions[width*copied_[c]], width, &motions[width*(firstCopy() + c)]);
}

void GeneralHalo::take(Motions& motions, const Motions& given) const
{
    if (!exchange_) return;
    const auto change = [&](std::size_t k, int m)
    {
        const std::size_t at = width*(ownBodies_ + k) + m;
        return (motions[at] - given[at])/parts_[k];
    };
    std::vector<double> sent(width*bodyOfGhost_.size(), 0.0), received(width*shared_.size());
    for (std::size_t g = 0; g < representative_.size(); ++g)
    {
        for (int m = 0; m < width; ++m) sent[width*representative_[g] + m] = change(g, m);
    }
    exchange_->toOwners(sent, received, width);
    for (std::size_t c = 0; c < copied_.size(); ++c)
    {
        for (int m = 0; m < width; ++m) motions[width*copied_[c] + m] += change(representative_.size() + c, m);
    }
    for (std::size_t k = 0; k < shared_.size(); ++k)
    {
        for (int m = 0; m < width && shared_[k] >= 0; ++m) motions[width*shared_[k] + m] += received[width*k + m];
    }
}

} // namespace nscd
