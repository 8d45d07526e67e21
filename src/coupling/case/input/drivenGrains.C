// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading driven grains, and moving them.
#include "coupling/case/input/drivenGrains.H"
#include "coupling/case/input/functionReader.H"

#include <algorithm>
#include <set>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Ascending.
std::vector<std::int64_t> readIds(const CheckedDict& given)
{
    if (!given.found("ids")) given.reject("ids", "is missing", "ids of grains, as (0 1 2)");
    const labelList list(given.dict().lookup("ids"));
    std::vector<std::int64_t> ids(list.begin(), list.end());
    std::sort(ids.begin(), ids.end());
    if (std::adjacent_find(ids.begin(), ids.end()) != ids.end()) given.reject("ids", "names a grain twice");
    return ids;
}

DrivenGroup readGroup(const dictionary& dict)
{
    const CheckedDict given(dict);
    DrivenGroup group;
    group.place = placeOf(dict);
    group.grains.ids = readIds(given);
    group.grains.velocity = readVectorFunction(given, "velocity");
    if (given.found("omega")) group.grains.omega = readVectorFunction(given, "omega");
    given.finish();
    return group;
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
        for (const std::int64_t id : groups.back().grains.ids)
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
        double found = double(nscd::hold(group.grains, grains));
        exchange.sum(&found, 1);
        const double named = double(group.grains.ids.size());
        if (found == named || mayHaveLeft) continue;
        fail
        ({
            group.place, "names grains by ids that are not there", Foam::name(label(named - found)) + " of its ids",
            "0 to one less than the number of grains, in the order of the sources"
        });
    }
}


void driveGrains(const std::vector<DrivenGroup>& groups, nscd::GrainDynamics& dynamics, scalar from, scalar to)
{
    for (const DrivenGroup& group : groups)
    {
        try
        {
            nscd::drive(group.grains, dynamics, from, to);
        }
        catch (const std::invalid_argument& error)
        {
            fail({group.place, "cannot be followed: " + string(error.what())});
        }
    }
}

} // namespace nscdCoupling
} // namespace Foam
