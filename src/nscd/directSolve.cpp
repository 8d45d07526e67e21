// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Multipliers, slips and the set of contacts of a direct solve; its price.
#include "directSolve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace nscd
{

namespace
{

double stiffness = getenv("STIFF") ? atof(getenv("STIFF")) : 1e8;
constexpr int maxRounds = 30;
/// Rounds without a smaller residual after which the solve gives up.
constexpr int patience = 4;

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

/// How far a residual is beyond the rule: up to 1 is within.
double excess(const DefectSums& sums, const StopRule& rule)
{
    return std::max(rms(sums)/rule.rmsLimit, std::sqrt(sums.maxSquare)/rule.maxLimit);
}

/// Impulses and velocities to go back to.
struct Snapshot
{
    std::vector<Body> bodies;
    std::vector<Vec3> impulses;
    double excess = std::numeric_limits<double>::infinity();
};

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

double DirectSolve::price(double limit) const
{
    // Measured: a Newton step costs as much beside the factorization as 30 visits of each contact in a sweep, a visit as much as ten multiplications.
    constexpr double steps = 15.0, visitsPerContact = 30.0, multiplicationsPerVisit = 10.0;
    constexpr double mostMultiplications = 1e11;
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
    for (const ConeContact& c : solved.contacts())
    {
        ContactBlock& block = problem_.blocks[c.slot/blockLanes];
        for (int k = 0; k < 3; ++k) block.r[k][c.slot % blockLanes] = c.impulse[k];
    }
    const Eigen::VectorXd x = solved.motion();
    for (std::size_t k = 0; k < bodies_.size(); ++k)
    {
        std::copy_n(&x[6*k], 3, problem_.bodies[bodies_[k]].v);
        if (problem_.isFrictional) std::copy_n(&x[6*k + 3], 3, problem_.bodies[bodies_[k]].s);
    }
}

double DirectSolve::run(const StopRule& rule, double fineness)
{
    const bool verbose = getenv("VERB");
    std::vector<Body> bodies = problem_.bodies;
    std::vector<ContactBlock> blocks = problem_.blocks;
    double best = excess(residual(problem_), rule);
    int sinceBest = 0, steps = 0;
    if (verbose) printf("direct: %zu contacts %zu bodies, start excess %g\n", slots_.size(), bodies_.size(), best);
    std::unique_ptr<ConvexContact> convex = build();
    Eigen::VectorXd x = motion();
    for (int round = 0; round < maxRounds && best > fineness && sinceBest < patience; ++round)
    {
        for (ConeContact& c : convex->contacts())
        {
            const Vec3 u = convex->relativeVelocity(c, x);
            c.multiplier = c.impulse;
            c.slip = c.impulse == Vec3::Zero() ? 0.0 : (u - u.dot(c.n)*c.n).norm();
        }
        int n = convex->minimize(x, 0.1*fineness*rule.rmsLimit);
        steps += n;
        store(*convex);
        const double now = excess(residual(problem_), rule);
        if (verbose) printf("  round %d: %d steps, excess %g\n", round, n, now);
        ++sinceBest;
        if (now < best)
        {
            best = now;
            bodies = problem_.bodies;
            blocks = problem_.blocks;
            sinceBest = 0;
        }
        if (collect(fineness*rule.rmsLimit))
        {
            convex = build();
            x = motion();
            if (verbose) printf("  grown to %zu contacts\n", slots_.size());
        }
    }
    problem_.bodies = bodies;
    problem_.blocks = blocks;
    return steps;
}

SolveReport solveDirect(ContactProblem& problem, const ContactSettings& settings)
{
    SolveReport report;
    if (problem.blocks.empty()) return report;
    const StopRule rule = makeStopRule(problem, settings, residual(problem));
    DirectSolve direct(problem);
    report.sweeps = direct.run(rule, rule.polish);
    wakeBlocks(problem);
    reportResidual(report, rule, residual(problem));
    if (report.converged) return report;
    const int steps = report.sweeps;
    if (getenv("VERB")) printf("finishing by sweeps\n");
    report = solveNlgs(problem, settings);
    report.sweeps += steps;
    return report;
}

} // namespace nscd
