// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// New paths, who may meet on them, and what of that the list lacks.
#include "nscd/contacts/strays.hpp"

#include "nscd/contacts/contactCandidates.hpp"
#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/contacts/listBlocks.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>

namespace nscd
{

namespace
{

/// Share of the list's time that has gone.
double shareGone(const ContactList& list) { return list.path.empty() ? 0.0 : std::min(1.0, list.age/list.pathTime); }

/// From here on with the present velocity. Where no paths are expected it may go anywhere as fast.
void turn(ContactList& list, int body, double deltaT)
{
    const Vec3 v(list.bodies[body].v);
    if (list.path.empty())
    {
        list.positionAtBuild[body] = list.position[body];
        list.slack[body] = std::max(list.slack[body], (1.0 + 1e-9)*std::max(deltaT, list.pathTime - list.age)*v.norm());
        list.reach[body] = list.slack[body];
        return;
    }
    list.positionAtBuild[body] = list.position[body] - list.age*v;
    list.path[body] = list.pathTime*v;
    list.reach[body] = list.slack[body] + list.path[body].norm();
}

using PairKey = std::tuple<int, int, std::array<signed char, 3>>;

PairKey keyOf(const Candidate& pair) { return {pair.a, pair.b, pair.image}; }

/// By lower body first.
Candidate ordered(int a, int b, std::array<signed char, 3> image)
{
    if (a < b) return {a, b, -1, image};
    for (signed char& shift : image) shift = static_cast<signed char>(-shift);
    return {b, a, -1, image};
}

/// What the list has of some bodies.
struct Listed
{
    std::set<PairKey> pairs;
    std::vector<std::size_t> slotsOfPairs;   ///< ascending
    std::set<std::pair<int, int>> walls;   ///< body and wall region
};

Listed listedOf(const ContactList& list, const std::vector<char>& isAsked)
{
    Listed listed;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        const ContactBlock& block = list.blocks[slot/blockLanes];
        const int a = block.a[slot % blockLanes], b = block.b[slot % blockLanes];
        if (!isAsked[a] && !isAsked[b]) continue;
        if (list.wall[slot] >= 0) listed.walls.insert({a, list.wall[slot]});
        else
        {
            listed.pairs.insert(keyOf(ordered(a, b, list.image[slot])));
            listed.slotsOfPairs.push_back(slot);
        }
    }
    return listed;
}

/// What a body may reach on the rest of its path.
struct Sphere
{
    Vec3 center;
    double size;
};

Sphere restOfPath(const ContactList& list, int body, double range)
{
    const double size = list.radius[body] + range + list.slack[body];
    if (list.path.empty()) return {list.positionAtBuild[body], size};
    const double gone = shareGone(list);
    return {list.positionAtBuild[body] + 0.5*(1.0 + gone)*list.path[body], size + 0.5*(1.0 - gone)*list.path[body].norm()};
}

/// Spheres that the search holds, of this and of other ranks, are of paths less the mean of all.
double sizeForSearch(const Sphere& sphere, const ContactList& list) { return sphere.size + 0.5*list.meanPath.norm(); }

/// Whether all walls that a stray may reach are listed for it.
bool areWallsListed(const ContactList& list, int body, double range, const Listed& listed, const Scene& scene, const WallSearch& wallSearch)
{
    const Sphere sphere = restOfPath(list, body, range);
    std::vector<int> regions;
    for (const Vec3& place : placesOf(scene.box.wrap(sphere.center), sphere.size, scene.box)) wallSearch.find(place, sphere.size, regions);
    return std::all_of(regions.begin(), regions.end(), [&](int region) { return listed.walls.count({body, region}) > 0; });
}

/// Collects pairs that may meet and are not listed, until there are more than the list has room for.
class Lacking
{
public:
    Lacking(const ContactList& list, const Scene& scene, Listed& listed)
    :
        list_(list),
        scene_(scene),
        listed_(listed),
        range_(rangeOfLaws(scene.materials)),
        gone_(shareGone(list)),
        mostFound_((list.interfaceBlock - list.freeBlock)*blockLanes)
    {}

