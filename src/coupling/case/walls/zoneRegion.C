// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Places in a zone of cells.
#include "coupling/case/walls/zoneRegion.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/inputError.H"
#include "coupling/case/walls/gatheredLists.H"
#include "coupling/case/walls/weightedParts.H"

#include "ListOps.H"
#include "globalIndex.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using nscd::Vec3;

bool isBefore(const boundBox& a, const boundBox& b)
{
    if (a.min() != b.min()) return std::lexicographical_compare(a.min().begin(), a.min().end(), b.min().begin(), b.min().end());
    return std::lexicographical_compare(a.max().begin(), a.max().end(), b.max().begin(), b.max().end());
}

/// The boxes of all cells of a zone on every rank, in an order that follows from where they are.
class ZonePlaces
{
public:
    ZonePlaces(const polyMesh& mesh, const labelUList& cells)
    :
        mesh_(mesh)
    {
        List<boundBox> own(cells.size());
        forAll(cells, i) own[i] = boundBox(mesh.points(), mesh.cells()[cells[i]].labels(mesh.faces()), false);
        const List<boundBox> all = gathered<boundBox>(own);
        labelList order(identity(all.size()));
        std::stable_sort(order.begin(), order.end(), [&](label a, label b) { return isBefore(all[a], all[b]); });
        const label first = globalIndex(cells.size()).toGlobal(0);
        for (const label i : order) add(all[i], i >= first && i < first + cells.size() ? cells[i - first] : -1);
    }

    bool isEmpty() const { return boxes_.empty(); }
    const Eigen::AlignedBox3d& bounds() const { return bounds_; }

    nscd::EntryTry draw(const nscd::RandomNumbers& random) const
    {
        const scalar share = random(), x = random(), y = random(), z = random();
        const std::size_t part = parts_.at(share);
        const boundBox& box = boxes_[part];
        return {toVec3(box.min() + cmptMultiply(vector(x, y, z), box.span())), part};
    }

    /// Whether a place lies in the cell of its box, and that cell is one of this rank.
    bool holds(const nscd::EntryTry& at) const
    {
        const label cell = ownCell_[at.part];
        return cell >= 0 && mesh_.primitiveMesh::pointInCell(toFoam(at.position), cell);
    }

private:
    void add(const boundBox& box, label ownCell)
    {
        boxes_.push_back(box);
        ownCell_.push_back(ownCell);
        parts_.add(box.volume());
        bounds_.extend(toVec3(box.min())).extend(toVec3(box.max()));
    }

    const polyMesh& mesh_;
    std::vector<boundBox> boxes_;
    std::vector<label> ownCell_;   // of each box; -1: another rank's
    WeightedParts parts_;          // the boxes
    Eigen::AlignedBox3d bounds_;
};

nscd::EntryRegion readZone(const polyMesh& mesh, const input::CheckedEntries& given, const input::Surroundings& around)
{
    const std::string name = given.choice("cellZone", toWords(mesh.cellZones().names()));
    const auto places = std::make_shared<ZonePlaces>(mesh, mesh.cellZones()[word(name)]);
    if (places->isEmpty()) given.reject("cellZone", "has no cells", "a zone with cells");

    nscd::EntryRegion region;
    region.bounds = places->bounds();
    const int axis = around.shape.emptyAxis;
    region.draw = [places, axis, midPlane = around.midPlane](const nscd::RandomNumbers& random)
    {
        nscd::EntryTry at = places->draw(random);
        if (axis >= 0) at.position[axis] = midPlane;
        return at;
    };
    region.holds = [places](const nscd::EntryTry& at) { return places->holds(at); };
    return region;
}

} // namespace


input::ReadEntryRegion zoneRegions(const polyMesh& mesh)
{
    return [&mesh](const input::CheckedEntries& given, const input::Surroundings& around, double) { return readZone(mesh, given, around); };
}

} // namespace nscdCoupling
} // namespace Foam
