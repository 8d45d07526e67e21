// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Checks before the first step.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/start/initialChecks.H"
#include "coupling/case/walls/grainExits.H"

#include "input/dictionary/checkedEntries.hpp"
#include "input/scene/drivenReader.hpp"
#include "input/scene/materialReader.hpp"
#include "input/start/startChecks.hpp"

#include "PstreamReduceOps.H"
#include "Time.H"
#include "Tuple2.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using nscd::Overlap;

/// What a mesh's thickness is off by round-off of its points, over it.
constexpr scalar roundOff = 1e-9;

/// The worst few overlaps of each rank. Collective.
std::vector<input::DescribedOverlap> gathered(const std::vector<input::DescribedOverlap>& here)
{
    List<List<Tuple2<scalar, string>>> perRank(Pstream::nProcs());
    for (const input::DescribedOverlap& overlap : here) perRank[Pstream::myProcNo()].append({overlap.share, overlap.text});
    Pstream::gatherList(perRank);
    Pstream::scatterList(perRank);
    std::vector<input::DescribedOverlap> all;
    for (const auto& list : perRank)
    {
        for (const auto& overlap : list) all.push_back({overlap.first(), overlap.second()});
    }
    return all;
}

/// Own grains, and behind them those of other ranks that may touch one.
nscd::Grains withGhosts(const nscd::Grains& own, const std::vector<nscd::GhostGrain>& ghosts)
{
    nscd::Grains all = own;
    for (const nscd::GhostGrain& ghost : ghosts)
    {
        all.add(ghost.position, ghost.radius, 1.0, ghost.material, ghost.id);
        all.isFixed.back() = !(ghost.inverseMass > 0.0);
    }
    all.nOwned = own.size();
    return all;
}

/// Leaves pairs of two ranks to the lower one.
void dropPairsOfOthers(std::vector<Overlap>& overlaps, std::size_t nOwned, const std::vector<nscd::GhostGrain>& ghosts, int rank)
{
    const auto ownerOf = [&](long grain) { return grain < long(nOwned) ? rank : ghosts[grain - nOwned].owner; };
    const auto isOfOther = [&](const Overlap& overlap)
    {
        return std::min(ownerOf(long(overlap.grain)), ownerOf(overlap.partner)) < rank
            || (ownerOf(long(overlap.grain)) != rank && ownerOf(overlap.partner) != rank);
    };
    overlaps.erase(std::remove_if(overlaps.begin(), overlaps.end(), isOfOther), overlaps.end());
}

/// Refuses overlaps of more than maxShare. Collective.
void refuseOverlaps
(
    const nscd::Grains& grains, const nscd::PeriodicBox& box, const nscd::Walls& walls, const GrainProperties& properties, scalar maxShare,
    nscd::Exchange& exchange
)
{
    if (properties.letsFixedGo())
    {
        // Held ones may overlap, those that are free later may not.
        nscd::Grains later = grains;
        if (input::letGo(properties.driven, later)) return refuseOverlaps(later, box, walls, properties, maxShare, exchange);
    }
    const std::vector<nscd::GhostGrain> ghosts = exchange.findGhosts(grains, {std::vector<double>(grains.size(), 0.0)}, box);
    const nscd::Grains all = withGhosts(grains, ghosts);
    std::vector<Overlap> overlaps = grainOverlaps(all, box, maxShare);
    dropPairsOfOthers(overlaps, grains.size(), ghosts, exchange.rank());
    const std::vector<Overlap> withWalls = wallOverlaps(grains, walls, maxShare);
    overlaps.insert(overlaps.end(), withWalls.begin(), withWalls.end());
    const label number = returnReduce(label(overlaps.size()), sumOp<label>());
    if (number == 0) return;
    const std::vector<input::DescribedOverlap> worst = gathered(input::worstOverlaps(overlaps, all, walls));
    toldByFoam([&] { input::refuseOverlaps(std::size_t(number), worst, properties, maxShare); });
}

