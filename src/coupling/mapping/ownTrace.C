// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The own part, row by row.
#include "coupling/mapping/ownTrace.H"

#include "closures/ownWake.hpp"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// The shares of one grain.
struct Row
{
    const CellShare* first;
    const CellShare* last;

    const CellShare* begin() const { return first; }
    const CellShare* end() const { return last; }
    scalar in(label cell) const
    {
        const CellShare* found = std::find_if(first, last, [cell](const CellShare& share) { return share.cell == cell; });
        return found == last ? 0 : found->share;
    }
};

Row rowOf(const WeightMatrix& weights, label row)
{
    return {weights.shares.data() + weights.rowStart[row], weights.shares.data() + weights.rowStart[row + 1]};
}

template<class Visit>
scalar meanOverNeighbors(const MappingMesh& mesh, label cell, const Visit& value)
{
    scalar sum = 0;
    label count = 0;
    for (label k = mesh.cellFaceStart[cell]; k < mesh.cellFaceStart[cell + 1]; ++k)
    {
        const label neighbor = mesh.cellFaces[k].neighbor;
        if (neighbor == domainBorder) continue;
        ++count;
        if (neighbor >= 0) sum += value(neighbor);
    }
    return count ? sum/count : 0;
}

/// sum_j w_j^2/V_j [1/m3], of fields that are smoothed besides.
scalar ownConcentration(const MappingMesh& mesh, const Row& row, scalar smoothingArea)
{
    scalar sum = 0;
    for (const CellShare& share : row) sum += sqr(share.share)/mesh.cellVolume[share.cell];
    if (smoothingArea == 0 || sum == 0) return sum;
    // The square of the smoothing's kernel alone comes to 1/(150.8 l^3).
    return std::pow(std::pow(sum, -2.0/3) + std::pow(150.8, 2.0/3)*smoothingArea, -1.5);
}

/// What the grain itself adds to the solid fraction next to its cells.
scalar ownNextTo(const MappingMesh& mesh, const Row& row, scalar volume)
{
    scalar sum = 0;
    for (const CellShare& share : row)
    {
        sum += share.share*meanOverNeighbors(mesh, share.cell, [&](label cell) { return row.in(cell)*volume/mesh.cellVolume[cell]; });
    }
    return sum;
}

scalar sampled(const Row& row, const scalarField& cells)
{
    scalar sum = 0;
    for (const CellShare& share : row) sum += share.share*cells[share.cell];
    return sum;
}

Eigen::Matrix3d ownFlow(const MappingMesh& mesh, const Row& row, const ::nscd::PeriodicBox& box, scalar smoothingArea)
{
    Eigen::Matrix3d flow = Eigen::Matrix3d::Zero();
    for (const CellShare* a = row.first; a != row.last; ++a)
    {
        flow += sqr(a->share)*closures::flowInOwnCell(mesh.cellVolume[a->cell], smoothingArea)*Eigen::Matrix3d::Identity();
        for (const CellShare* b = row.first; b != a; ++b)
        {
            const Vec3 distance = box.nearestImage(mesh.cellCenter[a->cell] - mesh.cellCenter[b->cell]);
            const scalar side = std::cbrt(0.5*(mesh.cellVolume[a->cell] + mesh.cellVolume[b->cell]));
            flow += 2*a->share*b->share*closures::flowInOtherCell(distance, side, smoothingArea);
        }
    }
    return flow;
}

} // namespace

scalarField meanNextTo(const MappingMesh& mesh, const scalarField& cells)
{
    scalarField mean(mesh.nOwnCells);
    forAll(mean, cellI) mean[cellI] = meanOverNeighbors(mesh, cellI, [&](label neighbor) { return cells[neighbor]; });
    return mean;
}

OwnTrace traceOwn
(
    const MappingMesh& mesh, const WeightMatrix& weights, const std::vector<scalar>& volumes, const SolidNearby& solid,
    const ::nscd::PeriodicBox& box, const scalarField& smoothingAreas
)
{
    const label n = weights.nRows();
    OwnTrace trace{std::vector<scalar>(n), std::vector<scalar>(n), std::vector<Vec3>(n, Vec3::Zero()), std::vector<Vec3>(n, Vec3::Zero())};
    for (label i = 0; i < n; ++i)
    {
        const Row row = rowOf(weights, i);
        const scalar smoothingArea = sampled(row, smoothingAreas);
        trace.fraction[i] = volumes[i]*ownConcentration(mesh, row, smoothingArea);
        trace.others[i] = sampled(row, solid.inCell) - trace.fraction[i];
        if (closures::loneliness(trace.others[i]) == 0) continue;
        // Smoothed fields hold what is next to the cells already.
        if (smoothingArea == 0) trace.others[i] = std::max(trace.others[i], sampled(row, solid.nextTo) - ownNextTo(mesh, row, volumes[i]));
        if (closures::loneliness(trace.others[i]) == 0) continue;
        const Eigen::Matrix3d flow = closures::wakeInFraction(trace.fraction[i])*ownFlow(mesh, row, box, smoothingArea);
        trace.flowDiagonal[i] = flow.diagonal();
        trace.flowOffDiagonal[i] = Vec3(flow(1, 2), flow(2, 0), flow(0, 1));
    }
    return trace;
}

} // namespace nscdCoupling
} // namespace Foam
