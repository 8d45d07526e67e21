// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The one weight matrix between grains and cells.
#include "coupling/base/eraseAt.H"
#include "coupling/base/vectorConversion.H"
#include "coupling/mapping/grainMapping.H"

#include <map>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

scalar readLength(const dictionary& dict, const char* keyword, const scalar otherwise)
{
    const scalar length = dict.getOrDefault<scalar>(keyword, otherwise);
    if (length < 0)
    {
        FatalIOErrorInFunction(dict) << keyword << " must not be negative, is " << length << " m" << exit(FatalIOError);
    }
    return length;
}

SmoothingLengths readSmoothing(const dictionary& dict)
{
    const SmoothingLengths none;
    return {readLength(dict, "diffusionLength", none.length), readLength(dict, "filterWidth", none.width), readLength(dict, "thinCell", none.thinCell)};
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

bool isSame(const LocatedBall& a, const LocatedBall& b)
{
    return a.center == b.center && a.radius == b.radius && a.cell == b.cell && !a.isHeld && !b.isHeld;
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

/// Means over the balls of each body, by their shares in it.
std::vector<scalar> sharesOfBodies(const MappedBodies& bodies, const std::vector<scalar>& ofBalls)
{
    std::vector<scalar> means(bodies.volume.size(), 0);
    for (std::size_t ball = 0; ball < ofBalls.size(); ++ball) means[bodies.bodyOf[ball]] += bodies.share[ball]*ofBalls[ball];
    return means;
}

} // namespace

GrainMapping::Layout::Layout(const fvMesh& fvMesh, const scalar largestRadius, const scalar largestSolidFraction, const bool areDiscs)
:
    mesh(makeMappingMesh(fvMesh, largestRadius)),
    reach(largestRadius),
    exchange(mesh),
    locator(mesh, fvMesh),
    tools{mesh, locator, BallCellOverlap(mesh, areDiscs), areDiscs},
    redistribution(mesh, exchange, largestSolidFraction)
{}

GrainMapping::GrainMapping(const fvMesh& mesh, const dictionary& dict, const scalar largestRadius, const int grainDimensions)
:
    mesh_(mesh),
    method_(readVoidFractionMethod(dict)),
    largestSolidFraction_(readLargestSolidFraction(dict)),
    grainDimensions_(grainDimensions > 0 ? grainDimensions : mesh.nGeometricD()),
    smoother_(mesh, readSmoothing(dict)),
    layout_(new Layout(mesh, largestRadius, largestSolidFraction_, grainDimensions_ == 2)),
    solidFraction_(mesh.nCells(), Zero)
{}

void GrainMapping::checkDimensions(const ::nscd::Grains& grains) const
{
    const MappingMesh& mesh = layout_->mesh;
    if (grains.shape.dimensions != grainDimensions_)
    {
        FatalErrorInFunction
            << "grains of " << grainDimensions_ << " dimensions are mapped, these have " << grains.shape.dimensions << exit(FatalError);
    }
    if (grainDimensions_ == 2 && mag(grains.shape.thickness/mesh.thickness - 1) > 1e-6)
    {
        FatalErrorInFunction
            << "the mesh is " << mesh.thickness << " m thick, the discs are " << grains.shape.thickness << " m long"
            << exit(FatalError);
    }
}

void GrainMapping::growHalo(const ::nscd::Grains& grains, const scalar reachOfBodies)
{
    if (!layout_->exchange.isParallel())
    {
        return;
    }
    scalar largest = reachOfBodies;
    for (std::size_t i = 0; i < grains.nOwned; ++i) largest = std::max(largest, grains.radius[i]);
    largest = layout_->exchange.max(largest);
    if (largest > layout_->reach)
    {
        layout_.reset(new Layout(mesh_, largest, largestSolidFraction_, grainDimensions_ == 2));
        forgetRows();
    }
}

std::vector<LocatedBall> GrainMapping::locate(const ::nscd::Grains& grains, const ::nscd::PeriodicBox& box)
{
    std::vector<LocatedBall> balls(grains.nOwned);
    cells_.resize(grains.nOwned, -1);
    label nearby = -1;
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const Vec3 center = box.any() ? box.wrap(grains.position[i]) : grains.position[i];
        const bool isThere = i < balls_.size() && balls_[i].center == center && balls_[i].cell == cells_[i] && !balls_[i].isHeld;
        const label last = cells_[i];
        if (!isThere) cells_[i] = layout_->locator.find(center, last, nearby);
        const bool isHeld = isMeshAhead_ && cells_[i] < 0 && last >= 0;
        if (isHeld) cells_[i] = last;
        balls[i] = {center, grains.radius[i], cells_[i], isHeld};
    }
    return balls;
}

CellHome GrainMapping::find(const Vec3& position, const label guess) const
{
    return layout_->mesh.home(layout_->locator.findInCells(position, guess));
}

