// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Exact volume of a ball inside a polyhedron, and exact area of a disc inside a polygon, face by face.
//
// The field G(x) = x/3 for |x| <= R and R^3 x/(3 |x|^3) beyond (x from the center of the ball) is continuous, and its
// divergence is 1 in the ball and 0 outside. So the volume of ball and polyhedron is the flux of G out of the polyhedron,
// a sum over faces of h times the integral of min(1, (R/r)^3)/3 over the face, h the signed distance of the face's plane.
//
// Around the foot F of the center on the plane, in polar coordinates, the part of the face seen under dphi out to the
// distance S gives |h| S^2/6 dphi as long as r^2 = h^2 + S^2 <= R^2, and beyond that
//     [(R^3/3)(1 - |h|/r) - (R - |h|)^2 (2R + |h|)/6] dphi,
// the second term, a spherical cap over 2 pi, only if |h| < R. The integral of (1 - |h|/r) dphi along a piece of an edge is
// the solid angle of the triangle (F, piece). Hence a face gives, with each edge cut where it enters and leaves the ball,
//     sign(h) { |h|/6 sum_inside p x q + (R^3/3) Omega_outside - cap/(2 pi) phi_outside },
// p x q twice the area of (F, piece), phi its angle at F. It is smooth in the center: the face's plane, edges and corners
// are no special places, for the terms that jump there carry the factor h or cancel as h -> 0.
// In the plane likewise with G = x/2 and R^2 x/(2 r^2): twice the area is the sum of p x q inside and R^2 phi outside.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace closures
{

/// Volume of the ball in a polyhedron that one face answers for; the sum over all faces is the volume itself.
/// A neighbor across the face takes the same number with the opposite sign, so shares of a filled space add up exactly.
/// Shapes:   vertices [nVertices], in order, counterclockwise around areaNormal, in one plane (else triangulate);
///           any simple polygon; areaNormal of any length, pointing out of the polyhedron
/// Units:    m, m3
/// Ensures:  the sum over a closed polyhedron, convex or not, is exact to 1e-13 of the ball's volume, for any position of
///           the center; polyhedra that miss the ball give round-off of that size, of either sign
double ballFaceContribution
(
    const Eigen::Vector3d& center, double radius,
    const Eigen::Vector3d* vertices, int nVertices, const Eigen::Vector3d& areaNormal
);

/// Area of the disc in a polygon that the edge from start to end answers for; the polygon lies to its left.
/// The sum over a closed polygon, convex or not, is the area; the reversed edge gives minus the number.
/// Units:    m, m2
/// Ensures:  exact to 1e-14 of the disc's area, for any position of the center
double discEdgeContribution
(
    const Eigen::Vector2d& center, double radius, const Eigen::Vector2d& start, const Eigen::Vector2d& end
);

} // namespace closures