    bool isTooMuch() const { return found.size() > mostFound_; }

    /// `image`, `shift`: see movedBy.
    void add(int a, int b, const std::array<signed char, 3>& image, const Vec3& shift)
    {
        if (list_.inverseMass[a] == 0.0 && list_.inverseMass[b] == 0.0) return;
        const Candidate pair = ordered(a, b, movedBy(image, shift, scene_.box));
        if (mayMeet(list_, pair, scene_.box, range_, gone_) && listed_.pairs.insert(keyOf(pair)).second) found.push_back(pair);
    }

    std::vector<Candidate> found;

private:
    const ContactList& list_;
    const Scene& scene_;
    Listed& listed_;
    double range_, gone_;
    std::size_t mostFound_;
};

/// Pairs of strays with bodies that go as expected, which the list's search holds as they were when it was built.
void addWithOthers(ContactList& list, const std::vector<int>& strays, const std::vector<char>& isStray, const PeriodicBox& box, double range, Lacking& lacking)
{
    for (int body : strays)
    {
        if (lacking.isTooMuch()) return;
        const Sphere sphere = restOfPath(list, body, range);
        const Vec3 center = box.wrap(sphere.center);
        for (const BodyPair& pair : list.search.around(center, sizeForSearch(sphere, list), box))
        {
            if (isStray[pair.b]) continue;
            Vec3 middle = list.positionAtBuild[pair.b];
            if (!list.path.empty()) middle += 0.5*list.path[pair.b];
            lacking.add(body, pair.b, pair.image, box.wrap(middle) - middle - (center - sphere.center));
        }
    }
}

/// Pairs of which at least one is a new stray, the other a stray too.
void addAmongStrays(const ContactList& list, const std::vector<char>& isNew, const PeriodicBox& box, double range, Lacking& lacking)
{
    std::vector<Vec3> center, shift;
    std::vector<double> size;
    for (int body : list.strays)
    {
        const Sphere sphere = restOfPath(list, body, range);
        center.push_back(box.wrap(sphere.center));
        shift.push_back(center.back() - sphere.center);
        size.push_back(sphere.size);
    }
    PairSearch().findInPieces(center, size, box, 0.0, [&](const std::vector<BodyPair>& pairs)
    {
        for (const BodyPair& pair : pairs)
        {
            const int a = list.strays[pair.a], b = list.strays[pair.b];
            if (isNew[a] || isNew[b]) lacking.add(a, b, pair.image, shift[pair.b] - shift[pair.a]);
        }
        return !lacking.isTooMuch();
    });
}

/// Slots that were slow when the list was built may be fast now.
template<class Slot>
void addFastPairs(ContactList& list, const std::vector<Slot>& slots)
{
    std::vector<std::size_t> all;
    all.reserve(list.fastPairs.size() + slots.size());
    std::set_union(list.fastPairs.begin(), list.fastPairs.end(), slots.begin(), slots.end(), std::back_inserter(all));
    list.fastPairs = std::move(all);
}

/// Whether the searches along periodic axes, which know the nearest images, see all that a body may reach on the rest of its path.
bool isWithinPeriods(const Sphere& sphere, const PeriodicBox& box)
{
    bool isWithin = true;
    for (int axis = 0; axis < 3; ++axis) isWithin = isWithin && !(box.isPeriodic(axis) && 2.0*sphere.size > box.length[axis]);
    return isWithin;
}

bool addPairs(ContactList& list, const Scene& scene, const std::vector<Candidate>& candidates)
{
    std::vector<std::uint32_t> order(candidates.size());
    std::iota(order.begin(), order.end(), 0u);
    Batches batches = batchContacts(candidates, order, list.staticBody());
    const std::size_t first = list.freeBlock;
    if (first + batches.blocks > list.interfaceBlock) return false;
    writeCandidates(list, scene, materialOfBodies(list, scene), candidates, batches, first);
    list.freeBlock += batches.blocks;
    std::sort(batches.slotOf.begin(), batches.slotOf.end());
    addFastPairs(list, batches.slotOf);
    updatePairs(list, scene, first, list.freeBlock);
    return true;
}

} // namespace