void GrainMapping::listMissing(const ::nscd::Grains& grains)
{
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        if (cells_[i] < 0)
        {
            report_.outsideMesh.push_back(grains.id[i]);
        }
        else if (!layout_->mesh.isOwn(cells_[i]) && (!hasBodies() || bodies_.isFirst(i)))
        {
            report_.away.push_back({i, grains.id[i], layout_->mesh.home(cells_[i])});
        }
    }
}

// Returns the part of the ball that is in cells. Balls at home are in own cells, or parts of bodies of which the first ball is.
scalar GrainMapping::buildRow(const LocatedBall& ball, const bool isHome, WeightMatrix& rows)
{
    const std::size_t first = rows.shares.size();
    if (ball.isHeld && isHome) rows.shares.push_back({ball.cell, 1});
    const scalar covered = isHome && !ball.isHeld ? method_.appendShares(layout_->tools, ball, rows.shares) : 1;
    scalar sum = 0;
    for (std::size_t k = first; k < rows.shares.size(); ++k)
    {
        sum += rows.shares[k].share;
    }
    // A small grain in a sliver between halves of a mesh that slide past each other reaches no cell.
    if (sum <= 0 && isHome)
    {
        rows.shares.resize(first);
        rows.shares.push_back({ball.cell, 1});
        sum = 1;
    }
    for (std::size_t k = first; k < rows.shares.size(); ++k)
    {
        rows.shares[k].share /= sum;
    }
    rows.endRow();
    return covered;
}

// Rows made for balls do not serve bodies, nor the other way.
void GrainMapping::setBodies(const MappedBodies& bodies)
{
    if (bodies.empty() != bodies_.empty()) forgetRows();
    bodies_ = bodies;
}

// The balls of a body follow each other.
void GrainMapping::joinRows()
{
    weights_.clear();
    for (std::size_t ball = 0; ball < balls_.size();)
    {
        const label body = bodies_.bodyOf[ball];
        std::map<label, scalar> inCell;
        for (; ball < balls_.size() && bodies_.bodyOf[ball] == body; ++ball)
        {
            for (label k = ballWeights_.rowStart[ball]; k < ballWeights_.rowStart[ball + 1]; ++k)
            {
                inCell[ballWeights_.shares[k].cell] += bodies_.share[ball]*ballWeights_.shares[k].share;
            }
        }
        for (const auto& [cell, share] : inCell) weights_.shares.push_back({cell, share});
        weights_.endRow();
    }
}

// Whether any row has changed.
bool GrainMapping::updateRows(std::vector<LocatedBall> balls)
{
    const auto isUnmoved = [&](std::size_t i) { return i < balls_.size() && isSame(balls[i], balls_[i]); };
    std::size_t unmoved = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) unmoved += isUnmoved(i);
    if (unmoved == balls.size() && balls_.size() == balls.size()) return false;

    WeightMatrix& rows = hasBodies() ? ballWeights_ : weights_;
    const WeightMatrix before = unmoved > 0 ? std::move(rows) : WeightMatrix();
    rows.clear();
    rows.shares.reserve(before.shares.size());
    covered_.resize(balls.size());
    std::size_t first = 0;   // ball of the body
    for (std::size_t i = 0; i < balls.size(); ++i)
    {
        if (!hasBodies() || bodies_.isFirst(i)) first = i;
        const bool isHome = layout_->mesh.isOwn(balls[first].cell) && balls[i].cell >= 0;
        if (isUnmoved(i) && isUnmoved(first)) rows.copyRow(before, label(i));
        else covered_[i] = buildRow(balls[i], isHome, rows);
    }
    balls_ = std::move(balls);
    if (hasBodies()) joinRows();
    return true;
}

void GrainMapping::forgetRows()
{
    balls_.clear();
    covered_.clear();
    weights_.clear();
    ballWeights_.clear();
    isBuilt_ = false;
}

void GrainMapping::erase(const std::vector<std::size_t>& grains)
{
    eraseAt(cells_, grains);
    isBuilt_ = false;
    if (hasBodies()) return forgetRows();
    eraseAt(balls_, grains);
    eraseAt(covered_, grains);
    weights_.erase(grains);
}

void GrainMapping::buildSolidFraction()
{
    solidFraction_ = scalarField(layout_->mesh.nCells(), Zero);
    const std::vector<scalar> ofBodies = hasBodies() ? sharesOfBodies(bodies_, covered_) : std::vector<scalar>();
    const std::vector<scalar>& covered = hasBodies() ? ofBodies : covered_;
    for (label i = 0; i < weights_.nRows(); ++i)
    {
        const scalar volume = volumes_[i];
        report_.grainVolume += volume;
        report_.lostOutside += volume*(1 - covered[i]);
        for (label k = weights_.rowStart[i]; k < weights_.rowStart[i + 1]; ++k)
        {
            solidFraction_[weights_.shares[k].cell] += weights_.shares[k].share*volume;
        }
    }
    layout_->exchange.toOwners({{&solidFraction_}, {}});
    solidFraction_.setSize(mesh_.nCells());
    solidFraction_ /= mesh_.V();
    smoother_.restrictTo(solidFraction_);
    smoother_.smooth(solidFraction_);
    report_.redistribution = layout_->redistribution.build(solidFraction_);
    forAll(solidFraction_, cellI)
    {
        report_.volumeDeposited += solidFraction_[cellI]*mesh_.V()[cellI];
    }
}