void refuseFarOutside(const nscd::Grains& grains, const polyMesh& mesh)
{
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const point x = toFoam(grains.position[i]);
        const vector beyond = max(mesh.bounds().min() - x, x - mesh.bounds().max());
        if (cmptMax(beyond) <= 2*grains.radius[i]) continue;
        const fileName file = mesh.time().timePath()/"lagrangian/grains/position";
        fail
        ({
            placeInFile(file, "position"), "puts a grain outside the mesh", messageText("grain ", label(grains.id[i]), " at ", x),
            messageText("positions inside the mesh, bounded by ", mesh.bounds())
        });
    }
}

void checkPeriods(const GrainProperties& properties, const nscd::PeriodicBox& box, const nscd::Grains& grains, const polyMesh& mesh)
{
    const double diameter = returnReduce(input::largestDiameter(properties, grains), maxOp<scalar>());
    toldByFoam([&] { input::checkPeriods(box, diameter, placeInFile(mesh.boundaryMesh().objectPath(), "cyclic")); });
}

void checkMaterials(const GrainProperties& properties, const GrainScene& scene, const nscd::Grains& grains, const nscd::Exchange& exchange)
{
    std::vector<double> isUsed(properties.materials.table.size(), 0.0);
    for (const int material : input::usedMaterials(properties, grains)) isUsed[material] = 1.0;
    exchange.max(isUsed.data(), int(isUsed.size()));
    std::vector<int> used;
    for (std::size_t material = 0; material < isUsed.size(); ++material)
    {
        if (isUsed[material] > 0.0) used.push_back(int(material));
    }
    toldByFoam([&] { input::checkPairs(properties.materials, used, scene.walls); });
}

void checkThickness(const GrainProperties& properties, const GrainSpace& space, const nscd::Grains& grains)
{
    const scalar diameter = returnReduce(input::largestDiameter(properties, grains), maxOp<scalar>());
    if (space.emptyAxis < 0 || space.shape.dimensions == 2 || diameter <= (1 + roundOff)*space.shape.thickness) return;
    fail
    ({
        properties.shapePlace, messageText("has spheres up to ", diameter, " m on a mesh ", space.shape.thickness, " m thick"), properties.shape,
        "disc, or a mesh at least as thick as the spheres"
    });
}

} // namespace


void checkTimeControls(const dictionary& controlDict)
{
    const input::Dictionary entries = valuesFromFoam(controlDict);
    const input::CheckedEntries control(entries);
    const input::Range duration = input::above(0, input::unit::time);
    toldByFoam([&]
    {
        control.refuseMisspelt({"deltaT", "endTime", "writeInterval", "adjustTimeStep", "maxCo", "maxDeltaT"});
        const scalar deltaT = control.number("deltaT", duration);
        const scalar end = control.number("endTime", input::anyNumber(input::unit::time), 0);
        if (end > 0 && deltaT > end) control.reject("deltaT", "is longer than all of the run", input::textOf("at most endTime, ", end));
        const scalar interval = control.number("writeInterval", duration, GREAT);
        const bool countsSteps = !control.found("writeControl") || control.text("writeControl") == "timeStep";
        if (!countsSteps && end/interval > labelMax)
        {
            control.reject("writeInterval", "makes more written times than can be counted", input::textOf("at least ", end/labelMax));
        }
        if (control.flag("adjustTimeStep", false))
        {
            control.number("maxCo", input::above(0), 1);
            control.number("maxDeltaT", duration, GREAT);
        }
    });
}


void checkTimeControls(const Time& time)
{
    checkTimeControls(time.controlDict());
    if (time.endTime().value() >= time.value()) return;
    fail
    ({
        placeOf(time.controlDict(), "endTime"), "lies before the start time " + time.timeName(), messageText(time.endTime().value()),
        "a later time"
    });
}