std::vector<int> findStrays(const ContactList& list, double deltaT, std::size_t most)
{
    std::vector<int> strays;
    const double share = list.path.empty() ? 0.0 : std::min(1.0, (list.age + deltaT)/list.pathTime);
    for (int body = 0; body < list.owned() && strays.size() <= most; ++body)
    {
        Vec3 travel = list.position[body] - list.positionAtBuild[body] + deltaT*Vec3(list.bodies[body].v);
        if (share > 0.0) travel -= share*list.path[body];
        if (!(travel.squaredNorm() <= list.slack[body]*list.slack[body])) strays.push_back(body);
    }
    return strays;
}

bool isWithinTime(const ContactList& list, double deltaT) { return list.path.empty() || list.age + deltaT <= list.pathTime*(1.0 + 1e-9); }

bool followStrays
(
    ContactList& list, const std::vector<int>& strays, const Scene& scene, const WallSearch& wallSearch, const Exchange& exchange, double deltaT
)
{
    const double range = rangeOfLaws(scene.materials);
    for (int body : strays) turn(list, body, deltaT);
    list.strays.insert(list.strays.end(), strays.begin(), strays.end());
    std::sort(list.strays.begin(), list.strays.end());
    list.strays.erase(std::unique(list.strays.begin(), list.strays.end()), list.strays.end());

    std::vector<char> isNew(list.bodies.size(), 0), isStray(list.bodies.size(), 0);
    for (int body : strays) isNew[body] = 1;
    for (int body : list.strays) isStray[body] = 1;
    Listed listed = listedOf(list, isNew);
    for (int body : strays)
    {
        if (!Vec3(list.bodies[body].v).allFinite()) return false;
        const Sphere sphere = restOfPath(list, body, range);
        if (!isWithinPeriods(sphere, scene.box) || !exchange.isAwayFromOthers(scene.box.wrap(sphere.center), sizeForSearch(sphere, list))) return false;
        if (list.inverseMass[body] != 0.0 && !areWallsListed(list, body, range, listed, scene, wallSearch)) return false;
    }
    Lacking lacking(list, scene, listed);
    addWithOthers(list, strays, isStray, scene.box, range, lacking);
    addAmongStrays(list, isNew, scene.box, range, lacking);
    addFastPairs(list, listed.slotsOfPairs);
    return lacking.found.empty() || addPairs(list, scene, lacking.found);
}

bool doAnyTouch(const ContactList& list, const Scene& scene, std::size_t first, double deltaT)
{
    constexpr double near = 1e-3;   // in radii: what passes so near may be held to touch
    const double range = rangeOfLaws(scene.materials);
    for (std::size_t slot = first*blockLanes; slot < list.freeBlock*blockLanes; ++slot)
    {
        if (!list.isUsed(slot)) continue;
        const int a = list.blocks[slot/blockLanes].a[slot % blockLanes], b = list.blocks[slot/blockLanes].b[slot % blockLanes];
        Vec3 x = list.position[a] - list.position[b];
        for (int axis = 0; axis < 3; ++axis) x[axis] -= list.image[slot][axis]*scene.box.length[axis];
        const Vec3 way = deltaT*(Vec3(list.bodies[a].v) - Vec3(list.bodies[b].v));
        const double way2 = way.squaredNorm(), share = way2 > 0.0 ? std::clamp(-x.dot(way)/way2, 0.0, 1.0) : 0.0;
        if ((x + share*way).norm() < (1.0 + near)*(list.radius[a] + list.radius[b]) + 2.0*range) return true;
    }
    return false;
}

} // namespace nscd
