// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Growing flat regions over a patch and tracing their outlines.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/coplanarRegions.H"
#include "coupling/case/walls/regionOutline.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

// Meshes written with ten digits keep both for cells down to 1e-4 of their coordinates. Merging across what is less flat
// would tilt walls by more than the contact search's dead band; merging less only makes more regions.
const scalar flatness = 1e-6;
const scalar angle = 1e-5;

/// Running plane through the faces collected so far; its normal points out of the domain.
struct GrowingPlane
{
    vector area = Zero;
    vector moment = Zero;  ///< of the faces' centers, weighted by area
    scalar weight = 0;

    void add(const vector& faceArea, const vector& center)
    {
        area += faceArea;
        moment += mag(faceArea)*center;
        weight += mag(faceArea);
    }
    vector normal() const { return area/mag(area); }
    vector center() const { return moment/weight; }
};

vector areaOf(const primitivePatch& patch, label facei)
{
    return patch.localFaces()[facei].areaNormal(patch.localPoints());
}

vector centerOf(const primitivePatch& patch, label facei)
{
    return patch.localFaces()[facei].centre(patch.localPoints());
}

bool lieInPlane(const primitivePatch& patch, label facei, const vector& center, const vector& normal)
{
    const scalar allowed = flatness*Foam::sqrt(mag(areaOf(patch, facei)));
    for (const label pointi : patch.localFaces()[facei])
    {
        if (mag((patch.localPoints()[pointi] - center) & normal) > allowed) return false;
    }
    return true;
}

bool isFlat(const primitivePatch& patch, label facei)
{
    const vector area = areaOf(patch, facei);
    return mag(area) > VSMALL && lieInPlane(patch, facei, centerOf(patch, facei), area/mag(area));
}

bool continues(const primitivePatch& patch, label facei, const GrowingPlane& plane)
{
    const vector area = areaOf(patch, facei);
    const vector normal = plane.normal();
    return (area & normal) > 0 && mag(area ^ normal) < angle*mag(area) && lieInPlane(patch, facei, plane.center(), normal);
}

/// Faces connected to `seed` and coplanar with it, marked with the region's number in `regionOf`.
std::vector<label> growRegion(const primitivePatch& patch, label seed, label region, const labelList& flat, labelList& regionOf)
{
    std::vector<label> members(1, seed);
    regionOf[seed] = region;
    GrowingPlane plane;
    plane.add(areaOf(patch, seed), centerOf(patch, seed));
    for (std::size_t next = 0; next < members.size(); ++next)
    {
        for (const label edgei : patch.faceEdges()[members[next]])
        {
            for (const label facei : patch.edgeFaces()[edgei])
            {
                if (regionOf[facei] >= 0 || !flat[facei] || !continues(patch, facei, plane)) continue;
                regionOf[facei] = region;
                plane.add(areaOf(patch, facei), centerOf(patch, facei));
                members.push_back(facei);
            }
        }
    }
    return members;
}

nscd::WallRegion makeRegion(const pointField& points, const std::vector<DirectedEdge>& outline, int wallPatch)
{
    nscd::WallRegion region;
    for (const DirectedEdge& edge : joinStraightRuns(outline, points))
    {
        region.edges.push_back({toVec3(points[edge.from]), toVec3(points[edge.to])});
    }
    region.patch = wallPatch;

    // Outlines run around the inward normal, so their area vector is that normal.
    const nscd::Vec3 origin = region.edges[0].start;
    nscd::Vec3 area = nscd::Vec3::Zero();
    nscd::Vec3 middle = nscd::Vec3::Zero();
    for (const nscd::WallEdge& edge : region.edges)
    {
        area += 0.5*(edge.start - origin).cross(edge.end - origin);
        middle += edge.start/double(region.edges.size());
    }
    region.normal = area.normalized();
    region.point = middle;
    return region;
}

/// Triangles about the face's center, as the mapping has it: a center of a grain that such walls hold is in a cell of the mesh.
void addFan(const primitivePatch& patch, label facei, int wallPatch, std::vector<nscd::WallRegion>& regions)
{
    const face& f = patch.localFaces()[facei];
    pointField corners(3, centerOf(patch, facei));
    forAll(f, k)
    {
        corners[1] = patch.localPoints()[f.nextLabel(k)];
        corners[2] = patch.localPoints()[f[k]];
        const bool isDegenerate = mag((corners[1] - corners[0]) ^ (corners[2] - corners[0])) <= 2*VSMALL;
        if (!isDegenerate) regions.push_back(makeRegion(corners, {{0, 1}, {1, 2}, {2, 0}}, wallPatch));
    }
}

/// Edges that only one face of the region has, running the other way round than the face: around the inward normal.
std::vector<DirectedEdge> outlineOf(const primitivePatch& patch, const std::vector<label>& members, const labelList& regionOf)
{
    std::vector<DirectedEdge> outline;
    for (const label facei : members)
    {
        const face& f = patch.localFaces()[facei];
        forAll(f, corner)
        {
            const label edgei = patch.faceEdges()[facei][corner];
            label sharing = 0;
            for (const label other : patch.edgeFaces()[edgei]) sharing += regionOf[other] == regionOf[facei];
            if (sharing == 1) outline.push_back({f.nextLabel(corner), f[corner]});
        }
    }
    return outline;
}

} // namespace


std::vector<nscd::WallRegion> coplanarRegions(const primitivePatch& patch, int wallPatch)
{
    std::vector<nscd::WallRegion> regions;
    labelList flat(patch.size(), 0);
    forAll(flat, facei) flat[facei] = isFlat(patch, facei);

    labelList regionOf(patch.size(), -1);
    forAll(regionOf, facei)
    {
        if (!flat[facei])
        {
            addFan(patch, facei, wallPatch, regions);
            continue;
        }
        if (regionOf[facei] >= 0) continue;
        const std::vector<label> members = growRegion(patch, facei, facei, flat, regionOf);
        regions.push_back(makeRegion(patch.localPoints(), outlineOf(patch, members, regionOf), wallPatch));
    }
    return regions;
}


scalar regionArea(const nscd::WallRegion& region)
{
    nscd::Vec3 area = nscd::Vec3::Zero();
    for (const nscd::WallEdge& edge : region.edges)
    {
        area += 0.5*(edge.start - region.point).cross(edge.end - region.point);
    }
    return area.dot(region.normal);
}

} // namespace nscdCoupling
} // namespace Foam
