// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A small dense system for the factors of layers, assembled in one pass over contacts and one over bodies.
#include "layerScaling.hpp"

#include "localContact.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Thickness of a layer in d. From 2 to 8 it makes no difference.
constexpr double thickness = 4.0;
/// A system of more unknowns would cost more than a sweep over as tall a bed.
constexpr int mostLayers = 100;
/// Scaling leaves each grain out of balance by its share, which raises the energy; but sweeps remove that soon, and so the minimum is
/// overshot, as over-correction does for aggregates in algebraic multigrid. From 3 on it diverges for 100 layers.
constexpr double overCorrection = 1.5;
/// Impulses are never taken below this share of themselves.
constexpr double leastFactor = 0.2;

Vec3 fallingDirection(const std::vector<Body>& bodies)
{
    Vec3 momentum = Vec3::Zero();
    for (const Body& body : bodies)
    {
        if (body.invMass > 0.0) momentum -= Vec3(body.v)/body.invMass;
    }
    return momentum.norm() > 0.0 ? Vec3(momentum.normalized()) : Vec3::Zero();
}

} // namespace

LayerScaling::LayerScaling(ContactProblem& problem)
:
    problem_(problem)
{
    const Vec3 up = fallingDirection(problem.bodies);
    const std::size_t movable = problem.position.size();
    height_.assign(movable, 0.0f);
    if (movable == 0) return;
    for (std::size_t body = 0; body < movable; ++body) height_[body] = static_cast<float>(up.dot(problem.position[body]));
    const auto [lowest, highest] = std::minmax_element(height_.begin(), height_.end());
    const float bottom = *lowest, extent = *highest - *lowest;
    const float layer = std::max(static_cast<float>(thickness*problem.diameter), extent/mostLayers);
    for (float& h : height_) h = (h - bottom)/layer + 0.5f;
    nodes_ = static_cast<int>(extent/layer) + nodesPerBody;
}

int LayerScaling::firstNode(int body) const { return static_cast<int>(height_[body] - 0.5f); }

LayerScaling::Place LayerScaling::place(const ContactBlock& block, int lane) const
{
    const std::size_t a = block.a[lane], b = block.b[lane];
    const float ha = height_[a], hb = b < height_.size() ? height_[b] : ha;
    // Farther apart: large bodies, or neighbors through a periodic side that layers are not normal to.
    if (std::abs(ha - hb) > 1.0f) return {-1, 0.0};
    const double height = 0.5*(ha + hb);
    const int lower = std::clamp(static_cast<int>(height), 0, nodes_ - 2);
    return {lower, height - lower};
}

void LayerScaling::addContact(const ContactBlock& block, int lane, std::vector<NodeSums>& sums)
{
    const Place at = place(block, lane);
    if (at.lower < 0) return;
    const Vec3 n(block.n[0][lane], block.n[1][lane], block.n[2][lane]), r(block.r[0][lane], block.r[1][lane], block.r[2][lane]);
    Eigen::Matrix<float, 6, 1> onA;
    onA << r.cast<float>(), -n.cross(r).cast<float>();
    const double share[2] = {1.0 - at.share, at.share};
    for (int k = 0; k < 2; ++k)
    {
        rightSide_[at.lower + k] -= share[k]*block.bias[lane]*r.dot(n);
        for (const bool isA : {true, false})
        {
            const int body = isA ? block.a[lane] : block.b[lane];
            if (!(problem_.bodies[body].invMass > 0.0)) continue;
            const int node = std::clamp(at.lower + k - firstNode(body), 0, nodesPerBody - 1);
            sums[body].col(node).head<3>() += static_cast<float>(isA ? share[k] : -share[k])*onA.head<3>();
            sums[body].col(node).tail<3>() += static_cast<float>(share[k])*onA.tail<3>();
        }
    }
}

void LayerScaling::addBody(int body, const NodeSums& sums)
{
    const Body& b = problem_.bodies[body];
    const Eigen::Matrix<double, 6, nodesPerBody> g = sums.cast<double>();
    Eigen::Matrix<double, 6, 1> mobility, velocity;
    mobility << Vec3::Constant(b.invMass), Vec3::Constant(b.invSpin);
    velocity << Vec3(b.v), Vec3(b.s);
    const int first = firstNode(body);
    matrix_.block<nodesPerBody, nodesPerBody>(first, first) += g.transpose()*mobility.asDiagonal()*g;
    rightSide_.segment<nodesPerBody>(first) -= g.transpose()*velocity;
}

double LayerScaling::apply()
{
    if (nodes_ == 0) return 0.0;
    matrix_.setZero(nodes_, nodes_);
    rightSide_.setZero(nodes_);
    std::vector<NodeSums> sums(height_.size(), NodeSums::Zero());
    const BlockRange active = problem_.active();
    for (std::size_t k = 0; k < active.count; ++k)
    {
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (isUsed(problem_.blocks[active[k]], lane)) addContact(problem_.blocks[active[k]], lane, sums);
        }
    }
    for (std::size_t body = 0; body < sums.size(); ++body) addBody(static_cast<int>(body), sums[body]);
    // A node without impulses gets factor 1; single precision in the sums asks for some regularization of the others.
    for (int k = 0; k < nodes_; ++k) matrix_(k, k) = matrix_(k, k) > 0.0 ? (1.0 + 1e-6)*matrix_(k, k) : 1.0;
    const Eigen::VectorXd delta = matrix_.ldlt().solve(rightSide_);
    if (!delta.allFinite()) return 0.0;
    scale(overCorrection*delta);
    return delta.cwiseAbs().maxCoeff();
}

void LayerScaling::scale(const Eigen::VectorXd& delta)
{
    const BlockRange active = problem_.active();
    std::vector<double> target(3*blockLanes*active.count, 0.0);
    for (std::size_t k = 0; k < active.count; ++k)
    {
        const ContactBlock& block = problem_.blocks[active[k]];
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (!isUsed(block, lane)) continue;
            const Place at = place(block, lane);
            const double change = at.lower < 0 ? 0.0 : (1.0 - at.share)*delta[at.lower] + at.share*delta[at.lower + 1];
            const double factor = std::max(leastFactor, 1.0 + change);
            for (int m = 0; m < 3; ++m) target[(3*k + m)*blockLanes + lane] = factor*block.r[m][lane];
        }
    }
    replaceImpulses(problem_, target);
}

} // namespace nscd
