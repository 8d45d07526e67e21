// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Passes over contacts with films of fluid: scalar code beside the sweep kernels.
// Tested by tests/unit/nscd/contacts/laws/lubricationTest.cpp
#pragma once

#include "nscd/kernels/contactBlock.hpp"

namespace nscd
{

/// LawSweepFunction: each contact solved exactly with all others held. With u' = u_n - W_nn (r_n + q), what is left is the one number u_n of
///     u_n = u' + W_nn q(u_n) where that is >= -b, and r_n = 0; else u_n = -b, and r_n = -(u' + b)/W_nn - q(-b) >= 0,
/// by Newton's iteration, which is monotone from either side; friction as ever, with mu r_n.
DefectSums sweepFilms(Body* bodies, ContactBlock* blocks, LawBlock* films, BlockRange range);
/// LawSweepOnFunction
DefectSums sweepFilmsOn(Body* bodies, ContactBlock* blocks, LawBlock* films, BlockRange range, double* before, double* filmsBefore, double theta);
/// LawEvaluateFunction: W_nn |q - q'|, q' the film's impulse with r_n and all other contacts held; counts films of contacts without an impulse.
DefectSums evaluateFilms(const Body* bodies, const ContactBlock* blocks, const LawBlock* films, BlockRange range);

} // namespace nscd
