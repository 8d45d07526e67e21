// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Checks before the first step.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/dictionaryCheck.H"
#include "coupling/case/start/initialChecks.H"
#include "coupling/case/walls/grainExits.H"

#include "nscd/search/overlaps.hpp"

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

/// An overlap in words, as "grains 3 and 7 overlap by 0.2".
string describe(const Overlap& overlap, const nscd::Grains& grains, const nscd::Walls& walls)
{
    const label id = label(grains.id[overlap.grain]);
    const vector position = toFoam(grains.position[overlap.grain]);
    if (overlap.partner >= 0)
    {
        const label other = label(grains.id[overlap.partner]);
        if (overlap.isCoincident) return messageText("grains ", id, " and ", other, " have the same center ", position);
        return messageText("grains ", id, " and ", other, " overlap by ", overlap.share, " at ", position);
    }
    const std::string& wall = walls.patches[walls.regions[-1 - overlap.partner].patch].name;
    return messageText("grain ", id, " and the wall ", wall.c_str(), " overlap by ", overlap.share, " at ", position);
}

using DescribedOverlap = Tuple2<scalar, string>;

bool isWorse(const DescribedOverlap& a, const DescribedOverlap& b) { return a.first() > b.first(); }

/// The worst few of this rank's overlaps.
List<DescribedOverlap> worstHere(std::vector<Overlap>& overlaps, const nscd::Grains& grains, const nscd::Walls& walls)
{
    const std::size_t count = std::min<std::size_t>(5, overlaps.size());
    std::partial_sort
    (
        overlaps.begin(), overlaps.begin() + count, overlaps.end(),
        [](const Overlap& a, const Overlap& b) { return a.share > b.share; }
    );
    List<DescribedOverlap> worst;
    for (std::size_t k = 0; k < count; ++k) worst.append({overlaps[k].share, describe(overlaps[k], grains, walls)});
    return worst;
}

/// The worst few overlaps of all ranks in words. Collective.
string describeWorst(const List<DescribedOverlap>& here, label number)
{
    List<List<DescribedOverlap>> perRank(Pstream::nProcs());
    perRank[Pstream::myProcNo()] = here;
    Pstream::gatherList(perRank);
    Pstream::scatterList(perRank);
    std::vector<DescribedOverlap> worst;
    for (const List<DescribedOverlap>& list : perRank) worst.insert(worst.end(), list.begin(), list.end());
    std::stable_sort(worst.begin(), worst.end(), isWorse);

    const std::size_t count = std::min<std::size_t>(5, worst.size());
    string list;
    for (std::size_t k = 0; k < count; ++k) list += (k ? "; " : "") + worst[k].second();
    return number > label(count) ? list + "; ..." : list;
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

} // namespace


void checkTimeControls(const Time& time)
{
    const CheckedDict control(time.controlDict());
    control.number("deltaT", above(0), dimTime);
    if (control.found("writeInterval")) control.number("writeInterval", above(0), dimTime);
    if (control.flag("adjustTimeStep", false))
    {
        control.number("maxCo", above(0), dimless, 1);
        control.number("maxDeltaT", above(0), dimTime, GREAT);
    }
    if (time.endTime().value() < time.value())
    {
        control.reject("endTime", "lies before the start time " + time.timeName(), "a later time");
    }
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


void checkPeriods(const nscd::PeriodicBox& box, const nscd::Grains& grains, const polyMesh& mesh)
{
    double diameter = grains.size() ? 2*(*std::max_element(grains.radius.begin(), grains.radius.end())) : 0.0;
    reduce(diameter, maxOp<scalar>());
    for (int k = 0; k < 3; ++k)
    {
        if (!box.isPeriodic(k) || box.length[k] > diameter) continue;
        fail
        ({
            placeInFile(mesh.boundaryMesh().objectPath(), "cyclic"), "makes a period shorter than a grain",
            messageText(box.length[k], " along ", word(vector::componentNames[k])),
            messageText("more than the largest diameter, ", diameter)
        });
    }
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
    std::vector<std::size_t> others;
    forAll(home, i)
    {
        if (home[i] != Pstream::myProcNo()) others.push_back(std::size_t(i));
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
    const nscd::Grains& grains, const nscd::PeriodicBox& box, const nscd::Walls& walls,
    scalar maxOverlap, const InputPlace& place, nscd::Exchange& exchange
)
{
    const std::vector<nscd::GhostGrain> ghosts = exchange.findGhosts(grains, std::vector<double>(grains.size(), 0.0), box);
    const nscd::Grains all = withGhosts(grains, ghosts);
    std::vector<Overlap> overlaps = grainOverlaps(all, box, maxOverlap);
    dropPairsOfOthers(overlaps, grains.size(), ghosts, exchange.rank());
    const std::vector<Overlap> withWalls = wallOverlaps(grains, walls, maxOverlap);
    overlaps.insert(overlaps.end(), withWalls.begin(), withWalls.end());
    const label number = returnReduce(label(overlaps.size()), sumOp<label>());
    if (number == 0) return;
    fail
    ({
        place, messageText("is exceeded by ", number, " pairs"), describeWorst(worstHere(overlaps, all, walls), number),
        messageText("overlaps up to ", maxOverlap, " of the smaller diameter, distinct centers")
    });
}

} // namespace nscdCoupling
} // namespace Foam