void checkGravity(const vector& gravity, const GrainSpace& space, const Time& time)
{
    if (space.emptyAxis < 0 || gravity[space.emptyAxis] == 0) return;
    fail
    ({
        placeInDictionaryFile(time.globalPath()/time.constant()/"g", "value"),
        "has a component along the empty direction of a 2D mesh", messageText(gravity),
        messageText("0 for component ", word(vector::componentNames[space.emptyAxis]))
    });
}


void checkMeanFlow(const GrainProperties& properties, const nscd::PeriodicBox& box)
{
    for (int k = 0; k < 3; ++k)
    {
        if (properties.meanFlow[k] == 0 || box.isPeriodic(k)) continue;
        fail
        ({
            properties.meanFlowPlace, "asks for a flow along a direction without cyclic patches",
            messageText(properties.meanFlow), messageText("0 for component ", word(vector::componentNames[k]))
        });
    }
}


void checkGrains
(
    const nscd::Grains& grains, const GrainScene& scene, const GrainProperties& properties, const polyMesh& mesh, const nscd::Exchange& exchange
)
{
    checkMaterials(properties, scene, grains, exchange);
    checkPeriods(properties, scene.box, grains, mesh);
    checkThickness(properties, scene.space, grains);
}


HomeRanks::HomeRanks(const polyMesh& mesh)
:
    mesh_(mesh)
{
    if (Pstream::parRun()) mesh_.tetBasePtIs();  // collective, and asked for by the search
}


void HomeRanks::keepOwn(nscd::Grains& grains)
{
    labelList home(label(grains.size()), labelMax);
    forAll(home, i)
    {
        if (mesh_.cellTree().findInside(toFoam(grains.position[i])) >= 0) home[i] = Pstream::myProcNo();
    }
    Pstream::listCombineGather(home, minEqOp<label>());
    Pstream::listCombineScatter(home);
    const std::vector<int> clumpOf = nscd::clumpOfGrains(grains);
    std::vector<std::size_t> others;
    forAll(home, i)
    {
        // Clumps stay whole.
        const bool isMember = !clumpOf.empty() && clumpOf[std::size_t(i)] >= 0;
        const label at = isMember ? home[grains.clumps.firstMember[clumpOf[std::size_t(i)]]] : home[i];
        if (at != Pstream::myProcNo()) others.push_back(std::size_t(i));
        if (home[i] != labelMax) continue;
        if (++outside_ > 5) continue;
        list_ += messageText(outside_ > 1 ? ", " : "", "grain ", label(grains.id[i]), " at ", toFoam(grains.position[i]));
    }
    eraseGrains(grains, others);
}


void HomeRanks::checkNoneOutside() const
{
    if (outside_ == 0) return;
    fail
    ({
        placeInDictionaryFile(mesh_.time().globalPath()/mesh_.time().constant()/"grainProperties", "grains"),
        messageText("puts ", outside_, " grains outside the mesh"), list_,
        messageText("positions inside the mesh, bounded by ", mesh_.bounds())
    });
}


void checkOverlaps
(
    const nscd::Grains& grains, const GrainScene& scene, const GrainProperties& properties, nscd::Exchange& exchange
)
{
    refuseOverlaps(grains, scene.box, scene.walls, properties, properties.maxInitialOverlap, exchange);
}


void checkRestart
(
    const nscd::Grains& grains, scalar time, const GrainScene& scene, const GrainProperties& properties, const polyMesh& mesh,
    nscd::Exchange& exchange
)
{
    checkGrains(grains, scene, properties, mesh, exchange);
    if (properties.solvesFluid) refuseFarOutside(grains, mesh);
    nscd::Walls walls = scene.walls;
    nscd::moveWalls(walls, time);
    refuseOverlaps(grains, scene.box, walls, properties, input::maxOverlapOfRestart(properties), exchange);
}

} // namespace nscdCoupling
} // namespace Foam
