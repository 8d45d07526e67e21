// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson mixing in two passes over memory, which is what it costs: differences are kept in single precision.
#include "nscd/solvers/help/andersonAcceleration.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

namespace nscd
{

namespace
{

constexpr int blockSize = 3*blockLanes;

} // namespace

void gatherImpulses(const std::vector<ContactBlock>& blocks, BlockRange range, AndersonAcceleration::Impulses& r)
{
    r.resize(range.count*blockSize);
    for (std::size_t k = 0; k < range.count; ++k)
    {
        const double* held = &blocks[range[k]].r[0][0];
        std::copy(held, held + blockSize, r.data() + k*blockSize);
    }
}

AndersonAcceleration::AndersonAcceleration(BlockRange range, DifferenceFunction addDifferences, const Halo& halo)
:
    range_(range),
    addDifferences_(addDifferences),
    halo_(halo),
    previousImage_(range.count*blockSize),
    previousDefect_(range.count*blockSize)
{
    for (int column = 0; column < mixingDepth; ++column)
    {
        imageDifference_[column].resize(range.count*blockSize);
        defectDifference_[column].resize(range.count*blockSize);
    }
    forget();
}

void AndersonAcceleration::forget()
{
    hasPrevious_ = false;
    stored_ = 0;
    gram_.setZero();
    projection_.setZero();
}

MixingHistory AndersonAcceleration::history()
{
    MixingHistory history{previousImage_.data(), previousDefect_.data(), {}, {}, column_, stored_};
    for (int column = 0; column < mixingDepth; ++column)
    {
        history.imageDifference[column] = imageDifference_[column].data();
        history.defectDifference[column] = defectDifference_[column].data();
    }
    return history;
}

AndersonAcceleration::Gamma AndersonAcceleration::solveLeastSquares() const
{
    Eigen::Matrix<double, mixingDepth, mixingDepth> gram = gram_;
    for (int column = 0; column < mixingDepth; ++column)
    {
        // Nearly parallel differences must not let the mixing diverge; columns not yet filled are zero and take no part.
        double& diagonal = gram(column, column);
        diagonal = column < stored_ ? diagonal*(1.0 + 1e-10) : 1.0;
    }
    return gram.ldlt().solve(projection_);
}

void AndersonAcceleration::remember(const std::vector<ContactBlock>& blocks, Impulses& r)
{
    gatherImpulses(blocks, range_, previousImage_);
    for (std::size_t i = 0; i < previousImage_.size(); ++i) previousDefect_[i] = static_cast<float>(previousImage_[i] - r[i]);
    r = previousImage_;
    hasPrevious_ = true;
}

void AndersonAcceleration::combine(const Gamma& gamma, Impulses& r) const
{
    // A fixed number of columns lets the compiler vectorize; those not yet filled hold finite numbers and have gamma = 0.
    double weight[mixingDepth];
    const float* difference[mixingDepth];
    for (int column = 0; column < mixingDepth; ++column)
    {
        weight[column] = gamma[column];
        difference[column] = imageDifference_[column].data();
    }
    const double* image = previousImage_.data();
    double* mixed = r.data();
    for (std::size_t i = 0; i < r.size(); ++i)
    {
        double sum = image[i];
        for (int column = 0; column < mixingDepth; ++column) sum -= weight[column]*difference[column][i];
        mixed[i] = sum;
    }
}

void AndersonAcceleration::mix(const std::vector<ContactBlock>& blocks, Impulses& r)
{
    if (!hasPrevious_)
    {
        remember(blocks, r);
        return;
    }
    column_ = stored_ < mixingDepth ? stored_++ : (column_ + 1) % mixingDepth;
    MixingSums sums = addDifferences_(blocks.data(), range_, r.data(), history());
    halo_.sum(sums.values, 2*mixingDepth);
    for (int column = 0; column < stored_; ++column)
    {
        gram_(column, column_) = gram_(column_, column) = sums.gram(column);
        projection_[column] = sums.projection(column);
    }
    const Gamma gamma = solveLeastSquares();
    if (!gamma.allFinite())
    {
        r = previousImage_;
        forget();
        return;
    }
    combine(gamma, r);
}

} // namespace nscd
