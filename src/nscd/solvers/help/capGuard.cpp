// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Counting steps at the cap.
#include "nscd/solvers/help/capGuard.hpp"

#include <algorithm>

namespace nscd
{

ContactSettings CapGuard::apply(ContactSettings settings) const
{
    settings.maxSweeps = std::max(settings.maxSweeps, raised_);
    return settings;
}

void CapGuard::note(SolveReport& report, const ContactSettings& settings)
{
    if (!settings.raiseCap || settings.maxSweeps >= settings.strategy.cap.enough) return;
    report.raisedCap = raised_;
    report.userCap = settings.maxSweeps;
    atCap_ = report.converged ? 0 : atCap_ + 1;
    within_ = report.converged && report.sweeps <= settings.maxSweeps ? within_ + 1 : 0;
    if (atCap_ == settings.strategy.cap.patience)
    {
        raised_ = std::min(settings.strategy.cap.enough, 2*std::max(settings.maxSweeps, raised_));
        atCap_ = 0;
    }
    else if (within_ >= settings.strategy.cap.patience) raised_ = 0;
}

} // namespace nscd
