// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Implementation of sphereOverlap.hpp.
#include "closures/sphereOverlap.hpp"

#include <algorithm>
#include <cmath>

namespace closures
{

namespace
{

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

/// Sum of angles, each given by sine and cosine times a common positive factor: a product of complex numbers whose turns
/// are counted, so that a face costs one arc tangent and not one per edge.
class AngleSum
{
public:
    /// Adds the angle of (cosine, sine), which lies in (-pi, pi).
    void add(double sine, double cosine)
    {
        const double re = re_*cosine - im_*sine;
        const double im = re_*sine + im_*cosine;
        const double size = std::abs(re) + std::abs(im);
        // A product of zero has no angle: a piece without length whose end is the foot itself.
        if (size == 0) return;
        if (sine > 0 && im_ >= 0 && im < 0) ++turns_;
        if (sine < 0 && im_ < 0 && im >= 0) --turns_;
        // Lengths in any unit and faces of any number of edges must not overflow.
        const double scale = size > tooLarge || size < tooSmall ? 1/size : 1;
        re_ = scale*re;
        im_ = scale*im;
    }

    double sum() const
    {
        return im_ == 0 && re_ > 0 ? 2*pi*turns_ : 2*pi*turns_ + std::atan2(im_, re_);
    }

private:
    static constexpr double tooLarge = 1e100;
    static constexpr double tooSmall = 1e-100;

    double re_ = 1;
    double im_ = 0;
    int turns_ = 0;
};

/// Part of an edge that lies in the ball, in the edge's own coordinate t from the foot of the center.
struct Chord
{
    double begin;
    double end;
    bool isEmpty() const { return end <= begin; }
};

/// The interval of [t1, t2] within a ball of radius^2 r2 whose center is sqrt(line2) off the line.
Chord clipEdge(double t1, double t2, double line2, double r2)
{
    if (line2 >= r2) return {0, 0};
    const double half = std::sqrt(r2 - line2);
    return {std::max(t1, -half), std::min(t2, half)};
}

/// A corner of a face seen from the center.
struct Corner
{
    Vector3d position;
    double distance2;
    double distance;
};

Corner cornerAt(const Vector3d& position)
{
    const double distance2 = position.squaredNorm();
    return {position, distance2, std::sqrt(distance2)};
}

/// Collects the three sums of the formula over the edges of one face.
class FaceSums
{
public:
    FaceSums(double radius, double height)
    :
        radius_(radius), radius2_(radius*radius), height_(height), height2_(height*height)
    {}

    /// The edge from a to b; cross: twice the signed area of (F, a, b).
    void addEdge(const Corner& a, const Corner& b, double cross)
    {
        if (a.distance2 <= radius2_ && b.distance2 <= radius2_)
        {
            inside_ += cross;
            return;
        }
        const Vector3d edge = b.position - a.position;
        const double length2 = edge.squaredNorm();
        if (cross*cross >= (radius2_ - height2_)*length2)
        {
            addOutside(cross, a.position.dot(b.position), a.distance, b.distance);
            return;
        }
        addCutEdge(a, b, a.position.dot(edge), std::sqrt(length2), cross);
    }

    double total() const
    {
        const double depth = radius_ - height_;
        const double cap = depth*depth*(2*radius_ + height_)/6;
        return height_*inside_/6 + 2*radius2_*radius_/3*halfSolidAngle_.sum() - cap*angle_.sum();
    }

private:
    void addCutEdge(const Corner& a, const Corner& b, double aDotEdge, double length, double cross)
    {
        const double offset = cross/length;
        const double line2 = height2_ + offset*offset;
        const double t1 = aDotEdge/length;
        const double t2 = t1 + length;
        const Chord chord = clipEdge(t1, t2, line2, radius2_);
        if (chord.isEmpty())
        {
            addOutside(cross, line2 + t1*t2, a.distance, b.distance);
            return;
        }
        inside_ += offset*(chord.end - chord.begin);
        if (t1 < chord.begin) addOutside(offset*(chord.begin - t1), line2 + t1*chord.begin, a.distance, radius_);
        if (chord.end < t2) addOutside(offset*(t2 - chord.end), line2 + t2*chord.end, radius_, b.distance);
    }

    /// A piece outside the ball with ends at distances ra, rb; dot: scalar product of its ends seen from the center.
    /// Half the solid angle of (F, piece) after van Oosterom & Strackee 1983, divided by |h|, so that h = 0 is regular.
    void addOutside(double cross, double dot, double ra, double rb)
    {
        halfSolidAngle_.add(cross, (ra + height_)*(rb + height_) + dot - height2_);
        if (height_ < radius_) angle_.add(cross, dot - height2_);
    }

    double radius_;
    double radius2_;
    double height_;
    double height2_;
    double inside_ = 0;
    AngleSum halfSolidAngle_;
    AngleSum angle_;
};

double cross2(const Vector2d& a, const Vector2d& b)
{
    return a.x()*b.y() - a.y()*b.x();
}

} // namespace

double ballFaceContribution
(
    const Vector3d& center, double radius, const Vector3d* vertices, int nVertices, const Vector3d& areaNormal
)
{
    const Vector3d normal = areaNormal.normalized();
    const Corner first = cornerAt(vertices[0] - center);
    const double height = normal.dot(first.position);

    FaceSums sums(radius, std::abs(height));
    Corner a = first;
    for (int i = 1; i <= nVertices; ++i)
    {
        const Corner b = i < nVertices ? cornerAt(vertices[i] - center) : first;
        sums.addEdge(a, b, normal.dot(a.position.cross(b.position)));
        a = b;
    }
    return height < 0 ? -sums.total() : sums.total();
}

double discEdgeContribution(const Vector2d& center, double radius, const Vector2d& start, const Vector2d& end)
{
    const double r2 = radius*radius;
    const Vector2d a = start - center;
    const Vector2d b = end - center;
    const double cross = cross2(a, b);
    if (a.squaredNorm() <= r2 && b.squaredNorm() <= r2) return cross/2;

    const Vector2d edge = b - a;
    const double length2 = edge.squaredNorm();
    if (length2 == 0) return 0;
    const double line2 = cross*cross/length2;
    const double length = std::sqrt(length2);
    const double t1 = a.dot(edge)/length;
    const double t2 = t1 + length;
    const Chord chord = clipEdge(t1, t2, line2, r2);
    if (chord.isEmpty()) return r2/2*std::atan2(cross, a.dot(b));

    const double offset = cross/length;
    double twice = offset*(chord.end - chord.begin);
    if (t1 < chord.begin) twice += r2*std::atan2(offset*(chord.begin - t1), line2 + t1*chord.begin);
    if (chord.end < t2) twice += r2*std::atan2(offset*(t2 - chord.end), line2 + t2*chord.end);
    return twice/2;
}

} // namespace closures
