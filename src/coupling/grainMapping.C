// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The one weight matrix between grains and cells.
#include "grainMapping.H"
#include "vectorConversion.H"

namespace Foam
{
namespace nscdCoupling
{
namespace
{

const fvMesh& refuseParallel(const fvMesh& mesh)
{
    if (Pstream::parRun())
    {
        FatalErrorInFunction << "grains are mapped in serial runs only, so far" << exit(FatalError);
    }
    return mesh;
}

scalar readDiffusionLength(const dictionary& dict)
{
    const scalar length = dict.getOrDefault<scalar>("diffusionLength", 0);
    if (length < 0)
    {
        FatalIOErrorInFunction(dict) << "diffusionLength must not be negative, is " << length << " m" << exit(FatalIOError);
    }
    return length;
}

scalar readLargestSolidFraction(const dictionary& dict)
{
    const scalar leastFluid = dict.getOrDefault<scalar>("minFluidFraction", 0.2);
    if (leastFluid <= 0 || leastFluid >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "minFluidFraction must lie between 0 and 1, is " << leastFluid << exit(FatalIOError);
    }
    return 1 - leastFluid;
}

void addTo(scalar& to, const scalar share, const scalar from)
{
    to += share*from;
}

void addTo(vector& cell, const scalar share, const Vec3& grain)
{
    cell += share*toFoam(grain);
}

void addTo(Vec3& grain, const scalar share, const vector& cell)
{
    grain += share*toVec3(cell);
}

template<class Grains, class Cells>
void spreadRow(const WeightMatrix& weights, const label row, const Grains& grains, Cells& cells)
{
    const auto amount = grains[row];
    for (label k = weights.rowStart[row]; k < weights.rowStart[row + 1]; ++k)
    {
        addTo(cells[weights.shares[k].cell], weights.shares[k].share, amount);
    }
}

template<class Cells, class Grains>
void sampleRow(const WeightMatrix& weights, const label row, const Cells& cells, Grains& grains)
{
    auto& amount = grains[row];
    for (label k = weights.rowStart[row]; k < weights.rowStart[row + 1]; ++k)
    {
        addTo(amount, weights.shares[k].share, cells[weights.shares[k].cell]);
    }
}

} // namespace

GrainMapping::GrainMapping(const fvMesh& mesh, const dictionary& dict)
:
    mesh_(refuseParallel(mesh)),
    mappingMesh_(makeMappingMesh(mesh)),
    locator_(mappingMesh_, mesh),
    method_(readVoidFractionMethod(dict)),
    tools_{mappingMesh_, locator_, BallCellOverlap(mappingMesh_)},
    smoother_(mesh, readDiffusionLength(dict)),
    redistribution_(mappingMesh_, readLargestSolidFraction(dict)),
    solidFraction_(mesh.nCells(), Zero)
{}

void GrainMapping::checkDimensions(const ::nscd::Grains& grains) const
{
    const int dimensions = mappingMesh_.is2D() ? 2 : 3;
    if (grains.shape.dimensions != dimensions)
    {
        FatalErrorInFunction
            << "the mesh has " << dimensions << " dimensions, the grains have " << grains.shape.dimensions << exit(FatalError);
    }
    if (mappingMesh_.is2D() && mag(grains.shape.thickness/mappingMesh_.thickness - 1) > 1e-6)
    {
        FatalErrorInFunction
            << "the mesh is " << mappingMesh_.thickness << " m thick, the discs are " << grains.shape.thickness << " m long"
            << exit(FatalError);
    }
}

void GrainMapping::locate(const ::nscd::Grains& grains, const ::nscd::PeriodicBox& box)
{
    cells_.resize(grains.nOwned, -1);
    positions_.resize(grains.nOwned);
    report_.outsideMesh.clear();
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        positions_[i] = box.any() ? box.wrap(grains.position[i]) : grains.position[i];
        cells_[i] = locator_.find(positions_[i], cells_[i]);
        if (cells_[i] < 0)
        {
            report_.outsideMesh.push_back(grains.id[i]);
        }
    }
}

void GrainMapping::buildRow(const LocatedBall& ball, const scalar volume)
{
    const std::size_t first = weights_.shares.size();
    if (ball.cell >= 0)
    {
        report_.lostOutside += volume*(1 - method_.appendShares(tools_, ball, weights_.shares));
    }
    scalar sum = 0;
    for (std::size_t k = first; k < weights_.shares.size(); ++k)
    {
        sum += weights_.shares[k].share;
    }
    for (std::size_t k = first; k < weights_.shares.size(); ++k)
    {
        weights_.shares[k].share /= sum;
    }
    weights_.endRow();
}

void GrainMapping::buildSolidFraction(const ::nscd::Grains& grains)
{
    solidFraction_ = 0;
    for (label i = 0; i < weights_.nRows(); ++i)
    {
        const scalar volume = grains.volume(i);
        report_.grainVolume += volume;
        for (label k = weights_.rowStart[i]; k < weights_.rowStart[i + 1]; ++k)
        {
            solidFraction_[weights_.shares[k].cell] += weights_.shares[k].share*volume;
        }
    }
    solidFraction_ /= mesh_.V();
    report_.smoothing = smoother_.smooth(solidFraction_);
    report_.redistribution = redistribution_.build(solidFraction_);
    forAll(solidFraction_, cellI)
    {
        report_.volumeDeposited += solidFraction_[cellI]*mesh_.V()[cellI];
    }
}

const MappingReport& GrainMapping::update(const ::nscd::Grains& grains, const ::nscd::PeriodicBox& box)
{
    checkDimensions(grains);
    report_ = MappingReport();
    locate(grains, box);
    weights_.clear();
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        buildRow({positions_[i], grains.radius[i], cells_[i]}, grains.volume(i));
    }
    buildSolidFraction(grains);
    return report_;
}

