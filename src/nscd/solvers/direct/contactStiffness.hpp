// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The sparse matrix M + sum of B^T D B of bodies joined by contacts, and its Cholesky factors.
#pragma once

#include "nscd/base/vec3.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace nscd
{

/// Components of a body's motion (v x, y, z, then s x, y, z) that can be other than zero: six, fewer in the plane or without friction.
using MotionComponents = std::vector<int>;

/// Two bodies by their number in a system; -1: one that does not move.
using JoinedBodies = std::array<int, 2>;

/// M + sum over contacts of B^T D B, where u = B x is the relative velocity of a contact: B_A = [1, n x], B_B = [-1, n x].
/// Bodies are eliminated in the approximate minimum degree order of their graph (Amestoy, Davis & Duff 1996).
class ContactStiffness
{
public:
    ContactStiffness(const std::vector<JoinedBodies>& contacts, int bodies, MotionComponents components);

    /// Multiplications of one factorization; infinite when they would exceed `limit` given to analyze().
    double analyze(double limit);

    /// Starts a new matrix: `mass` holds six numbers a body.
    void start(const Eigen::VectorXd& mass);
    /// Adds B^T D B of a contact with unit normal n; D symmetric.
    void add(std::size_t contact, const Vec3& n, const Eigen::Matrix3d& d);
    /// Returns whether the matrix turned out positive definite.
    bool factorize();
    /// Solves for six numbers a body.
    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

private:
    using Block = Eigen::Matrix<double, 6, 6>;

    void orderBodies(int bodies);
    void connect(int bodies);
    void layOut();
    void addDiagonal(int body, const Block& block);
    void addOffDiagonal(std::size_t contact, const Block& ab);
    Eigen::Index column(int body, int c) const { return start_[body] + c*size_*static_cast<Eigen::Index>(earlier_[body].size()) + c*(c + 1)/2; }

    std::vector<JoinedBodies> contacts_;   ///< by place in the order of elimination
    MotionComponents components_;
    int size_;                             ///< components of a body
    std::vector<int> place_;               ///< of each body in the order of elimination
    std::vector<std::vector<int>> earlier_;   ///< neighbors eliminated before, ascending
    std::vector<Eigen::Index> start_;      ///< of each body's columns among the values
    std::vector<int> blockOf_;             ///< of each contact, in the later body's columns
    Eigen::SparseMatrix<double> matrix_;   ///< upper triangle
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>> factors_;
    bool isAnalyzed_ = false;
};

} // namespace nscd
