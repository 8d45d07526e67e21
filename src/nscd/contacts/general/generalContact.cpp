// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Open, sticking, sliding.
#include "nscd/contacts/general/generalContact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nscd
{

namespace
{

using Vec2 = Eigen::Vector2d;

constexpr double pi = 3.14159265358979323846;
constexpr int newtonSteps = 12;
constexpr int sectors = 64;
constexpr int bisections = 60;

Vec2 direction(double angle) { return Vec2(std::cos(angle), std::sin(angle)); }
Vec2 turned(const Vec2& x) { return Vec2(-x[1], x[0]); }

/// Sliding along t: r = r_n (n + mu t), r_n = -B/D with B = u_free,n + b < 0 and D = W_nn + mu w.t, and the slip u_t = g/D with
/// g = u_free,t D - B (w + mu W_tt t), which must be -lambda t, lambda >= 0.
class Sliding
{
public:
    Sliding(const GeneralContact& contact, const Vec3& freeVelocity)
    :
        mu_(contact.friction)
    {
        const Vec3 helper = std::abs(contact.n[0]) < 0.6 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
        tangents_.col(0) = contact.n.cross(helper).normalized();
        tangents_.col(1) = contact.n.cross(tangents_.col(0));
        wnn_ = contact.n.dot(contact.w*contact.n);
        w_ = tangents_.transpose()*(contact.w*contact.n);
        wtt_ = tangents_.transpose()*contact.w*tangents_;
        free_ = tangents_.transpose()*freeVelocity;
        closing_ = contact.n.dot(freeVelocity) + contact.bias;
    }

    /// Unit tangent along the tangential part of r.
    Vec2 directionOf(const Vec3& r) const
    {
        const Vec2 t = tangents_.transpose()*r;
        const double size = t.norm();
        return size > 0.0 ? Vec2(t/size) : Vec2(1.0, 0.0);
    }

    Vec3 impulse(const Vec3& n, const Vec2& t) const
    {
        return -closing_/denominator(t)*(n + mu_*(tangents_*t));
    }

    /// Newton's method for the angle, by turns of tangent `step`. Returns whether it ended at a solution.
    bool refine(Vec2& start) const
    {
        Vec2 t = start;
        for (int k = 0; k < newtonSteps; ++k)
        {
            const Vec2 across = turned(t), g = slip(t);
            const Vec2 slope = free_*(mu_*w_.dot(across)) - closing_*mu_*(wtt_*across);
            const double step = across.dot(g)/(across.dot(slope) - t.dot(g));
            if (!(std::abs(step) < 2.0)) return false;
            t = (t - step*across).normalized();
            if (std::abs(step) > 1e-14) continue;
            start = t;
            return isSolution(t);
        }
        return false;
    }

    /// The solution nearest to a direction, from sign changes over the circle. Returns whether there is any.
    bool search(Vec2& t) const
    {
        double nearest = std::numeric_limits<double>::max();
        const double start = std::atan2(t[1], t[0]);
        for (int k = 0; k < sectors; ++k)
        {
            const double a = start + 2.0*pi*(k - 0.5)/sectors, b = a + 2.0*pi/sectors;
            if ((defect(a) > 0.0) == (defect(b) > 0.0)) continue;
            const double x = bisect(a, b), distance = std::abs(std::remainder(x - start, 2.0*pi));
            if (!isSolution(direction(x)) || distance >= nearest) continue;
            nearest = distance;
            t = direction(x);
        }
        return nearest < std::numeric_limits<double>::max();
    }

private:
    double denominator(const Vec2& t) const { return wnn_ + mu_*w_.dot(t); }
    Vec2 slip(const Vec2& t) const { return free_*denominator(t) - closing_*(w_ + mu_*(wtt_*t)); }
    double defect(double angle) const { return turned(direction(angle)).dot(slip(direction(angle))); }
    bool isSolution(const Vec2& t) const { return denominator(t) > 0.0 && t.dot(slip(t)) <= 0.0; }

    double bisect(double a, double b) const
    {
        const bool isRising = defect(b) > 0.0;
        for (int k = 0; k < bisections; ++k)
        {
            const double middle = 0.5*(a + b);
            ((defect(middle) > 0.0) == isRising ? b : a) = middle;
        }
        return 0.5*(a + b);
    }

    double mu_, wnn_, closing_;
    Eigen::Matrix<double, 3, 2> tangents_;
    Vec2 w_, free_;
    Eigen::Matrix2d wtt_;
};

} // namespace

Vec3 solveCoulomb(const GeneralContact& contact, const Vec3& freeVelocity)
{
    const Vec3& n = contact.n;
    const double closing = n.dot(freeVelocity) + contact.bias;
    if (!(closing < 0.0)) return Vec3::Zero();
    const Vec3 frictionless = -closing/n.dot(contact.w*n)*n;
    if (!(contact.friction > 0.0)) return frictionless;

    const Vec3 sticking = -(contact.inverse*(freeVelocity + contact.bias*n));
    const double rn = n.dot(sticking);
    if (rn >= 0.0 && (sticking - rn*n).norm() <= contact.friction*rn) return sticking;

    const Sliding sliding(contact, freeVelocity);
    Vec2 t = sliding.directionOf(sticking);
    if (sliding.refine(t) || sliding.search(t)) return sliding.impulse(n, t);
    return frictionless;
}

Vec3 approachTresca(const GeneralContact& contact, const Vec3& r, const Vec3& u)
{
    const Vec3& n = contact.n;
    const double rn = n.dot(r), wnn = n.dot(contact.w*n), pn = std::max(0.0, rn - (n.dot(u) + contact.bias)/wnn);
    const Vec3 pushed = u + (pn - rn)*(contact.w*n);
    Vec3 pt = (r - rn*n) - (pushed - n.dot(pushed)*n)/(contact.w.trace() - wnn);
    const double size = pt.norm();
    if (size > contact.friction) pt *= contact.friction/size;
    return pn*n + pt;
}

} // namespace nscd
