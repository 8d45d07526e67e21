// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Giving and taking between owners, ghosts and copies.
#include "nscd/kernels/halo.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

constexpr int velocities = 6;

Eigen::Map<Vec3> triple(std::vector<double>& values, std::size_t k) { return Eigen::Map<Vec3>(&values[3*k]); }

void getVelocities(const Body& body, double* x)
{
    std::copy(body.v, body.v + 3, x);
    std::copy(body.s, body.s + 3, x + 3);
}

void setVelocities(Body& body, const double* x)
{
    std::copy(x, x + 3, body.v);
    std::copy(x + 3, x + 6, body.s);
}

void addVelocities(Body& body, const double* change)
{
    for (int k = 0; k < 3; ++k)
    {
        body.v[k] += change[k];
        body.s[k] += change[3 + k];
    }
}

} // namespace

Halo::Halo(Exchange& exchange, int ownBodies, std::size_t ghosts, std::vector<int> shared, const std::vector<int>& interfaceBodies)
:
    exchange_(&exchange),
    ownBodies_(ownBodies),
    ghosts_(ghosts),
    shared_(std::move(shared))
{
    std::vector<double> ranks(ownBodies, 0.0);
    for (int body : interfaceBodies) ranks[body] += 1.0;
    for (int body : shared_) ranks[body] += 1.0;
    for (int body : interfaceBodies)
    {
        if (ranks[body] > 1.0) copied_.push_back(body);
    }
    for (int body : shared_) toOthers_.push_back(ranks[body]);
    parts_.resize(ghosts_);
    exchange_->toGhosts(toOthers_, parts_, 1);
    for (int body : copied_) parts_.push_back(ranks[body]);
}

void Halo::giveBodies(std::vector<Body>& bodies)
{
    if (!exchange_) return;
    std::vector<double> mobility(2*shared_.size()), ghostMobility(2*ghosts_);
    for (std::size_t k = 0; k < shared_.size(); ++k)
    {
        mobility[2*k] = bodies[shared_[k]].invMass;
        mobility[2*k + 1] = bodies[shared_[k]].invSpin;
    }
    exchange_->toGhosts(mobility, ghostMobility, 2);
    for (std::size_t k = 0; k < parts_.size(); ++k)
    {
        const bool isCopy = k >= ghosts_;
        Body& body = bodies[ownBodies_ + k];
        body.invMass = parts_[k]*(isCopy ? bodies[copied_[k - ghosts_]].invMass : ghostMobility[2*k]);
        body.invSpin = parts_[k]*(isCopy ? bodies[copied_[k - ghosts_]].invSpin : ghostMobility[2*k + 1]);
    }
    giveVelocities(bodies);
}

void Halo::giveVelocities(std::vector<Body>& bodies)
{
    if (!exchange_) return;
    toOthers_.resize(velocities*shared_.size());
    for (std::size_t k = 0; k < shared_.size(); ++k) getVelocities(bodies[shared_[k]], &toOthers_[velocities*k]);
    given_.resize(velocities*ghosts_);
    exchange_->toGhosts(toOthers_, given_, velocities);
    given_.resize(velocities*parts_.size());
    for (std::size_t c = 0; c < copied_.size(); ++c) getVelocities(bodies[copied_[c]], &given_[velocities*(ghosts_ + c)]);
    for (std::size_t k = 0; k < parts_.size(); ++k) setVelocities(bodies[ownBodies_ + k], &given_[velocities*k]);
}

void Halo::takeVelocities(std::vector<Body>& bodies)
{
    if (!exchange_) return;
    fromOthers_.resize(velocities*parts_.size());
    for (std::size_t k = 0; k < parts_.size(); ++k)
    {
        double* change = &fromOthers_[velocities*k];
        getVelocities(bodies[ownBodies_ + k], change);
        for (int m = 0; m < velocities; ++m) change[m] = (change[m] - given_[velocities*k + m])/parts_[k];
    }
    for (std::size_t c = 0; c < copied_.size(); ++c) addVelocities(bodies[copied_[c]], &fromOthers_[velocities*(ghosts_ + c)]);
    fromOthers_.resize(velocities*ghosts_);
    toOthers_.resize(velocities*shared_.size());
    exchange_->toOwners(fromOthers_, toOthers_, velocities);
    for (std::size_t k = 0; k < shared_.size(); ++k) addVelocities(bodies[shared_[k]], &toOthers_[velocities*k]);
}

