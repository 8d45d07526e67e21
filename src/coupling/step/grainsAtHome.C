// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Values of grains as the columns that travel.
#include "coupling/step/grainsAtHome.H"

#include "parallel/grainLink.hpp"
#include "parallel/rankTree.hpp"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

static_assert(sizeof(Vec3) == 3*sizeof(double), "vectors travel as three numbers each");

/// Values of so many grains instead of those that they are made from.
class NewValues
{
public:
    NewValues(const GrainValues& values, std::size_t grains)
    :
        values_(values),
        scalars_(values.scalars.size()),
        vectors_(values.vectors.size())
    {
        for (std::vector<scalar>& field : scalars_) field.resize(grains);
        for (std::vector<Vec3>& field : vectors_) field.resize(grains);
    }

    std::vector<::nscd::GrainColumn> columns()
    {
        std::vector<::nscd::GrainColumn> columns;
        for (std::size_t k = 0; k < scalars_.size(); ++k)
        {
            columns.push_back({values_.scalars[k]->data(), values_.scalars[k]->size(), scalars_[k].data(), 1});
        }
        for (std::size_t k = 0; k < vectors_.size(); ++k)
        {
            const double* from = reinterpret_cast<const double*>(values_.vectors[k]->data());
            columns.push_back({from, values_.vectors[k]->size(), reinterpret_cast<double*>(vectors_[k].data()), 3});
        }
        return columns;
    }

    void replace()
    {
        for (std::size_t k = 0; k < scalars_.size(); ++k) *values_.scalars[k] = std::move(scalars_[k]);
        for (std::size_t k = 0; k < vectors_.size(); ++k) *values_.vectors[k] = std::move(vectors_[k]);
    }

private:
    const GrainValues& values_;
    std::vector<std::vector<scalar>> scalars_;
    std::vector<std::vector<Vec3>> vectors_;
};

/// Values of own grains, or of bodies, at their homes instead.
void send(const ::nscd::GrainLink& link, const GrainValues& values)
{
    NewValues atHome(values, link.rows());
    link.toHomes(atHome.columns());
    atHome.replace();
}

void sendBack(const ::nscd::GrainLink& link, const GrainValues& values)
{
    NewValues atOwners(values, link.grains());
    link.toOwners(atOwners.columns());
    atOwners.replace();
}

/// What a clump covers is no farther from the center of its first member [m].
scalar reachOfClumps(const ::nscd::Clumps& clumps)
{
    scalar reach = 0;
    for (const ::nscd::ClumpShape& shape : clumps.shapes)
    {
        for (const ::nscd::Ball& ball : shape.members) reach = std::max(reach, (ball.center - shape.members[0].center).norm() + ball.radius);
    }
    return reach;
}

/// Each grain a body.
MappedBodies singleBodies(const ::nscd::Grains& grains)
{
    MappedBodies bodies;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        bodies.bodyOf.push_back(label(i));
        bodies.volume.push_back(grains.volume(i));
    }
    bodies.share.assign(grains.size(), 1);
    return bodies;
}

} // namespace

GrainsAtHome::GrainsAtHome() = default;
GrainsAtHome::GrainsAtHome(GrainsAtHome&&) = default;
GrainsAtHome::~GrainsAtHome() = default;

GrainsAtHome::GrainsAtHome(const ::nscd::RankTree& tree)
:
    link_(std::make_unique<::nscd::GrainLink>(tree.all())),
    linkOfBodies_(std::make_unique<::nscd::GrainLink>(tree.all()))
{}

void GrainsAtHome::update(const ::nscd::Grains& own, const std::vector<CellHome>& homes, const MappedBodies& bodies)
{
    areBodies_ = !own.clumps.shapes.empty();
    const MappedBodies ofOwn = areBodies_ && bodies.empty() ? singleBodies(own) : bodies;
    std::vector<int> ranks, ranksOfBodies;
    std::vector<scalar> cell, isFirst, volume;
    for (std::size_t i = 0; i < homes.size(); ++i)
    {
        const bool isNew = !areBodies_ || ofOwn.isFirst(i);
        ranks.push_back(isNew ? homes[i].rank : ranks.back());
        // Parts in other ranks' cells are looked for from the first one's on.
        cell.push_back(homes[i].rank == ranks.back() ? homes[i].cell : cell.back());
        if (!areBodies_) continue;
        isFirst.push_back(isNew);
        volume.push_back(ofOwn.volume[ofOwn.bodyOf[i]]);
        if (isNew) ranksOfBodies.push_back(homes[i].rank);
    }
    link_->connect(ranks);

    std::vector<scalar> radius = own.radius, share = ofOwn.share;
    // Identities are below 2^53, and travel as numbers.
    std::vector<scalar> id(own.id.begin(), own.id.end());
    std::vector<Vec3> position = own.position;
    GrainValues values{{&radius, &id, &cell}, {&position}};
    if (areBodies_) values.scalars.insert(values.scalars.end(), {&isFirst, &share, &volume});
    send(*link_, values);

    grains_ = ::nscd::Grains();
    grains_.shape = own.shape;
    constexpr double noDensity = 1.0;
    for (std::size_t i = 0; i < radius.size(); ++i) grains_.add(position[i], radius[i], noDensity, 0, std::int64_t(id[i]));
    cells_.assign(cell.begin(), cell.end());
    bodies_ = MappedBodies();
    if (!areBodies_) return;
    linkOfBodies_->connect(ranksOfBodies);
    takeBodies(isFirst, std::move(share), volume);
    bodies_.reach = reachOfClumps(own.clumps);
}

void GrainsAtHome::takeBodies(const std::vector<scalar>& isFirst, std::vector<scalar> share, const std::vector<scalar>& volume)
{
    for (std::size_t i = 0; i < isFirst.size(); ++i)
    {
        if (isFirst[i] != 0) bodies_.volume.push_back(volume[i]);
        bodies_.bodyOf.push_back(label(bodies_.volume.size()) - 1);
    }
    bodies_.share = std::move(share);
}

void GrainsAtHome::toHomes(const GrainValues& values) const
{
    if (link_) send(areBodies_ ? *linkOfBodies_ : *link_, values);
}

void GrainsAtHome::toOwners(const GrainValues& values) const
{
    if (link_) sendBack(areBodies_ ? *linkOfBodies_ : *link_, values);
}

void GrainsAtHome::grainsToOwners(const GrainValues& values) const { sendBack(*link_, values); }

} // namespace nscdCoupling
} // namespace Foam
