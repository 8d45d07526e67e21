// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Anderson acceleration of a fixed-point map of contact impulses.
#pragma once

#include <Eigen/Core>

namespace nscd
{

/// Anderson mixing of depth m for x -> F(x) in a weighted norm (Walker & Ni 2011, eq. 2.2, difference form):
/// with f = F(x) - x, x_new = F(x) - (dX + dF) gamma, gamma = argmin |f - dF gamma|_w over the last m differences.
class AndersonAcceleration
{
public:
    /// `weight` [n]: the squared norm is sum of weight_i x_i^2.
    AndersonAcceleration(Eigen::VectorXd weight, int depth);

    /// The next iterate from x and F(x); F(x) itself until there are differences to mix.
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

    void forget() { stored_ = 0; hasPrevious_ = false; }

private:
    void storeDifferences(const Eigen::VectorXd& image, const Eigen::VectorXd& defect);

    Eigen::VectorXd weight_;
    int depth_;
    int stored_ = 0;
    int oldest_ = 0;
    bool hasPrevious_ = false;
    Eigen::MatrixXd imageDifferences_;
    Eigen::MatrixXd defectDifferences_;
    Eigen::VectorXd previousImage_;
    Eigen::VectorXd previousDefect_;
};

} // namespace nscd
