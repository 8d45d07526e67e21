// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Polyhedra and random points for the tests of ball and cell.
#pragma once

#include "closures/sphereOverlap.hpp"

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace overlapShapes
{

using Eigen::Vector3d;

inline const double pi = std::acos(-1.0);

using Face = std::vector<Vector3d>;
using Polyhedron = std::vector<Face>;

inline Vector3d areaNormal(const Face& face)
{
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) sum += face[i].cross(face[(i + 1)%face.size()])/2;
    return sum;
}

inline double overlap(const Polyhedron& cell, const Vector3d& center, double radius)
{
    double sum = 0;
    for (const Face& face : cell)
    {
        sum += closures::ballFaceContribution(center, radius, face.data(), int(face.size()), areaNormal(face));
    }
    return sum;
}

inline double ballVolume(double radius)
{
    return 4*pi*radius*radius*radius/3;
}

/// Corners of a hexahedron by bits: 1 is x, 2 is y, 4 is z; quadrilaterals outward.
constexpr int hexFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

inline Polyhedron box(const Vector3d& low, const Vector3d& high)
{
    Polyhedron cell;
    for (const auto& corners : hexFaces)
    {
        Face face;
        for (int c : corners)
        {
            face.emplace_back(c & 1 ? high.x() : low.x(), c & 2 ? high.y() : low.y(), c & 4 ? high.z() : low.z());
        }
        cell.push_back(face);
    }
    return cell;
}

/// Hexahedron with any eight corners: every quadrilateral cut into triangles at the corner named by cutAt.
template <class CutAt>
Polyhedron hexOfTriangles(const std::array<Vector3d, 8>& p, CutAt cutAt)
{
    Polyhedron cell;
    for (const auto& c : hexFaces)
    {
        const int s = cutAt(c);
        for (int k : {1, 2}) cell.push_back({p[c[s]], p[c[(s + k)%4]], p[c[(s + k + 1)%4]]});
    }
    return cell;
}

inline Polyhedron tetrahedron(Vector3d a, Vector3d b, const Vector3d& c, const Vector3d& d)
{
    if ((b - a).cross(c - a).dot(d - a) < 0) std::swap(a, b);
    return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

class RandomPoints
{
public:
    explicit RandomPoints(unsigned seed) : generator_(seed) {}
    double number(double low, double high) { return low + (high - low)*(generator_()/4294967296.0); }
    Vector3d point(double low, double high)
    {
        const double x = number(low, high), y = number(low, high);
        return {x, y, number(low, high)};
    }

private:
    std::mt19937 generator_;
};

} // namespace overlapShapes
