// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Multipliers, slips and the set of contacts of a direct solve; its price.
#include "nscd/solvers/direct/directSolve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

// Of contacts against the mobility of their bodies: a stack of 1000 needs 1e8 for two digits a round; what is left of 16 digits suffices.
constexpr double stiffness = 1e8;
/// Newton steps, and rounds without a smaller residual, after which a solve gives up.
constexpr int maxSteps = 150;
constexpr int patience = 4;
/// Wider cones are too far from round for the smoothing: left to sweeps.
constexpr double largestFriction = 5.0;
/// A round is solved to this share of what it is meant to leave, which is this share of what it found.
constexpr double leastAccuracy = 0.1, leastProgress = 0.1;
/// A solution within the rule is not worth rounds that leave more than this share: slips that go on settling.
constexpr double slowProgress = 0.3;

double normalMobility(const Body& a, const Body& b) { return a.invMass + b.invMass; }

Vec3 velocity(const Body& body) { return Vec3(body.v); }
Vec3 spin(const Body& body) { return Vec3(body.s); }

/// A slot of a problem, as vectors.
struct SlotView
{
    const ContactBlock& block;
    int lane;

    SlotView(const ContactProblem& problem, std::size_t slot) : block(problem.blocks[slot/blockLanes]), lane(slot % blockLanes) {}
    Vec3 normal() const { return Vec3(block.n[0][lane], block.n[1][lane], block.n[2][lane]); }
    Vec3 impulse() const { return Vec3(block.r[0][lane], block.r[1][lane], block.r[2][lane]); }
    std::array<int, 2> bodies() const { return {block.a[lane], block.b[lane]}; }
};

void setImpulse(ContactProblem& problem, std::size_t slot, const Vec3& r)
{
    for (int k = 0; k < 3; ++k) problem.blocks[slot/blockLanes].r[k][slot % blockLanes] = r[k];
}

} // namespace

DirectSolve::DirectSolve(ContactProblem& problem)
:
    problem_(problem),
    isTaken_(problem.blocks.size()*blockLanes, 0),
    number_(problem.bodies.size(), -1)
{
    collect(0.0);
}

bool DirectSolve::collect(double leastApproach)
{
    const std::size_t before = slots_.size();
    for (std::size_t slot = 0; slot < isTaken_.size(); ++slot)
    {
        const SlotView view(problem_, slot);
        const Body& a = problem_.bodies[view.bodies()[0]];
        const Body& b = problem_.bodies[view.bodies()[1]];
        if (isTaken_[slot] || !(normalMobility(a, b) > 0.0)) continue;
        const double bias = view.block.bias[view.lane];
        const double approach = -view.normal().dot(velocity(a) - velocity(b)) - bias;
        if (!(bias == 0.0 || approach > leastApproach || view.impulse() != Vec3::Zero())) continue;
        isTaken_[slot] = 1;
        slots_.push_back(slot);
        for (int body : view.bodies())
        {
            if (problem_.bodies[body].invMass == 0.0 || number_[body] >= 0) continue;
            number_[body] = static_cast<int>(bodies_.size());
            bodies_.push_back(body);
        }
    }
    return slots_.size() != before;
}

JoinedBodies DirectSolve::joined(std::size_t slot) const
{
    const std::array<int, 2> bodies = SlotView(problem_, slot).bodies();
    return {number_[bodies[0]], number_[bodies[1]]};
}

MotionComponents DirectSolve::components() const
{
    if (!problem_.isFrictional) return {0, 1, 2};
    for (int axis = 0; axis < 3; ++axis)
    {
        const int first = (axis + 1) % 3, second = (axis + 2) % 3;
        const bool isPlanar = std::all_of(slots_.begin(), slots_.end(), [&](std::size_t slot)
        {
            const SlotView view(problem_, slot);
            const auto isInPlane = [&](int k)
            {
                const Body& body = problem_.bodies[k];
                return body.v[axis] == 0.0 && body.s[first] == 0.0 && body.s[second] == 0.0;
            };
            return view.normal()[axis] == 0.0 && view.impulse()[axis] == 0.0 && isInPlane(view.bodies()[0]) && isInPlane(view.bodies()[1]);
        });
        if (isPlanar) return {first, second, 3 + axis};
    }
    return {0, 1, 2, 3, 4, 5};
}

bool DirectSolve::isWithinReach() const
{
    return !slots_.empty() && !problem_.lawBlocks && std::all_of(slots_.begin(), slots_.end(), [&](std::size_t slot)
    {
        const SlotView view(problem_, slot);
        return view.block.friction[view.lane] <= largestFriction;
    });
}

double DirectSolve::price(double limit) const
{
    // Measured: Newton steps from cold, and what one costs beside the factorization and in it.
    constexpr double steps = 60.0, visitsPerContact = 70.0, multiplicationsPerVisit = 10.0;
    constexpr double mostMultiplications = 1e10;
    constexpr std::size_t mostBodies = 20000;
    if (bodies_.size() > mostBodies || !isWithinReach()) return std::numeric_limits<double>::infinity();
    std::vector<JoinedBodies> joinedBodies;
    for (std::size_t slot : slots_) joinedBodies.push_back(joined(slot));
    ContactStiffness matrix(joinedBodies, static_cast<int>(bodies_.size()), components());
    const double visits = static_cast<double>(blockLanes*problem_.active().count);
    const double most = std::min(mostMultiplications, multiplicationsPerVisit*visits*limit/steps);
    return steps*(matrix.analyze(most)/multiplicationsPerVisit + visitsPerContact*slots_.size())/std::max(1.0, visits);
}

