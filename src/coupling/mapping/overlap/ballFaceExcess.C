// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a face takes from a ball.
#include "coupling/mapping/overlap/ballFaceExcess.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

using ::nscd::Vec3;

// A sum of angles in (-pi, pi) as a product of complex numbers whose turns are counted: one arc tangent for all of them.
class AngleProduct
{
public:
    void multiply(const scalar sine, const scalar cosine)
    {
        const scalar scale = std::abs(sine) + std::abs(cosine);
        if (scale == 0)
        {
            return;
        }
        const scalar re = (re_*cosine - im_*sine)/scale;
        const scalar im = (re_*sine + im_*cosine)/scale;
        turns_ += sine > 0 && im_ >= 0 && im < 0;
        turns_ -= sine < 0 && im_ < 0 && im >= 0;
        re_ = re;
        im_ = im;
        isUsed_ = true;
    }

    scalar angle() const { return isUsed_ ? 2*M_PI*turns_ + std::atan2(im_, re_) : 0; }

private:
    scalar re_ = 1;
    scalar im_ = 0;
    int turns_ = 0;
    bool isUsed_ = false;
};

// The sums over the edges of one face at distance height > 0 from the center, height < radius.
class ExcessSums
{
public:
    ExcessSums(const scalar radius, const scalar height)
    :
        radius_(radius), radius2_(radius*radius), height_(height), height2_(height*height)
    {}

    // Edge from a to b, seen from the center; cross: twice the area of (foot of the center, a, b).
    void addEdge(const Vec3& a, const Vec3& b, const scalar cross)
    {
        const scalar aLength2 = a.squaredNorm();
        const scalar bLength2 = b.squaredNorm();
        const Vec3 edge = b - a;
        const scalar length2 = edge.squaredNorm();
        if (length2 == 0)
        {
            return;
        }
        const scalar line2 = height2_ + cross*cross/length2;
        if (line2 >= radius2_)
        {
            addOutside(cross, a.dot(b));
        }
        else if (aLength2 <= radius2_ && bLength2 <= radius2_)
        {
            addInside(cross, a.dot(b), std::sqrt(aLength2), std::sqrt(bLength2));
        }
        else
        {
            addCut(a.dot(edge)/std::sqrt(length2), std::sqrt(length2), line2, cross);
        }
    }

    scalar total() const
    {
        const scalar depth = radius_ - height_;
        return height_*inside_/6 - 2.0/3*radius2_*radius_*halfSolidAngle_.angle()
            - depth*depth*(2*radius_ + height_)/6*angleOutside_.angle();
    }

private:
    // begin: where the edge starts on its line, from the point nearest to the center; line2: that point's squared distance.
    void addCut(const scalar begin, const scalar length, const scalar line2, const scalar cross)
    {
        const scalar end = begin + length;
        const scalar half = std::sqrt(radius2_ - line2);
        const scalar enter = std::max(begin, -half);
        const scalar leave = std::min(end, half);
        if (leave <= enter)
        {
            addOutside(cross, line2 + begin*end);
            return;
        }
        const scalar offset = cross/length;
        addInside
        (
            offset*(leave - enter), line2 + enter*leave, std::sqrt(line2 + enter*enter), std::sqrt(line2 + leave*leave)
        );
        if (begin < enter) addOutside(offset*(enter - begin), line2 + begin*enter);
        if (leave < end) addOutside(offset*(end - leave), line2 + leave*end);
    }

    // Half the solid angle of (foot, piece), whose ends are at a and b from the center (van Oosterom & Strackee 1983).
    void addInside(const scalar cross, const scalar dot, const scalar a, const scalar b)
    {
        inside_ += cross;
        halfSolidAngle_.multiply(cross, (a + height_)*(b + height_) + dot - height2_);
    }

    void addOutside(const scalar cross, const scalar dot)
    {
        angleOutside_.multiply(cross, dot - height2_);
    }

    scalar radius_;
    scalar radius2_;
    scalar height_;
    scalar height2_;
    scalar inside_ = 0;
    AngleProduct halfSolidAngle_;
    AngleProduct angleOutside_;
};

scalar cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a[0]*b[1] - a[1]*b[0];
}

// Whether the circle in which the ball cuts the face's plane lies inside the face.
bool holdsCircle(const Vec3& center, const scalar circle2, const Vec3* vertices, const label nVertices, const Vec3& normal)
{
    for (label k = 0; k < nVertices; ++k)
    {
        const Vec3& a = vertices[k];
        const Vec3 edge = vertices[k + 1 < nVertices ? k + 1 : 0] - a;
        const scalar cross = normal.dot((a - center).cross(edge));
        if (cross < 0 || cross*cross < circle2*edge.squaredNorm())
        {
            return false;
        }
    }
    return true;
}

} // namespace

scalar ballFaceExcess
(
    const Vec3& center, const scalar radius, const Vec3* vertices, const label nVertices, const Vec3& normal
)
{
    const scalar signedHeight = normal.dot(vertices[0] - center);
    const scalar height = std::abs(signedHeight);
    if (height >= radius)
    {
        return 0;
    }
    const scalar sign = std::copysign(1.0, signedHeight);
    if (holdsCircle(center, radius*radius - height*height, vertices, nVertices, normal))
    {
        const scalar depth = radius - height;
        return -sign*M_PI/3*depth*depth*(2*radius + height);
    }
    ExcessSums sums(radius, height);
    const Vec3 first = vertices[0] - center;
    Vec3 a = first;
    for (label k = 1; k <= nVertices; ++k)
    {
        const Vec3 b = k < nVertices ? Vec3(vertices[k] - center) : first;
        sums.addEdge(a, b, normal.dot(a.cross(b)));
        a = b;
    }
    return sign*sums.total();
}

scalar discEdgeExcess
(
    const Eigen::Vector2d& center, const scalar radius, const Eigen::Vector2d& start, const Eigen::Vector2d& end
)
{
    const Eigen::Vector2d a = start - center;
    const scalar length = (end - start).norm();
    if (length == 0)
    {
        return 0;
    }
    const Eigen::Vector2d along = (end - start)/length;
    const scalar offset = cross2(a, along);
    const scalar line2 = offset*offset;
    const scalar radius2 = radius*radius;
    if (line2 >= radius2)
    {
        return 0;
    }
    const scalar half = std::sqrt(radius2 - line2);
    const scalar begin = std::max(a.dot(along), -half);
    const scalar stop = std::min(a.dot(along) + length, half);
    if (stop <= begin)
    {
        return 0;
    }
    const scalar cross = offset*(stop - begin);
    return 0.5*(cross - radius2*std::atan2(cross, line2 + begin*stop));
}

} // namespace nscdCoupling
} // namespace Foam
