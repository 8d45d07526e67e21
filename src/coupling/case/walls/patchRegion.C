// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Places behind a patch.
#include "coupling/case/walls/patchRegion.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/inputError.H"
#include "coupling/case/walls/gatheredLists.H"
#include "coupling/case/walls/weightedParts.H"

#include "ListOps.H"
#include "surfaceFields.H"

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using nscd::Vec3;

/// Behind a face by a little more than a radius: a grain touches a patch that is a wall to it, and does not overlap it.
constexpr scalar clearance = 1 + 1e-6;

/// A triangle of a face about the face's center.
struct FaceTriangle
{
    Vec3 corner, a, b;     ///< points are corner + s a + t b
    Vec3 behind;           ///< from the face to the place of a grain [m]
    std::size_t face;
    scalar shareOfFace;    ///< of its area
};

/// All faces of a patch on every rank, in an order that follows from where they are.
class PatchPlaces
{
public:
    PatchPlaces(const polyPatch& patch, scalar depth, bool isByFlux)
    :
        patch_(patch),
        isByFlux_(isByFlux)
    {
        List<pointField> own(patch.size());
        forAll(patch, i) own[i] = patch[i].points(patch.points());
        List<pointField> faces = gathered<pointField>(own);
        sortByPlace(faces);
        for (const label i : order_) addFace(faces[i], depth);
        if (!isByFlux_) weigh(areas_);
    }

    bool isEmpty() const { return areas_.empty(); }
    const Eigen::AlignedBox3d& bounds() const { return bounds_; }

    /// Whether grains may enter now: through a patch by area always, by flux while fluid flows in. Collective.
    bool begin()
    {
        if (!isByFlux_) return true;
        weigh(inflow());
        return parts_.sum() > 0;
    }

    Vec3 draw(const nscd::RandomNumbers& random) const
    {
        const scalar share = random(), root = std::sqrt(random()), along = random();
        const FaceTriangle& t = triangles_[parts_.at(share)];
        return t.corner + root*(1 - along)*t.a + root*along*t.b + t.behind;
    }

private:
    void sortByPlace(const List<pointField>& faces)
    {
        pointField centers(faces.size());
        forAll(faces, i) centers[i] = average(faces[i]);
        order_ = identity(faces.size());
        const auto isBefore = [&](label i, label j)
        {
            const point &x = centers[i], &y = centers[j];
            return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
        };
        std::stable_sort(order_.begin(), order_.end(), isBefore);
    }

    void addFace(const pointField& points, scalar depth)
    {
        const face whole(identity(points.size()));
        const Vec3 center = toVec3(whole.centre(points));
        const Vec3 behind = -depth*toVec3(whole.unitNormal(points));
        scalar area = 0;
        const std::size_t first = triangles_.size();
        for (label k = 0; k < points.size(); ++k)
        {
            const Vec3 a = toVec3(points[k]) - center, b = toVec3(points[(k + 1) % points.size()]) - center;
            const scalar part = 0.5*a.cross(b).norm();
            triangles_.push_back({center, a, b, behind, areas_.size(), part});
            area += part;
            bounds_.extend(toVec3(points[k]) + behind);
        }
        for (std::size_t t = first; t < triangles_.size(); ++t) triangles_[t].shareOfFace /= area;
        areas_.push_back(area);
    }

    /// Volume that flows in through each face, in their order [m3/s].
    std::vector<scalar> inflow() const
    {
        const auto& phi = patch_.boundaryMesh().mesh().lookupObject<surfaceScalarField>("phi");
        const scalarList all = gathered<scalar>(scalarList(phi.boundaryField()[patch_.index()]));
        std::vector<scalar> in;
        for (const label i : order_) in.push_back(max(-all[i], scalar(0)));
        return in;
    }

    void weigh(const std::vector<scalar>& faces)
    {
        parts_.clear();
        for (const FaceTriangle& t : triangles_) parts_.add(faces[t.face]*t.shareOfFace);
    }

    const polyPatch& patch_;
    const bool isByFlux_;
    labelList order_;                 // of the faces as they are gathered
    std::vector<FaceTriangle> triangles_;
    std::vector<scalar> areas_;       // [m2]
    Eigen::AlignedBox3d bounds_;
    WeightedParts parts_;             // the triangles
};

/// Patches that grains can come through.
Words openPatches(const polyMesh& mesh)
{
    Words names;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!polyPatch::constraintType(patch.type())) names.push_back(patch.name());
    }
    return names;
}

nscd::EntryRegion readPatch(const polyMesh& mesh, const input::CheckedEntries& given, const input::Surroundings& around, scalar radius)
{
    const std::string name = given.choice("patch", openPatches(mesh));
    const bool isByFlux = given.choice("by", {"area", "flux"}, "area") == "flux";
    if (isByFlux && !around.hasFluid) given.reject("by", "is by the flux of a fluid, and none is solved", "area");
    const polyPatch& patch = mesh.boundaryMesh()[word(name)];
    const auto places = std::make_shared<PatchPlaces>(patch, clearance*radius, isByFlux);
    if (places->isEmpty()) given.reject("patch", "has no faces", "a patch with faces");

    nscd::EntryRegion region;
    region.bounds = places->bounds();
    region.begin = [places] { return places->begin(); };
    const int axis = around.shape.emptyAxis;
    region.draw = [places, axis, midPlane = around.midPlane](const nscd::RandomNumbers& random)
    {
        nscd::EntryTry at{places->draw(random)};
        if (axis >= 0) at.position[axis] = midPlane;
        return at;
    };
    return region;
}

} // namespace


input::ReadEntryRegion patchRegions(const polyMesh& mesh)
{
    return [&mesh](const input::CheckedEntries& given, const input::Surroundings& around, double largestRadius)
    {
        return readPatch(mesh, given, around, largestRadius);
    };
}

} // namespace nscdCoupling
} // namespace Foam
