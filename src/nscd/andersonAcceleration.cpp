// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson mixing in two passes over memory, which is what it costs: differences are kept in single precision.
#include "andersonAcceleration.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

namespace nscd
{

namespace
{

constexpr int blockSize = 3*blockLanes;

/// Sums in as many parts as there are lanes, so that the compiler can add them side by side.
struct LaneSums
{
    double part[blockLanes] = {};

    double total() const
    {
        double sum = 0.0;
        for (double p : part) sum += p;
        return sum;
    }
};

} // namespace

AndersonAcceleration::Impulses gatherImpulses(const std::vector<ContactBlock>& blocks, BlockRange range)
{
    AndersonAcceleration::Impulses r(range.count*blockSize);
    for (std::size_t k = 0; k < range.count; ++k)
    {
        const double* held = &blocks[range[k]].r[0][0];
        std::copy(held, held + blockSize, r.data() + k*blockSize);
    }
    return r;
}

AndersonAcceleration::AndersonAcceleration(BlockRange range)
:
    range_(range),
    previousImage_(range.count*blockSize),
    previousDefect_(range.count*blockSize)
{
    for (int column = 0; column < depth; ++column)
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

void AndersonAcceleration::addDifferences(const std::vector<ContactBlock>& blocks, const Impulses& r)
{
    float* image = imageDifference_[column_].data();
    float* newest = defectDifference_[column_].data();
    LaneSums gram[depth], projection[depth];
    for (std::size_t k = 0; k < range_.count; ++k)
    {
        const ContactBlock& block = blocks[range_[k]];
        double weight[blockLanes];
        for (int l = 0; l < blockLanes; ++l) weight[l] = 1.0/std::max(block.invWn[l], 1e-300);
        for (int m = 0; m < 3; ++m)
        {
            const std::size_t at = k*blockSize + m*blockLanes;
            const double* now = block.r[m];
            double f[blockLanes], df[blockLanes];
            for (int l = 0; l < blockLanes; ++l)
            {
                f[l] = now[l] - r[at + l];
                df[l] = f[l] - previousDefect_[at + l];
                image[at + l] = static_cast<float>(now[l] - previousImage_[at + l]);
                newest[at + l] = static_cast<float>(df[l]);
                previousDefect_[at + l] = static_cast<float>(f[l]);
                previousImage_[at + l] = now[l];
            }
            for (int column = 0; column < stored_; ++column)
            {
                const float* old = defectDifference_[column].data() + at;
                for (int l = 0; l < blockLanes; ++l)
                {
                    gram[column].part[l] += weight[l]*df[l]*old[l];
                    projection[column].part[l] += weight[l]*f[l]*old[l];
                }
            }
        }
    }
    for (int column = 0; column < stored_; ++column)
    {
        gram_(column, column_) = gram_(column_, column) = gram[column].total();
        projection_[column] = projection[column].total();
    }
}

AndersonAcceleration::Gamma AndersonAcceleration::solveLeastSquares() const
{
    Eigen::Matrix<double, depth, depth> gram = gram_;
    for (int column = 0; column < depth; ++column)
    {
        // Nearly parallel differences must not blow the mixing up; columns not yet filled are zero and take no part.
        double& diagonal = gram(column, column);
        diagonal = column < stored_ ? diagonal*(1.0 + 1e-10) : 1.0;
    }
    return gram.ldlt().solve(projection_);
}

void AndersonAcceleration::remember(const std::vector<ContactBlock>& blocks, Impulses& r)
{
    previousImage_ = gatherImpulses(blocks, range_);
    for (std::size_t i = 0; i < previousImage_.size(); ++i) previousDefect_[i] = static_cast<float>(previousImage_[i] - r[i]);
    r = previousImage_;
    hasPrevious_ = true;
}

void AndersonAcceleration::mix(const std::vector<ContactBlock>& blocks, Impulses& r)
{
    if (!hasPrevious_)
    {
        remember(blocks, r);
        return;
    }
    column_ = stored_ < depth ? stored_++ : (column_ + 1) % depth;
    addDifferences(blocks, r);
    const Gamma gamma = solveLeastSquares();
    r = previousImage_;
    if (!gamma.allFinite())
    {
        forget();
        return;
    }
    for (int column = 0; column < stored_; ++column)
    {
        const float* difference = imageDifference_[column].data();
        for (std::size_t i = 0; i < r.size(); ++i) r[i] -= gamma[column]*difference[i];
    }
}

} // namespace nscd