void Halo::give(std::vector<Vec3>& perBody) const
{
    if (!exchange_) return;
    toOthers_.resize(3*shared_.size());
    fromOthers_.resize(3*ghosts_);
    for (std::size_t k = 0; k < shared_.size(); ++k) triple(toOthers_, k) = perBody[shared_[k]];
    exchange_->toGhosts(toOthers_, fromOthers_, 3);
    for (std::size_t g = 0; g < ghosts_; ++g) perBody[ownBodies_ + g] = triple(fromOthers_, g);
    for (std::size_t c = 0; c < copied_.size(); ++c) perBody[firstCopy() + c] = perBody[copied_[c]];
}

void Halo::take(std::vector<Vec3>& perBody) const
{
    if (!exchange_) return;
    fromOthers_.resize(3*ghosts_);
    toOthers_.resize(3*shared_.size());
    for (std::size_t g = 0; g < ghosts_; ++g) triple(fromOthers_, g) = perBody[ownBodies_ + g];
    exchange_->toOwners(fromOthers_, toOthers_, 3);
    for (std::size_t c = 0; c < copied_.size(); ++c) perBody[copied_[c]] += perBody[firstCopy() + c];
    for (std::size_t k = 0; k < shared_.size(); ++k) perBody[shared_[k]] += triple(toOthers_, k);
}

void Halo::takeChanges(std::vector<Vec3>& perBody, const std::vector<Vec3>& given) const
{
    for (std::size_t k = 0; k < given.size(); ++k)
    {
        Vec3& x = perBody[ownBodies_ + k];
        x = (x - given[k])/parts_[k];
    }
    take(perBody);
}

void Halo::takeSmallest(std::vector<double>& perBody) const
{
    if (!exchange_) return;
    fromOthers_.assign(perBody.begin() + firstGhost(), perBody.begin() + firstCopy());
    toOthers_.resize(shared_.size());
    exchange_->toOwners(fromOthers_, toOthers_, 1);
    const auto take = [&](int body, double value) { perBody[body] = std::min(perBody[body], value); };
    for (std::size_t c = 0; c < copied_.size(); ++c) take(copied_[c], perBody[firstCopy() + c]);
    for (std::size_t k = 0; k < shared_.size(); ++k) take(shared_[k], toOthers_[k]);
}

void Halo::takeLargest(std::vector<double>& perBody) const
{
    if (!exchange_) return;
    const auto negate = [&] { std::transform(perBody.begin(), perBody.end(), perBody.begin(), [](double value) { return -value; }); };
    negate();
    takeSmallest(perBody);
    negate();
}

void Halo::giveFlags(std::vector<std::uint8_t>& perBody) const
{
    if (!exchange_) return;
    toOthers_.resize(shared_.size());
    fromOthers_.resize(ghosts_);
    for (std::size_t k = 0; k < shared_.size(); ++k) toOthers_[k] = perBody[shared_[k]];
    exchange_->toGhosts(toOthers_, fromOthers_, 1);
    for (std::size_t g = 0; g < ghosts_; ++g) perBody[ownBodies_ + g] = fromOthers_[g] != 0.0;
    for (std::size_t c = 0; c < copied_.size(); ++c) perBody[firstCopy() + c] = perBody[copied_[c]];
}

void Halo::takeFlags(std::vector<std::uint8_t>& perBody) const
{
    if (!exchange_) return;
    std::vector<double> values(perBody.begin(), perBody.end());
    takeLargest(values);
    std::transform(values.begin(), values.end(), perBody.begin(), [](double value) { return value > 0.0; });
}

double Halo::sum(double value) const
{
    sum(&value, 1);
    return value;
}

double Halo::max(double value) const
{
    max(&value, 1);
    return value;
}

} // namespace nscd
