// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Order of elimination, price, assembly and solution.
#include "nscd/solvers/direct/contactStiffness.hpp"

#include <algorithm>
#include <limits>

namespace nscd
{

ContactStiffness::ContactStiffness(const std::vector<JoinedBodies>& contacts, int bodies, MotionComponents components)
:
    contacts_(contacts),
    components_(std::move(components)),
    size_(static_cast<int>(components_.size()))
{
    orderBodies(bodies);
    connect(bodies);
}

void ContactStiffness::orderBodies(int bodies)
{
    std::vector<Eigen::Triplet<double, int>> entries;
    for (const JoinedBodies& joined : contacts_)
    {
        if (joined[0] < 0 || joined[1] < 0) continue;
        entries.emplace_back(joined[0], joined[1], 1.0);
        entries.emplace_back(joined[1], joined[0], 1.0);
    }
    for (int body = 0; body < bodies; ++body) entries.emplace_back(body, body, 1.0);
    Eigen::SparseMatrix<double> graph(bodies, bodies);
    graph.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph, order);
    place_.resize(bodies);
    for (int place = 0; place < bodies; ++place) place_[order.indices()[place]] = place;
}

void ContactStiffness::connect(int bodies)
{
    earlier_.resize(bodies);
    for (JoinedBodies& joined : contacts_)
    {
        for (int& body : joined) body = body < 0 ? -1 : place_[body];
        const int later = std::max(joined[0], joined[1]), before = std::min(joined[0], joined[1]);
        if (before >= 0) earlier_[later].push_back(before);
    }
    for (std::vector<int>& bodiesBefore : earlier_)
    {
        std::sort(bodiesBefore.begin(), bodiesBefore.end());
        bodiesBefore.erase(std::unique(bodiesBefore.begin(), bodiesBefore.end()), bodiesBefore.end());
    }
}

double ContactStiffness::analyze(double limit)
{
    // Liu's elimination tree: the row of a body in the factor is found by walking up from its earlier neighbors.
    const int bodies = static_cast<int>(earlier_.size());
    std::vector<int> parent(bodies, -1), mark(bodies, -1), below(bodies, 0);
    double multiplications = 0.0;
    const auto cost = [this](double blocks) { return size_*(blocks*size_)*(blocks*size_); };
    for (int body = 0; body < bodies; ++body)
    {
        mark[body] = body;
        multiplications += cost(1.0);
        for (int before : earlier_[body])
        {
            for (int k = before; mark[k] != body; k = parent[k])
            {
                if (parent[k] < 0) parent[k] = body;
                mark[k] = body;
                multiplications += cost(below[k] + 2.0) - cost(below[k] + 1.0);
                ++below[k];
            }
        }
        if (multiplications > limit) return std::numeric_limits<double>::infinity();
    }
    return multiplications;
}

void ContactStiffness::layOut()
{
    start_.resize(earlier_.size());
    const int size = size_*static_cast<int>(earlier_.size());
    matrix_.resize(size, size);
    Eigen::Index total = 0;
    for (std::size_t body = 0; body < earlier_.size(); ++body)
    {
        start_[body] = total;
        total += size_*size_*static_cast<Eigen::Index>(earlier_[body].size()) + size_*(size_ + 1)/2;
    }
    matrix_.resizeNonZeros(total);
    int* rows = matrix_.innerIndexPtr();
    int* columns = matrix_.outerIndexPtr();
    for (int body = 0; body < static_cast<int>(earlier_.size()); ++body)
    {
        for (int c = 0; c < size_; ++c)
        {
            *columns++ = static_cast<int>(column(body, c));
            for (int before : earlier_[body])
            {
                for (int r = 0; r < size_; ++r) *rows++ = size_*before + r;
            }
            for (int r = 0; r <= c; ++r) *rows++ = size_*body + r;
        }
    }
    *columns = static_cast<int>(total);

    blockOf_.assign(contacts_.size(), -1);
    for (std::size_t k = 0; k < contacts_.size(); ++k)
    {
        const int later = std::max(contacts_[k][0], contacts_[k][1]), before = std::min(contacts_[k][0], contacts_[k][1]);
        if (before < 0) continue;
        const std::vector<int>& list = earlier_[later];
        blockOf_[k] = static_cast<int>(std::lower_bound(list.begin(), list.end(), before) - list.begin());
    }
    factors_.analyzePattern(matrix_);
}

void ContactStiffness::start(const Eigen::VectorXd& mass)
{
    if (start_.empty()) layOut();
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
    for (std::size_t body = 0; body < place_.size(); ++body)
    {
        addDiagonal(place_[body], mass.segment<6>(6*static_cast<Eigen::Index>(body)).asDiagonal());
    }
}

void ContactStiffness::addDiagonal(int body, const Block& block)
{
    const Eigen::Index before = size_*static_cast<Eigen::Index>(earlier_[body].size());
    for (int c = 0; c < size_; ++c)
    {
        double* values = matrix_.valuePtr() + column(body, c) + before;
        for (int r = 0; r <= c; ++r) values[r] += block(components_[r], components_[c]);
    }
}

void ContactStiffness::addOffDiagonal(std::size_t contact, const Block& ab)
{
    const bool isALater = contacts_[contact][0] > contacts_[contact][1];
    const int later = contacts_[contact][isALater ? 0 : 1];
    for (int c = 0; c < size_; ++c)
    {
        double* values = matrix_.valuePtr() + column(later, c) + size_*blockOf_[contact];
        for (int r = 0; r < size_; ++r)
        {
            values[r] += isALater ? ab(components_[c], components_[r]) : ab(components_[r], components_[c]);
        }
    }
}

void ContactStiffness::add(std::size_t contact, const Vec3& n, const Eigen::Matrix3d& d)
{
    const Eigen::Matrix3d cross = crossMatrix(n), coupled = d*cross, turned = -cross*coupled;
    Block block;
    block << d, coupled, coupled.transpose(), turned;
    if (contacts_[contact][0] >= 0) addDiagonal(contacts_[contact][0], block);
    if (contacts_[contact][1] < 0) return;
    block << d, -coupled, -coupled.transpose(), turned;
    addDiagonal(contacts_[contact][1], block);
    if (contacts_[contact][0] < 0) return;
    block << -d, coupled, -coupled.transpose(), turned;
    addOffDiagonal(contact, block);
}

bool ContactStiffness::factorize()
{
    factors_.factorize(matrix_);
    return factors_.info() == Eigen::Success;
}

Eigen::VectorXd ContactStiffness::solve(const Eigen::VectorXd& right) const
{
    Eigen::VectorXd inOrder(matrix_.cols());
    for (std::size_t body = 0; body < place_.size(); ++body)
    {
        for (int c = 0; c < size_; ++c) inOrder[size_*place_[body] + c] = right[6*static_cast<Eigen::Index>(body) + components_[c]];
    }
    const Eigen::VectorXd solution = factors_.solve(inOrder);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(right.size());
    for (std::size_t body = 0; body < place_.size(); ++body)
    {
        for (int c = 0; c < size_; ++c) result[6*static_cast<Eigen::Index>(body) + components_[c]] = solution[size_*place_[body] + c];
    }
    return result;
}

} // namespace nscd
