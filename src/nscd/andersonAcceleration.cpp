// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson mixing with a ring of stored differences.
#include "andersonAcceleration.hpp"

#include <Eigen/Cholesky>

namespace nscd
{

AndersonAcceleration::AndersonAcceleration(Eigen::VectorXd weight, int depth)
:
    weight_(std::move(weight)),
    depth_(depth),
    imageDifferences_(weight_.size(), depth),
    defectDifferences_(weight_.size(), depth)
{}

void AndersonAcceleration::storeDifferences(const Eigen::VectorXd& image, const Eigen::VectorXd& defect)
{
    const int column = stored_ < depth_ ? stored_++ : oldest_;
    if (stored_ == depth_) oldest_ = (column + 1) % depth_;
    imageDifferences_.col(column) = image - previousImage_;
    defectDifferences_.col(column) = defect - previousDefect_;
}

Eigen::VectorXd AndersonAcceleration::next(const Eigen::VectorXd& x, const Eigen::VectorXd& image)
{
    const Eigen::VectorXd defect = image - x;
    if (hasPrevious_) storeDifferences(image, defect);
    previousImage_ = image;
    previousDefect_ = defect;
    hasPrevious_ = true;
    if (stored_ == 0) return image;

    const auto differences = defectDifferences_.leftCols(stored_);
    Eigen::MatrixXd gram = differences.transpose()*weight_.asDiagonal()*differences;
    // Nearly parallel differences must not blow the mixing up.
    gram.diagonal() *= 1.0 + 1e-10;
    const Eigen::VectorXd gamma = gram.ldlt().solve(differences.transpose()*weight_.cwiseProduct(defect));
    if (!gamma.allFinite())
    {
        forget();
        return image;
    }
    return image - imageDifferences_.leftCols(stored_)*gamma;
}

} // namespace nscd
