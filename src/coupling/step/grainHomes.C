// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Asking ranks for the cells of grains.
#include "coupling/step/grainHomes.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/grainExits.H"
#include "coupling/mapping/mesh/cellLocator.H"
#include "coupling/mapping/mesh/nearestBorder.H"

#include "parallel/pointRouting.hpp"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Is a grain still there?
struct Question
{
    std::array<double, 3> position;
    label guess;
    label index;   ///< where it is owned
};

struct Answer
{
    label index;
    CellHome home;   ///< rank -1: not known here
};

::nscd::Vec3 vectorOf(const std::array<double, 3>& x) { return ::nscd::Vec3(x[0], x[1], x[2]); }

/// The part of the mesh, with room for round-off.
Eigen::AlignedBox3d boxOf(const polyMesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const point& x : mesh.points()) box.extend(toVec3(x));
    const scalar room = 1e-6*mesh.bounds().mag();
    if (!box.isEmpty())
    {
        box.min().array() -= room;
        box.max().array() += room;
    }
    return box;
}

/// A mesh and what finds cells in it.
struct LocatedMesh
{
    explicit LocatedMesh(const fvMesh& mesh) : cells(makeMappingMesh(mesh)), locator(cells, mesh) {}

    MappingMesh cells;
    CellLocator locator;
};

} // namespace

FindHome findHomeIn(const fvMesh& mesh)
{
    const auto located = std::make_shared<const LocatedMesh>(mesh);
    return [located](const ::nscd::Vec3& position, label guess) { return located->cells.home(located->locator.findInCells(position, guess)); };
}

GrainHomes::GrainHomes(const polyMesh& mesh, const ::nscd::RankTree& tree, FindHome find)
:
    mesh_(mesh),
    box_(boxOf(mesh)),
    tree_(tree),
    find_(std::move(find)),
    hasHalves_(slidesInHalves(mesh))
{}

void GrainHomes::followMesh(FindHome find)
{
    box_ = boxOf(mesh_);
    find_ = std::move(find);
}

void GrainHomes::askLastHomes(const ::nscd::Grains& grains)
{
    const ::nscd::Communicator& all = tree_.all();
    std::vector<Question> questions;
    std::vector<int> homes;
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        if (homes_[i].rank < 0) continue;
        const ::nscd::Vec3& x = grains.position[i];
        questions.push_back({{x[0], x[1], x[2]}, homes_[i].cell, label(i)});
        homes.push_back(homes_[i].rank);
    }
    std::vector<Answer> answers;
    std::vector<int> askers;
    for (const ::nscd::Message& message : all.exchange(::nscd::messagesByRank(questions, homes)))
    {
        std::vector<Question> asked;
        ::nscd::unpack(message.bytes, asked);
        for (const Question& question : asked)
        {
            answers.push_back({question.index, find_(vectorOf(question.position), question.guess)});
            askers.push_back(message.rank);
        }
    }
    for (const Answer& answer : ::nscd::valuesOf<Answer>(all.exchange(::nscd::messagesByRank(answers, askers))))
    {
        homes_[answer.index] = answer.home;
    }
}

void GrainHomes::listAstray(const ::nscd::Grains& grains, std::vector<::nscd::Vec3>& positions, std::vector<std::size_t>& grainOf) const
{
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        if (homes_[i].rank >= 0) continue;
        positions.push_back(grains.position[i]);
        grainOf.push_back(i);
    }
}

void GrainHomes::askAround(const ::nscd::Grains& grains)
{
    std::vector<::nscd::Vec3> astray;
    std::vector<std::size_t> grainOf;
    listAstray(grains, astray, grainOf);
    std::vector<Answer> answers;
    std::vector<int> askers;
    for (const ::nscd::RoutedPoint& asked : ::nscd::routePoints(tree_, astray, box_))
    {
        const CellHome home = find_(vectorOf(asked.position), -1);
        if (home.rank < 0) continue;
        answers.push_back({asked.index, home});
        askers.push_back(asked.origin);
    }
    // Messages come by ascending rank: the first to claim a grain is the lowest.
    for (const ::nscd::Message& message : tree_.all().exchange(::nscd::messagesByRank(answers, askers)))
    {
        std::vector<Answer> found;
        ::nscd::unpack(message.bytes, found);
        for (const Answer& answer : found)
        {
            CellHome& home = homes_[grainOf[answer.index]];
            if (home.rank < 0) home = answer.home;
        }
    }
}

// Between the halves of a mesh that slide past each other are slivers without cells: who has the nearest face there has the grain, if no other
// border of the mesh is nearer.
void GrainHomes::askBetweenHalves(const ::nscd::Grains& grains)
{
    if (!hasHalves_) return;
    std::vector<::nscd::Vec3> astray;
    std::vector<std::size_t> grainOf;
    listAstray(grains, astray, grainOf);
    scalar any = scalar(astray.size());
    tree_.all().sum(&any, 1);
    if (any == 0) return;
    const std::vector<BorderOfRanks> nearest = nearestBorders(mesh_, astray, tree_);
    for (std::size_t k = 0; k < nearest.size(); ++k)
    {
        const BorderOfRanks& border = nearest[k];
        if (border.patch >= 0 && isBetweenHalves(mesh_.boundaryMesh()[border.patch])) homes_[grainOf[k]] = {border.rank, border.cell};
    }
}

const std::vector<CellHome>& GrainHomes::update(const ::nscd::Grains& grains, const bool isMeshAhead)
{
    homes_.resize(grains.nOwned);
    const std::vector<CellHome> last = isMeshAhead ? homes_ : std::vector<CellHome>();
    askLastHomes(grains);
    askAround(grains);
    askBetweenHalves(grains);
    for (std::size_t i = 0; i < last.size(); ++i)
    {
        if (homes_[i].rank < 0) homes_[i] = last[i];
    }
    return homes_;
}

void GrainHomes::erase(const std::vector<std::size_t>& indices)
{
    eraseAt(homes_, indices);
}

void GrainHomes::correct(const std::vector<scalar>& rank, const std::vector<scalar>& cell, const MappedBodies& bodies)
{
    for (std::size_t i = 0; i < homes_.size(); ++i)
    {
        if (homes_[i].rank >= 0 && (bodies.empty() || bodies.isFirst(i))) homes_[i] = {int(rank[i]), label(cell[i])};
    }
}

} // namespace nscdCoupling
} // namespace Foam
