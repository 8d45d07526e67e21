// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Checks before the first step.
#include "initialChecks.H"
#include "dictionaryCheck.H"
#include "overlaps.H"
#include "vectorConversion.H"

#include "Time.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// One overlap in words, as "grains 3 and 7 overlap by 0.2".
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

/// The worst few overlaps in words.
string describeWorst(std::vector<Overlap>& overlaps, const nscd::Grains& grains, const nscd::Walls& walls)
{
    const std::size_t count = std::min<std::size_t>(5, overlaps.size());
    std::partial_sort
    (
        overlaps.begin(), overlaps.begin() + count, overlaps.end(),
        [](const Overlap& a, const Overlap& b) { return a.share > b.share; }
    );
    string list;
    for (std::size_t k = 0; k < count; ++k) list += (k ? "; " : "") + describe(overlaps[k], grains, walls);
    return overlaps.size() > count ? list + "; ..." : list;
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
        placeInDictionaryFile(time.path()/time.constant()/"g", "value"),
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
    if (grains.size() == 0) return;
    const double diameter = 2*(*std::max_element(grains.radius.begin(), grains.radius.end()));
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


void checkInsideMesh(const nscd::Grains& grains, const polyMesh& mesh)
{
    std::size_t outside = 0;
    string list;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const vector position = toFoam(grains.position[i]);
        if (mesh.cellTree().findInside(position) >= 0) continue;
        if (++outside <= 5) list += messageText(outside > 1 ? ", " : "", "grain ", label(grains.id[i]), " at ", position);
    }
    if (outside == 0) return;
    fail
    ({
        placeInDictionaryFile(mesh.time().path()/mesh.time().constant()/"grainProperties", "grains"),
        messageText("puts ", label(outside), " grains outside the mesh"), list,
        messageText("positions inside the mesh, bounded by ", mesh.bounds())
    });
}


void checkOverlaps
(
    const nscd::Grains& grains, const nscd::PeriodicBox& box, const nscd::Walls& walls,
    scalar maxOverlap, const InputPlace& place
)
{
    std::vector<Overlap> overlaps = grainOverlaps(grains, box, maxOverlap);
    const std::vector<Overlap> withWalls = wallOverlaps(grains, walls, maxOverlap);
    overlaps.insert(overlaps.end(), withWalls.begin(), withWalls.end());
    if (overlaps.empty()) return;
    fail
    ({
        place, messageText("is exceeded by ", label(overlaps.size()), " pairs"), describeWorst(overlaps, grains, walls),
        messageText("overlaps up to ", maxOverlap, " of the smaller diameter, distinct centers")
    });
}

} // namespace nscdCoupling
} // namespace Foam