void GrainMapping::voidFraction(volScalarField& epsilon) const
{
    epsilon.primitiveFieldRef() = 1 - solidFraction_;
    epsilon.correctBoundaryConditions();
}

void GrainMapping::spread(const std::vector<ScalarSpread>& scalars, const std::vector<VectorSpread>& vectors) const
{
    for (const ScalarSpread& pair : scalars) pair.cells = scalarField(mesh_.nCells(), Zero);
    for (const VectorSpread& pair : vectors) pair.cells = vectorField(mesh_.nCells(), Zero);
    for (label row = 0; row < weights_.nRows(); ++row)
    {
        for (const ScalarSpread& pair : scalars) spreadRow(weights_, row, pair.grains, pair.cells);
        for (const VectorSpread& pair : vectors) spreadRow(weights_, row, pair.grains, pair.cells);
    }
    const auto finish = [this](auto& perVolume)
    {
        perVolume /= mesh_.V();
        smoother_.smooth(perVolume);
        redistribution_.spread(perVolume);
    };
    for (const ScalarSpread& pair : scalars) finish(pair.cells);
    for (const VectorSpread& pair : vectors) finish(pair.cells);
}

template<class Type>
Field<Type> GrainMapping::asGrainsSee(const Field<Type>& cells) const
{
    Field<Type> result(cells);
    redistribution_.sample(result);
    smoother_.smooth(result);
    return result;
}

void GrainMapping::sample(const std::vector<ScalarSample>& scalars, const std::vector<VectorSample>& vectors) const
{
    std::vector<scalarField> scalarCells;
    std::vector<vectorField> vectorCells;
    for (const ScalarSample& pair : scalars)
    {
        scalarCells.push_back(asGrainsSee(pair.cells));
        pair.grains.assign(weights_.nRows(), 0);
    }
    for (const VectorSample& pair : vectors)
    {
        vectorCells.push_back(asGrainsSee(pair.cells));
        pair.grains.assign(weights_.nRows(), Vec3::Zero());
    }
    for (label row = 0; row < weights_.nRows(); ++row)
    {
        for (std::size_t k = 0; k < scalars.size(); ++k) sampleRow(weights_, row, scalarCells[k], scalars[k].grains);
        for (std::size_t k = 0; k < vectors.size(); ++k) sampleRow(weights_, row, vectorCells[k], vectors[k].grains);
    }
}

void GrainMapping::spread(const std::vector<scalar>& grains, scalarField& perVolume) const
{
    spread({{grains, perVolume}}, {});
}

void GrainMapping::spread(const std::vector<Vec3>& grains, vectorField& perVolume) const
{
    spread({}, {{grains, perVolume}});
}

void GrainMapping::sample(const scalarField& cells, std::vector<scalar>& grains) const
{
    sample({{cells, grains}}, {});
}

void GrainMapping::sample(const vectorField& cells, std::vector<Vec3>& grains) const
{
    sample({}, {{cells, grains}});
}

} // namespace nscdCoupling
} // namespace Foam
