// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Timing the parts of a step.
#include "coupling/case/log/timingTable.H"

#include "nscd/base/formattedText.hpp"

#include <numeric>

namespace Foam
{
namespace nscdCoupling
{

using ::nscd::formatted;

const std::array<const char*, nStepParts> stepPartNames =
{
    "sampleFluid", "linearizeDrag", "solveFluid", "fluidForces", "advanceGrains", "depositGrains", "reportStep"
};


TimingTable::Timer::Timer(TimingTable& table, StepPart part)
:
    table_(table),
    part_(part),
    start_(std::chrono::steady_clock::now())
{}


TimingTable::Timer::~Timer()
{
    table_.add(part_, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count());
}


double TimingTable::total() const
{
    return std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
}


void TimingTable::print(Ostream& os, label steps, const ::nscd::StepTimes& grains) const
{
    const double sum = total();
    const auto row = [&](const char* name, double seconds)
    {
        const double share = sum > 0 ? 100*seconds/sum : 0;
        const double perStep = steps > 0 ? 1e3*seconds/steps : 0;
        os << formatted("  %-16s %12.3f %8.1f %% %12.4f", name, seconds, share, perStep).c_str() << nl;
    };
    os << formatted("  %-16s %12s %10s %12s", "part", "seconds", "share", "ms/step").c_str() << nl;
    for (int part = 0; part < nStepParts; ++part) row(stepPartNames[part], seconds_[part]);
    row("sum", sum);
    os << "  of these, grains in linearizeDrag and advanceGrains" << nl;
    for (std::size_t part = 0; part < ::nscd::grainPartNames.size(); ++part) row(::nscd::grainPartNames[part], grains.parts()[part]);
    row("sum of grains", grains.total());
}

} // namespace nscdCoupling
} // namespace Foam
