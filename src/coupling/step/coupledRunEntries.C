// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a run does beside the seven parts where grains enter.
// Tested by tests/foam/program/entryTest.C
#include "coupling/step/coupledRun.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/files/entryNumbers.H"
#include "coupling/case/log/grainTotals.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Points of a region that are looked for in the mesh, of which one has to be there.
constexpr int pointsOfRegion = 2000;

} // namespace

scalar CoupledRun::meanDiameterOf(const RunNumbers& numbers) const
{
    const auto written = numbers.find("meanDiameter");
    if (written != numbers.end()) return written->second;
    if (hasGrains()) return sumGrains(dynamics_->grains(), *ranks_.exchange()).diameterMean;
    scalar sum = 0;
    for (const ::nscd::EntrySource& source : properties_.entries) sum += 0.5*(source.sizes.smallest + source.sizes.largest);
    return properties_.hasEntries() ? sum/scalar(properties_.entries.size()) : 0;
}

int CoupledRun::rankOf(const Vec3& position) const
{
    if (homes_) return homes_->find(position).rank;
    if (hasFluid()) return immersion_->mapping->find(position, -1).rank;
    return locations_->find(position) < 0 ? -1 : 0;
}

void CoupledRun::checkRegions() const
{
    for (std::size_t s = 0; s < properties_.entries.size(); ++s)
    {
        const ::nscd::EntryRegion& region = properties_.entries[s].region;
        if (!region.begin()) continue;
        const ::nscd::RandomNumbers random = ::nscd::randomNumbers(1);
        double isThere = 0;
        for (int k = 0; k < pointsOfRegion; ++k)
        {
            const ::nscd::EntryTry at = region.draw(random);
            if (region.holds(at) && rankOf(scene_.box.wrap(at.position)) >= 0) isThere = 1;
        }
        ranks_.exchange()->max(&isThere, 1);
        if (isThere > 0) continue;
        const string allowed = messageText("a region in the mesh, which is bounded by ", mesh_.bounds());
        fail({properties_.entryPlaces[s], "has no cell of the mesh", properties_.entries[s].name, allowed});
    }
}

void CoupledRun::startEntries(const RunNumbers& numbers)
{
    checkRegions();
    const ::nscd::EntrySpace space
    {
        scene_.space.shape, scene_.box, ranks_.exchange(), [this](const Vec3& position) { return rankOf(position); }
    };
    const std::int64_t nextId = nextIdentity(dynamics_->grains(), numbers, *ranks_.exchange());
    entry_ = std::make_unique<::nscd::GrainEntry>(properties_.entries, space, entryStates(properties_.entries, numbers), nextId);
}

void CoupledRun::letIn(scalar end)
{
    if (!entry_) return;
    const std::size_t before = dynamics_->grains().size();
    std::int64_t entered;
    {
        const auto timer = timing_.time(StepPart::advanceGrains);
        entered = entry_->enter(*dynamics_, end);
    }
    if (entered == 0) return;
    const auto timer = timing_.time(StepPart::depositGrains);
    bodies_.update(dynamics_->grains());
    memory_.enter(dynamics_->grains().size() - before);
    if (coarse_) coarse_->welcome(before, entry_->sourcesOfLast(), properties_.entries);
    if (heat_) heat_->welcome(dynamics_->grains());
    nGrains_ += entered;
    if (hasFluid()) updateWeights();
    takeFluidVelocity(before);
}

void CoupledRun::takeFluidVelocity(std::size_t first)
{
    const auto takes = [](const ::nscd::EntrySource& source) { return source.takesFluidVelocity; };
    if (std::none_of(properties_.entries.begin(), properties_.entries.end(), takes)) return;
    sampleAtGrains(reads::nothing);
    ::nscd::Grains grains = dynamics_->grains();
    const std::vector<std::size_t>& sources = entry_->sourcesOfLast();
    for (std::size_t k = 0; k < sources.size(); ++k)
    {
        if (takes(properties_.entries[sources[k]])) grains.velocity[first + k] = step_.at.velocity[bodies().size() - sources.size() + k];
    }
    dynamics_->setGrains(std::move(grains));
    bodies_.update(dynamics_->grains());
}

} // namespace nscdCoupling
} // namespace Foam
