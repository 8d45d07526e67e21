// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading driven grains, and moving them.
#include "drivenGrains.H"
#include "vectorConversion.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

std::shared_ptr<const Function1<vector>> readFunction(const CheckedDict& given, const word& keyword)
{
    // Functions of OpenFOAM may keep their numbers beside themselves.
    given.found(keyword + "Coeffs");
    return std::shared_ptr<const Function1<vector>>(Function1<vector>::New(keyword, given.dict()).release());
}

std::set<std::int64_t> readIds(const CheckedDict& given)
{
    if (!given.found("ids")) given.reject("ids", "is missing", "ids of grains, as (0 1 2)");
    const labelList list(given.dict().lookup("ids"));
    const std::set<std::int64_t> ids(list.begin(), list.end());
    if (label(ids.size()) != list.size()) given.reject("ids", "names a grain twice");
    return ids;
}

DrivenGroup readGroup(const dictionary& dict)
{
    const CheckedDict given(dict);
    DrivenGroup group;
    group.place = placeOf(dict);
    group.ids = readIds(given);
    if (!given.found("velocity")) given.reject("velocity", "is missing", "a velocity as (0 0 -0.1), or a Function1 of time");
    group.velocity = readFunction(given, "velocity");
    if (given.found("omega")) group.omega = readFunction(given, "omega");
    given.finish();
    return group;
}

nscd::Vec3 meanOf(const Function1<vector>& f, scalar from, scalar to)
{
    const scalar middle = 0.5*(from + to), offset = 0.5*(to - from)/std::sqrt(3.0);
    return toVec3(0.5*(f.value(middle - offset) + f.value(middle + offset)));
}

void checkPlanar(const DrivenGroup& group, const nscd::Vec3& velocity, const nscd::Vec3& omega, label emptyAxis)
{
    if (emptyAxis < 0) return;
    nscd::Vec3 inPlane = omega;
    inPlane[emptyAxis] = 0;
    if (velocity[emptyAxis] == 0 && inPlane.norm() == 0) return;
    fail({group.place, "moves grains out of the plane of a 2D case by its velocity or omega"});
}

} // namespace


std::vector<DrivenGroup> readDriven(const CheckedDict& top)
{
    std::vector<DrivenGroup> groups;
    std::set<std::int64_t> seen;
    const dictionary dict = top.subOrEmpty("driven");
    const CheckedDict named(dict);
    for (const entry& given : dict)
    {
        groups.push_back(readGroup(named.sub(given.keyword())));
        for (const std::int64_t id : groups.back().ids)
        {
            if (seen.insert(id).second) continue;
            fail({groups.back().place, "drives a grain that another group drives too", Foam::name(label(id))});
        }
    }
    return groups;
}


void holdDriven
(
    const std::vector<DrivenGroup>& groups, nscd::Grains& grains, const nscd::Exchange& exchange, bool mayHaveLeft
)
{
    for (const DrivenGroup& group : groups)
    {
        double found = 0;
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            if (group.ids.count(grains.id[i]) == 0) continue;
            grains.isFixed[i] = 1;
            found += 1;
        }
        exchange.sum(&found, 1);
        if (found == double(group.ids.size()) || mayHaveLeft) continue;
        fail
        ({
            group.place, "names grains by ids that are not there", Foam::name(label(group.ids.size() - found)) + " of its ids",
            "0 to one less than the number of grains, in the order of the sources"
        });
    }
}


void driveGrains(const std::vector<DrivenGroup>& groups, nscd::GrainDynamics& dynamics, scalar from, scalar to, label emptyAxis)
{
    const nscd::Vec3 none = nscd::Vec3::Zero();
    for (const DrivenGroup& group : groups)
    {
        const nscd::Vec3 velocity = meanOf(*group.velocity, from, to);
        const nscd::Vec3 omega = group.omega ? meanOf(*group.omega, from, to) : none;
        checkPlanar(group, velocity, omega, emptyAxis);
        for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
        {
            if (group.ids.count(dynamics.grains().id[i]) > 0) dynamics.drive(i, velocity, omega);
        }
    }
}

} // namespace nscdCoupling
} // namespace Foam
