// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The contact sweep one lane at a time, for any processor.
#include "sweepKernel.hpp"
#include "sweepKernels.hpp"

#include <cmath>

namespace nscd
{
namespace
{

struct ScalarLanes
{
    using Real = double;
    static constexpr int lanes = 1;

    static Real zero() { return 0.0; }
    static Real one() { return 1.0; }
    static Real tiny() { return 1e-300; }
    static Real load(const double* p) { return *p; }
    static void store(double* p, Real x) { *p = x; }
    static Real max(Real a, Real b) { return a > b ? a : b; }
    static Real sqrt(Real a) { return std::sqrt(a); }
    static Real select(bool mask, Real a, Real b) { return mask ? a : b; }
    static void prefetch(const Body*, const ContactBlock&) {}

    static void loadBodies(const Body* bodies, const std::int32_t* index, Real (&x)[8])
    {
        const Body& body = bodies[*index];
        for (int k = 0; k < 3; ++k)
        {
            x[k] = body.v[k];
            x[4 + k] = body.s[k];
        }
        x[3] = body.invMass;
        x[7] = body.invSpin;
    }

    static void storeBodies(Body* bodies, const std::int32_t* index, const Real (&x)[8])
    {
        Body& body = bodies[*index];
        for (int k = 0; k < 3; ++k)
        {
            body.v[k] = x[k];
            body.s[k] = x[4 + k];
        }
    }
};

} // namespace

SweepKernels portableKernels() { return makeKernels<ScalarLanes>("portable"); }

} // namespace nscd
