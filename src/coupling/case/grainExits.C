// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finding and removing grains that left.
#include "grainExits.H"
#include "vectorConversion.H"

#include "emptyPolyPatch.H"

namespace Foam
{
namespace nscdCoupling
{

std::vector<std::size_t> findExited
(
    const nscd::Grains& grains, const labelUList& cells, const polyMesh& mesh, const PatchRoles& roles
)
{
    std::vector<std::size_t> exited;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (cells[i] >= 0) continue;
        const label patchi = nearestPatch(mesh, toFoam(grains.position[i]));
        if (patchi < 0 || roles.role[patchi] != PatchRole::exit)
        {
            const word patch = patchi < 0 ? word("none") : mesh.boundaryMesh()[patchi].name();
            FatalErrorInFunction
                << messageText
                   (
                       "Grain ", label(grains.id[i]), " at ", toFoam(grains.position[i]), " with velocity ",
                       toFoam(grains.velocity[i]), " left the mesh near the patch ", patch, ", which is no exit."
                   ).c_str()
                << exit(FatalError);
        }
        exited.push_back(i);
    }
    return exited;
}


label nearestPatch(const polyMesh& mesh, const point& position)
{
    label nearest = -1;
    scalar least = GREAT;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch)) continue;
        for (const face& f : patch.localFaces())
        {
            const pointHit hit = f.nearestPoint(position, patch.localPoints());
            if (hit.distance() >= least) continue;
            least = hit.distance();
            nearest = patch.index();
        }
    }
    return nearest;
}


void eraseGrains(nscd::Grains& grains, const std::vector<std::size_t>& indices)
{
    eraseAt(grains.position, indices);
    eraseAt(grains.velocity, indices);
    eraseAt(grains.omega, indices);
    eraseAt(grains.orientation, indices);
    eraseAt(grains.radius, indices);
    eraseAt(grains.mass, indices);
    eraseAt(grains.material, indices);
    eraseAt(grains.id, indices);
    eraseAt(grains.isFixed, indices);
    grains.nOwned = grains.size();
}

} // namespace nscdCoupling
} // namespace Foam
