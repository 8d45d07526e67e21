// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What keeps a bed from breathing for ever under a cap of sweeps that is too small for it.
#pragma once

#include "nscd/scene/contactSettings.hpp"
#include "nscd/scene/stepReport.hpp"

namespace nscd
{

/// A solve that ends at the cap leaves part of the weight uncarried, and the next step begins with it. Where that goes on, a bed sinks
/// and bounces without end (benchmark stabilityMap). So a cap below `enough` is doubled, up to there, each time that so many steps in a row
/// have ended at it, and is the user's again once as many in a row have met the rule within that.
class CapGuard
{
public:
    /// The settings for the next solve.
    ContactSettings apply(ContactSettings settings) const;

    /// To be called with the report of each step, to which it adds the cap that was in force, if raised.
    void note(SolveReport& report, const ContactSettings& settings);

    void reset() { *this = CapGuard(); }

private:
    int raised_ = 0;   ///< cap in force; 0: the user's
    int atCap_ = 0;    ///< steps in a row that ended at the cap
    int within_ = 0;   ///< steps in a row that the user's cap would have done for
};

} // namespace nscd
