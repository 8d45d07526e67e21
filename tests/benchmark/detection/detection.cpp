// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What finding contacts costs a grain and build: sort, search, batches, list, geometry and impulses of a whole rebuild. CSV.
// detection SCENE [BED [TILESX TILESY]]: bed (a file as `rankedBed settle` wrote it, tiled), lattice, ratio20, ratio100.
#include "benchmark/rankedBed/tiledBed.hpp"

#include "nscd/base/mortonOrder.hpp"
#include "nscd/contacts/contactCandidates.hpp"
#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/contacts/storedImpulses.hpp"
#include "nscd/search/pairSearch.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace scenes;

namespace
{

constexpr int fewestTries = 5;
constexpr double secondsOfTries = 1.0;

/// Seconds of the processor, which other programs change less than those of the clock.
double now() { return static_cast<double>(std::clock())/CLOCKS_PER_SEC; }

/// Shortest time of some calls [s].
template<class Work>
double shortest(const Work& work)
{
    double best = 1e30, spent = 0.0;
    for (int k = 0; k < fewestTries || spent < secondsOfTries; ++k)
    {
        const double start = now();
        work();
        const double seconds = now() - start;
        best = std::min(best, seconds);
        spent += seconds;
    }
    return best;
}

/// A hundredth, by volume of their boxes, of a loose lattice is replaced by grains `ratio` times as large.
Scene twoSizes(int ratio, int perSide)
{
    Scene scene = emptyBed(2.2*radius*perSide, 2.2*radius*perSide);
    const double wide = 2.2*radius*ratio;
    const int boxes = std::max(1, static_cast<int>(0.1*perSide/ratio));
    const Scene small = latticeBed(perSide, perSide);
    const auto isInBox = [&](const Vec3& x)
    {
        for (int k = 0; k < 3; ++k)
        {
            if (x[k] > boxes*wide) return false;
        }
        return true;
    };
    for (std::size_t i = 0; i < small.grains.size(); ++i)
    {
        if (!isInBox(small.grains.position[i])) scene.addGrain(small.grains.position[i], radius, density);
    }
    for (int k = 0; k < boxes*boxes*boxes; ++k)
    {
        scene.addGrain(wide*Vec3(k % boxes + 0.5, k/boxes % boxes + 0.5, k/boxes/boxes + 0.5), ratio*radius, density);
    }
    return scene;
}

/// Grains in the order of their making lie in the order of space; a run shuffles them only slowly, so that is kept.
struct Rebuild
{
    Scene scene;
    nscd::Exchange serial;
    nscd::WallSearch wallSearch;
    double diameter = 0.0;
    std::vector<double> reach;

    explicit Rebuild(Scene made)
    :
        scene(std::move(made)),
        wallSearch(scene.walls, 4.0**std::max_element(scene.grains.radius.begin(), scene.grains.radius.end()))
    {
        for (double r : scene.grains.radius) diameter += 2.0*r/scene.grains.size();
        reach.assign(scene.grains.size(), 0.5*nscd::ContactSettings().skin*diameter);
    }

    nscd::Scene parts() const { return {scene.grains, scene.materials, scene.walls, scene.box}; }
    nscd::ContactList list(nscd::ContactList old = {})
    {
        return nscd::buildContactList(parts(), wallSearch, reach, {}, diameter, serial, std::move(old));
    }
};

/// An impulse in every closed slot, so that there is something to carry over.
void load(nscd::ContactList& list)
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (list.isUsed(slot) && list.gap[slot] < 0.01*radius) nscd::setImpulse(list, slot, nscd::normal(list, slot));
    }
}

void measure(const char* name, Rebuild rebuild)
{
    const nscd::Grains& grains = rebuild.scene.grains;
    const double perGrain = 1e9/static_cast<double>(grains.size());
    nscd::ContactList list = rebuild.list();
    nscd::updateGeometry(list, rebuild.parts());
    load(list);

    std::vector<double> size(grains.size());
    for (int body = 0; body < list.owned(); ++body) size[body] = list.radius[body] + list.reach[body];
    const double largest = *std::max_element(grains.radius.begin(), grains.radius.end());
    const double sort = shortest([&]() { nscd::mortonOrder(grains.position, rebuild.diameter); });
    const double search = shortest([&]() { list.search.find(list.position, size, rebuild.scene.box, largest); });
    const nscd::Candidates found = nscd::findCandidates(list, {}, 0, rebuild.parts(), rebuild.wallSearch, {});
    std::vector<nscd::Candidate> candidates = found.inner;
    for (nscd::Candidate& c : candidates)
    {
        if (c.b < 0) c.b = list.staticBody();
    }
    const double batches = shortest([&]() { nscd::batchNearAndFar(list, rebuild.parts(), candidates, rebuild.diameter); });
    nscd::ContactList other = rebuild.list();
    const double build = shortest([&]() { other = rebuild.list(std::move(other)); });
    const double geometry = shortest([&]() { nscd::updateGeometry(list, rebuild.parts()); });
    const double impulses = shortest([&]() { nscd::assignImpulses(list, nscd::collectImpulses(list), rebuild.serial); });
    std::printf("%s,%zu,%zu,%.3f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f\n", name, grains.size(), list.candidates,
                static_cast<double>(list.candidates)/static_cast<double>(list.slots()), perGrain*sort, perGrain*search, perGrain*batches,
                perGrain*build, perGrain*geometry, perGrain*impulses, perGrain*(build + geometry + impulses));
    std::fflush(stdout);
}

int usage()
{
    std::printf("detection bed FILE [TILESX TILESY] | lattice [PERSIDE] | ratio20 [PERSIDE] | ratio100 [PERSIDE]\n");
    return 1;
}

} // namespace

int main(int argc, char** argv)
{
    const std::string what = argc > 1 ? argv[1] : "";
    if (what.empty() || (what == "bed" && argc < 3)) return usage();
    const auto number = [=](int k, int otherwise) { return argc > k ? std::atoi(argv[k]) : otherwise; };
    std::printf("scene,grains,candidates,fill,sortNs,searchNs,batchesNs,buildNs,geometryNs,impulsesNs,wholeNs\n");
    if (what == "bed")
    {
        const TiledBed tiles(argv[2], number(3, 1), number(4, 1));
        measure("bed", Rebuild(tiles.part(0, tiles.size())));
    }
    else if (what == "lattice") measure("lattice", Rebuild(latticeBed(number(2, 100), number(2, 100))));
    else if (what == "ratio20") measure("1:20", Rebuild(twoSizes(20, number(2, 100))));
    else if (what == "ratio100") measure("1:100", Rebuild(twoSizes(100, number(2, 120))));
    else return usage();
}