std::unique_ptr<ConvexContact> DirectSolve::build() const
{
    std::vector<ConeContact> contacts(slots_.size());
    for (std::size_t k = 0; k < slots_.size(); ++k)
    {
        const SlotView view(problem_, slots_[k]);
        ConeContact& c = contacts[k];
        c.slot = slots_[k];
        c.joined = joined(slots_[k]);
        c.n = view.normal();
        c.wallVelocity.setZero();
        for (int side = 0; side < 2; ++side)
        {
            const Body& body = problem_.bodies[view.bodies()[side]];
            if (c.joined[side] >= 0) continue;
            c.wallVelocity += (side == 0 ? velocity(body) : Vec3(-velocity(body))) + c.n.cross(spin(body));
        }
        c.bias = view.block.bias[view.lane];
        c.friction = problem_.isFrictional ? view.block.friction[view.lane] : 0.0;
        c.penalty = stiffness/normalMobility(problem_.bodies[view.bodies()[0]], problem_.bodies[view.bodies()[1]]);
        c.impulse = c.multiplier = view.impulse();
    }
    Eigen::VectorXd mass(6*bodies_.size());
    for (std::size_t k = 0; k < bodies_.size(); ++k)
    {
        const Body& body = problem_.bodies[bodies_[k]];
        mass.segment<3>(6*k).setConstant(1.0/body.invMass);
        mass.segment<3>(6*k + 3).setConstant(1.0/body.invSpin);
    }
    return std::make_unique<ConvexContact>(std::move(contacts), motion(), std::move(mass), components());
}

Eigen::VectorXd DirectSolve::motion() const
{
    Eigen::VectorXd x(6*bodies_.size());
    for (std::size_t k = 0; k < bodies_.size(); ++k) x.segment<6>(6*k) << velocity(problem_.bodies[bodies_[k]]), spin(problem_.bodies[bodies_[k]]);
    return x;
}

void DirectSolve::store(const ConvexContact& solved)
{
    for (const ConeContact& c : solved.contacts()) setImpulse(problem_, c.slot, c.impulse);
    const Eigen::VectorXd x = solved.motion();
    for (std::size_t k = 0; k < bodies_.size(); ++k)
    {
        std::copy_n(&x[6*k], 3, problem_.bodies[bodies_[k]].v);
        if (problem_.isFrictional) std::copy_n(&x[6*k + 3], 3, problem_.bodies[bodies_[k]].s);
    }
}

int DirectSolve::run(const StopRule& rule, double fineness)
{
    Snapshot best = snapshot(rule);
    if (!isWithinReach()) return 0;
    std::unique_ptr<ConvexContact> convex = build();
    Eigen::VectorXd x = motion();
    double before = best.excess;
    int steps = 0, sinceBest = 0;
    for (int round = 0; steps < maxSteps && before > fineness && sinceBest < patience; ++round)
    {
        for (ConeContact& c : convex->contacts())
        {
            // Nothing is known of slips at first, and free motion tells wrong ones: a heap at rest has none.
            const Vec3 u = convex->relativeVelocity(c, x);
            c.slip = round == 0 ? 0.0 : (u - u.dot(c.n)*c.n).norm();
            c.multiplier = c.impulse;
        }
        const double limit = leastAccuracy*std::max(fineness, leastProgress*std::min(best.excess, before))*rule.rmsLimit;
        steps += convex->minimize(x, limit, std::sqrt(residual(problem_).maxSquare), std::sqrt(1e-3*limit*rule.speedScale/stiffness));
        store(*convex);
        Snapshot now = snapshot(rule);
        const bool isSlow = now.excess > slowProgress*before;
        before = now.excess;
        ++sinceBest;
        if (now.excess < best.excess)
        {
            best = std::move(now);
            sinceBest = 0;
        }
        if (collect(fineness*rule.rmsLimit))
        {
            convex = build();
            x = motion();
        }
        else if (isSlow && best.excess <= 1.0) break;
    }
    restore(best);
    return steps;
}

DirectSolve::Snapshot DirectSolve::snapshot(const StopRule& rule) const
{
    const DefectSums sums = residual(problem_);
    Snapshot taken{problem_.bodies, {}, std::max(rms(sums)/rule.rmsLimit, std::sqrt(sums.maxSquare)/rule.maxLimit)};
    for (std::size_t slot : slots_) taken.impulses.push_back(SlotView(problem_, slot).impulse());
    return taken;
}

void DirectSolve::restore(const Snapshot& taken)
{
    problem_.bodies = taken.bodies;
    for (std::size_t k = 0; k < slots_.size(); ++k)
    {
        // Contacts that joined after it was taken carried nothing then.
        const Vec3 r = k < taken.impulses.size() ? taken.impulses[k] : Vec3(Vec3::Zero());
        setImpulse(problem_, slots_[k], r);
    }
}

} // namespace nscd
