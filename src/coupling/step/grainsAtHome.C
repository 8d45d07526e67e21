// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Packing values of grains into rows of numbers, and back.
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

std::size_t widthOf(const GrainValues& values) { return values.scalars.size() + 3*values.vectors.size(); }

/// All values of a grain side by side.
std::vector<double> packed(const GrainValues& values, std::size_t grains)
{
    std::vector<double> rows;
    rows.reserve(grains*widthOf(values));
    for (std::size_t i = 0; i < grains; ++i)
    {
        for (const std::vector<scalar>* field : values.scalars) rows.push_back((*field)[i]);
        for (const std::vector<Vec3>* field : values.vectors) rows.insert(rows.end(), (*field)[i].data(), (*field)[i].data() + 3);
    }
    return rows;
}

void unpack(const std::vector<double>& rows, const GrainValues& values)
{
    const std::size_t grains = rows.size()/widthOf(values);
    for (std::vector<scalar>* field : values.scalars) field->resize(grains);
    for (std::vector<Vec3>* field : values.vectors) field->resize(grains);
    const double* from = rows.data();
    for (std::size_t i = 0; i < grains; ++i)
    {
        for (std::vector<scalar>* field : values.scalars) (*field)[i] = *from++;
        for (std::vector<Vec3>* field : values.vectors)
        {
            (*field)[i] = Vec3(from);
            from += 3;
        }
    }
}

/// The first field tells how many grains there are.
std::size_t grainsOf(const GrainValues& values)
{
    return values.scalars.empty() ? values.vectors.front()->size() : values.scalars.front()->size();
}

} // namespace

GrainsAtHome::GrainsAtHome() = default;
GrainsAtHome::GrainsAtHome(GrainsAtHome&&) = default;
GrainsAtHome::~GrainsAtHome() = default;

GrainsAtHome::GrainsAtHome(const ::nscd::RankTree& tree)
:
    link_(std::make_unique<::nscd::GrainLink>(tree.all()))
{}

void GrainsAtHome::update(const ::nscd::Grains& own, const std::vector<CellHome>& homes)
{
    std::vector<int> ranks;
    std::vector<scalar> cell;
    for (const CellHome& home : homes)
    {
        ranks.push_back(home.rank);
        cell.push_back(home.cell);
    }
    link_->connect(ranks);

    std::vector<scalar> radius = own.radius;
    // Identities are below 2^53, and travel as numbers.
    std::vector<scalar> id(own.id.begin(), own.id.end());
    std::vector<Vec3> position = own.position;
    toHomes({{&radius, &id, &cell}, {&position}});

    grains_ = ::nscd::Grains();
    grains_.shape = own.shape;
    constexpr double noDensity = 1.0;
    for (std::size_t i = 0; i < radius.size(); ++i) grains_.add(position[i], radius[i], noDensity, 0, std::int64_t(id[i]));
    cells_.assign(cell.begin(), cell.end());
}

void GrainsAtHome::toHomes(const GrainValues& values) const
{
    if (link_) unpack(link_->toHomes(packed(values, grainsOf(values)), int(widthOf(values))), values);
}

void GrainsAtHome::toOwners(const GrainValues& values) const
{
    if (link_) unpack(link_->toOwners(packed(values, link_->rows()), int(widthOf(values))), values);
}

} // namespace nscdCoupling
} // namespace Foam
