// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Loose fillings and packings.
#include "nscd/tools/filling.hpp"

#include "nscd/search/pairSearch.hpp"
#include "nscd/tools/spreading.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace nscd
{

namespace
{

/// Amounts that are whole but for round-off count as whole.
constexpr double roundOff = 1e-9;

/// Solid fraction at which spheres find places at random within few tries, in narrow regions too. Of 0.1 to 0.25 all lead to 0.6 in 160 to 180 sweeps.
constexpr double startFraction = 0.1;

/// A packing at 0.6 takes 160 sweeps in a periodic box, at 0.62 1300.
constexpr int mostSweeps = 10000;

constexpr int mostRounds = 5;

/// Of the solid fraction that was asked for.
constexpr double toleranceOfFraction = 5e-3;

/// Points that a solid fraction is measured with: to 0.2 % of it.
constexpr int pointsOfMeasure = 200000;

/// In a smaller interior, what its surface cuts makes more than 1 %.
constexpr double fewestInside = 1000;

/// Distance from walls in mean diameters that packings lose there: in boxes of 20 to 60 diameters filled at 0.6.
constexpr double lostAtWalls = 0.16;

enum Stream : std::uint32_t { sizesOfGrains, places, points };

/// Independent numbers for each (seed, source, stream), the same on every machine.
RandomNumbers numbersFor(const FillingSource& source, const FillingPlace& place, Stream stream)
{
    std::seed_seq words{std::uint32_t(source.seed), std::uint32_t(source.seed >> 32), std::uint32_t(place.number), std::uint32_t(stream)};
    std::array<std::uint32_t, 2> mixed;
    words.generate(mixed.begin(), mixed.end());
    return randomNumbers((std::uint64_t(mixed[0]) << 32) | mixed[1]);
}

template<class... Parts>
std::invalid_argument refused(const Parts&... parts)
{
    std::ostringstream text;
    (text << ... << parts);
    return std::invalid_argument(text.str());
}

double volumeOf(const Spheres& grains, const GrainShape& shape)
{
    double sum = 0.0;
    for (const double radius : grains.radius) sum += shape.volume(radius);
    return sum;
}

class Filler
{
public:
    Filler(const FillingSource& source, const FillingPlace& place, const Spheres& others)
    :
        source_(source),
        place_(place),
        space_(source.region, place, source.sizes.largest)
    {
        for (std::size_t i = 0; i < others.size(); ++i) keepNear(space_.box().wrap(others.center[i]), others.radius[i]);
    }

    Filling loose() const
    {
        Filling filling;
        filling.grains.radius = drawRadii(source_.measure, source_.amount);
        addAll(filling.grains, "less, or for packing { solidFraction 0.6; }");
        return finished(filling);
    }

    Filling packed() const
    {
        Filling filling;
        const double asked = source_.amount*volumeOf(source_.region, place_.shape);
        const double share = clearShare(interiorDistance());
        const bool hasInterior = share*asked >= fewestInside*meanVolume();
        const double ofOthers = volumeOfOthers();
        double solid = asked*clearShare(hasInterior ? lostAtWalls*meanDiameter() : 0.0) - ofOthers;
        while (true)
        {
            pack(solid, filling);
            if (!hasInterior) break;
            filling.interiorFraction = measuredFraction(filling.grains);
            const double off = filling.interiorFraction/source_.amount - 1.0;
            if (std::abs(off) < toleranceOfFraction) break;
            if (filling.rounds == mostRounds) throw refused("has a solid fraction of ", filling.interiorFraction, " after ", mostRounds, " packings, not ", source_.amount);
            solid = (solid + ofOthers)/(1.0 + off) - ofOthers;
        }
        return finished(filling);
    }

private:
    void keepNear(const Vec3& center, double radius)
    {
        const double reach = radius + source_.sizes.largest;
        const auto& bounds = source_.region.bounds;
        for (int k = 0; k < 3; ++k)
        {
            if (space_.box().isPeriodic(k) || k == space_.emptyAxis()) continue;
            if (center[k] < bounds.min()[k] - reach || center[k] > bounds.max()[k] + reach) return;
        }
        others_.center.push_back(center);
        others_.radius.push_back(radius);
        if (space_.emptyAxis() >= 0) others_.center.back()[space_.emptyAxis()] = bounds.min()[space_.emptyAxis()];
    }

    std::vector<double> drawRadii(FillingAmount measure, double amount) const
    {
        if (measure == FillingAmount::solidFraction) return radiiOf(amount*volumeOf(source_.region, place_.shape), false);
        return radiiOf(measure == FillingAmount::mass ? amount/source_.density : amount, measure == FillingAmount::number);
    }

    /// As long as their number, or their volume [m3], does not exceed an amount.
    std::vector<double> radiiOf(double amount, bool isNumber) const
    {
        const RandomNumbers random = numbersFor(source_, place_, sizesOfGrains);
        std::vector<double> radii;
        double used = 0.0;
        while (true)
        {
            const double radius = 0.5*source_.sizes.draw(random);
            used += isNumber ? 1.0 : place_.shape.volume(radius);
            if (used > amount*(1.0 + roundOff)) break;
            radii.push_back(radius);
        }
        if (radii.empty()) throw refused("is not enough for one grain, the first of which has ", volumeOf(firstGrain(), place_.shape), " m3");
        return radii;
    }

    void addAll(Spheres& grains, const char* advice, double growth = 1.0) const
    {
        const std::size_t placed = addAtRandom(space_, others_, numbersFor(source_, place_, places), grains, growth);
        if (placed == grains.size()) return;
        const double fraction = volumeOf(grains, place_.shape)/volumeOf(source_.region, place_.shape);
        throw refused("asks for ", grains.size(), " grains, a solid fraction of ", fraction, ", and addition at random found places for ", placed, ": ask for ", advice);
    }

    /// A packing whose grains have a volume [m3].
    void pack(double solid, Filling& filling) const
    {
        Spheres& grains = filling.grains;
        grains.radius = radiiOf(solid, false);
        const std::vector<double> radius = grains.radius;
        const double scale = std::min(1.0, std::pow(startFraction/source_.amount, 1.0/place_.shape.dimensions));
        for (double& r : grains.radius) r *= scale;
        addAll(grains, "a lower solidFraction", (1.0 + 1e-3)/scale);
        grains.radius = radius;
        const SpreadReport report = spreadApart(space_, others_, mostSweeps, grains);
        filling.sweeps += report.sweeps;
        ++filling.rounds;
        if (report.isDone) return;
        throw refused("was not reached: grains of a solid fraction of ", volumeOf(grains, place_.shape)/volumeOf(source_.region, place_.shape),
            " of the region still overlap by ", report.overlap, " d after ", report.sweeps, " sweeps");
    }

    /// In the region, by their centers [m3].
    double volumeOfOthers() const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < others_.size(); ++i)
        {
            const bool isInside = source_.region.bounds.contains(others_.center[i]) && source_.region.holds(others_.center[i]);
            if (isInside) sum += place_.shape.volume(others_.radius[i]);
        }
        return sum;
    }

    double interiorDistance() const { return 2.0*source_.sizes.largest; }

    double meanVolume() const { return volumeOf(someSizes(), place_.shape)/someSizes().radius.size(); }

    double meanDiameter() const
    {
        double sum = 0.0;
        for (const double radius : someSizes().radius) sum += 2.0*radius;
        return sum/someSizes().radius.size();
    }

    Spheres someSizes() const { return {{}, radiiOf(1000, true)}; }
    Spheres firstGrain() const { return {{}, radiiOf(1, true)}; }

    /// Calls visit(x, isClear) for points drawn in the region.
    template<class Visit>
    void forPoints(double distance, const Visit& visit) const
    {
        const RandomNumbers random = numbersFor(source_, place_, points);
        for (int k = 0; k < pointsOfMeasure; ++k)
        {
            const Vec3 x = randomPoint(source_.region, random);
            visit(x, space_.isClear(x, distance));
        }
    }

    /// Of the region, the share that is farther from its sides and from walls than a distance [m].
    double clearShare(double distance) const
    {
        int clear = 0;
        forPoints(distance, [&](const Vec3&, bool isClear) { clear += isClear; });
        return clear/double(pointsOfMeasure);
    }

    /// Of the interior.
    double measuredFraction(Spheres grains) const
    {
        grains.center.insert(grains.center.end(), others_.center.begin(), others_.center.end());
        grains.radius.insert(grains.radius.end(), others_.radius.begin(), others_.radius.end());
        PairSearch search;
        search.fill(grains.center, grains.radius, space_.box());
        int clear = 0, solid = 0;
        forPoints(interiorDistance(), [&](const Vec3& x, bool isClear)
        {
            if (!isClear) return;
            ++clear;
            solid += !search.around(x, 0.0, space_.box()).empty();
        });
        return solid/double(std::max(1, clear));
    }

    Filling finished(Filling filling) const
    {
        filling.solidFraction = volumeOf(filling.grains, place_.shape)/volumeOf(source_.region, place_.shape);
        for (Vec3& center : filling.grains.center) center = place_.box.wrap(center);
        return filling;
    }

    const FillingSource& source_;
    const FillingPlace& place_;
    FillingSpace space_;
    Spheres others_;
};

} // namespace

Filling fill(const FillingSource& source, const FillingPlace& place, const Spheres& others)
{
    const Filler filler(source, place, others);
    return source.isPacked ? filler.packed() : filler.loose();
}

} // namespace nscd
