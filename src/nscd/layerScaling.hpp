// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A coarse correction for contact solves that are slow since weight has many layers to pass through.
#pragma once

#include "contactSolver.hpp"

#include <Eigen/Core>

namespace nscd
{

/// Scales impulses by factors that vary linearly between layers across the direction in which the grains are falling:
/// r_c <- (1 + sum of phi_k(c) delta_k) r_c, with hat functions phi_k. delta minimizes the energy of the dual problem,
/// 1/2 r.W r + r.(u_free + b): A delta = -c, A_kl = sum over the bodies of G_k.M^-1 G_l, where G_k is the sum of phi_k r over a body's contacts (force
/// and moment), c_k = sum over the contacts of phi_k r.(u + b n). A positive factor keeps an impulse in its friction cone.
/// For one rank: bodies of others are not summed.
class LayerScaling
{
public:
    /// For a problem whose bodies lie at its positions.
    explicit LayerScaling(ContactProblem& problem);

    /// Scales the impulses of the active blocks, and returns the largest |delta|; 0 if there are no layers to speak of.
    double apply();

private:
    static constexpr int nodesPerBody = 3;
    /// Hat functions at a contact: `lower` and the one above, which weighs `share`. lower < 0: the contact takes no part.
    struct Place
    {
        int lower;
        double share;
    };
    /// Sums of phi r (force, moment) of a body's contacts at its nodes.
    using NodeSums = Eigen::Matrix<float, 6, nodesPerBody>;

    Place place(const ContactBlock& block, int lane) const;
    void addContact(const ContactBlock& block, int lane, std::vector<NodeSums>& sums);
    void addBody(int body, const NodeSums& sums);
    void scale(const Eigen::VectorXd& delta);
    int firstNode(int body) const;

    ContactProblem& problem_;
    std::vector<float> height_;   ///< of each body, in layers
    int nodes_ = 0;
    Eigen::MatrixXd matrix_;
    Eigen::VectorXd rightSide_;
};

} // namespace nscd