void GrainMapping::sumReport()
{
    scalar sums[] = {report_.grainVolume, report_.volumeDeposited, report_.lostOutside};
    layout_->exchange.sum(sums, 3);
    report_.grainVolume = sums[0];
    report_.volumeDeposited = sums[1];
    report_.lostOutside = sums[2];
}

const MappingReport& GrainMapping::update
(
    const ::nscd::Grains& grains, const ::nscd::PeriodicBox& box, const MappedBodies& bodies
)
{
    checkDimensions(grains);
    growHalo(grains, bodies.reach);
    setBodies(bodies);
    box_ = box;
    const bool isChanged = updateRows(locate(grains, box)) || !isBuilt_;
    if (layout_->exchange.max(isChanged ? 1 : 0) == 0) return report_;
    report_ = MappingReport();
    listMissing(grains);
    volumes_.resize(grains.nOwned);
    for (std::size_t i = 0; i < grains.nOwned; ++i) volumes_[i] = grains.volume(i);
    if (hasBodies()) volumes_ = bodies_.volume;
    buildSolidFraction();
    sumReport();
    isBuilt_ = true;
    return report_;
}

// Solid fractions as grains sample the fluid fraction.
OwnTrace GrainMapping::ownTrace() const
{
    const MappingMesh& mesh = layout_->mesh;
    scalarField inCell = solidFraction_;
    makeAsGrainsSee({{&inCell}, {}});
    scalarField nextTo = meanNextTo(mesh, inCell);
    scalarField smoothingAreas = smoother_.isOn() ? smoother_.areas() : scalarField(mesh.nOwnCells, Zero);
    const CellFields fields{{&nextTo, &smoothingAreas}, {}};
    fields.resize(mesh.nCells());
    layout_->exchange.toHalo(fields);
    return traceOwn(mesh, weights_, volumes_, {inCell, nextTo}, box_, smoothingAreas);
}

void GrainMapping::setFluidFraction(volScalarField& fluidFraction) const
{
    fluidFraction.primitiveFieldRef() = 1 - solidFraction_;
    fluidFraction.correctBoundaryConditions();
}

// From amounts in own and halo cells to what own cells have per unit volume.
void GrainMapping::finishSpread(const CellFields& perVolume) const
{
    layout_->exchange.toOwners(perVolume);
    perVolume.resize(mesh_.nCells());
    const auto smooth = [this](auto& field)
    {
        field /= mesh_.V();
        smoother_.smooth(field);
    };
    for (scalarField* field : perVolume.scalars) smooth(*field);
    for (vectorField* field : perVolume.vectors) smooth(*field);
    layout_->redistribution.spread(perVolume);
}

void GrainMapping::spread(const std::vector<ScalarSpread>& scalars, const std::vector<VectorSpread>& vectors) const
{
    CellFields fields;
    for (const ScalarSpread& pair : scalars)
    {
        pair.cells = scalarField(layout_->mesh.nCells(), Zero);
        fields.scalars.push_back(&pair.cells);
    }
    for (const VectorSpread& pair : vectors)
    {
        pair.cells = vectorField(layout_->mesh.nCells(), Zero);
        fields.vectors.push_back(&pair.cells);
    }
    for (label row = 0; row < weights_.nRows(); ++row)
    {
        for (const ScalarSpread& pair : scalars) spreadRow(weights_, row, pair.grains, pair.cells);
        for (const VectorSpread& pair : vectors) spreadRow(weights_, row, pair.grains, pair.cells);
    }
    finishSpread(fields);
}

// From fields of own cells to what the shares of own and halo cells are taken of.
void GrainMapping::makeAsGrainsSee(const CellFields& cells) const
{
    layout_->redistribution.sample(cells);
    for (scalarField* field : cells.scalars) smoother_.smooth(*field);
    for (vectorField* field : cells.vectors) smoother_.smooth(*field);
    cells.resize(layout_->mesh.nCells());
    layout_->exchange.toHalo(cells);
}

void GrainMapping::sample(const std::vector<ScalarSample>& scalars, const std::vector<VectorSample>& vectors) const
{
    std::vector<scalarField> scalarCells;
    std::vector<vectorField> vectorCells;
    for (const ScalarSample& pair : scalars)
    {
        scalarCells.push_back(pair.cells);
        pair.grains.assign(weights_.nRows(), 0);
    }
    for (const VectorSample& pair : vectors)
    {
        vectorCells.push_back(pair.cells);
        pair.grains.assign(weights_.nRows(), Vec3::Zero());
    }
    CellFields fields;
    for (scalarField& field : scalarCells) fields.scalars.push_back(&field);
    for (vectorField& field : vectorCells) fields.vectors.push_back(&field);
    makeAsGrainsSee(fields);
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
