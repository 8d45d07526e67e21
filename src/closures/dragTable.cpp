// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sorting, checking and interpolating the table.
#include "closures/dragTable.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace closures
{

namespace
{

template<class... Values>
[[noreturn]] void refuse(const Values&... values)
{
    std::ostringstream text;
    (text << ... << values);
    throw std::invalid_argument(text.str());
}

void checkValues(const DragTableRow& row)
{
    const bool isRight = row.Re > 0 && row.Cd > 0 && row.fluidFraction > 0 && row.fluidFraction <= 1;
    if (!isRight || !std::isfinite(row.Re*row.Cd))
    {
        refuse("Re ", row.Re, ", alpha ", row.fluidFraction, ", Cd ", row.Cd, ": Re and Cd are to be above 0, alpha above 0 and at most 1");
    }
}

bool isBefore(const DragTableRow& a, const DragTableRow& b)
{
    return a.fluidFraction < b.fluidFraction || (a.fluidFraction == b.fluidFraction && a.Re < b.Re);
}

/// Place of x among increasing nodes: linear between node `low` and the next one, at `share` of the way; the ends beyond them.
struct Between
{
    std::size_t low;
    std::size_t high;
    double share;
};

Between between(const std::vector<double>& nodes, double x)
{
    const std::size_t next = std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin();
    if (next == 0) return {0, 0, 0};
    if (next == nodes.size()) return {next - 1, next - 1, 0};
    return {next - 1, next, (x - nodes[next - 1])/(nodes[next] - nodes[next - 1])};
}

} // namespace

DragTable::DragTable(std::vector<DragTableRow> rows)
{
    if (rows.empty()) refuse("it has no row");
    for (const DragTableRow& row : rows) checkValues(row);
    std::sort(rows.begin(), rows.end(), isBefore);
    setNodes(rows);
    checkForceGrows();
}

void DragTable::setNodes(const std::vector<DragTableRow>& rows)
{
    std::vector<double> Re;
    for (const DragTableRow& row : rows)
    {
        if (row.fluidFraction == rows[0].fluidFraction) Re.push_back(row.Re);
        if (fractions_.empty() || row.fluidFraction != fractions_.back()) fractions_.push_back(row.fluidFraction);
    }
    for (const double one : Re) logRe_.push_back(std::log(one));
    log_.assign(fractions_.size(), {});
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const DragTableRow& row = rows[i];
        if (i > 0 && !isBefore(rows[i - 1], row)) refuse("Re ", row.Re, ", alpha ", row.fluidFraction, " is given twice");
        const std::size_t alpha = i/Re.size(), k = i%Re.size();
        const bool isNode = alpha < fractions_.size() && row.fluidFraction == fractions_[alpha] && row.Re == Re[k];
        if (!isNode) refuse("Re ", row.Re, ", alpha ", row.fluidFraction, ": every alpha is to have the same Re, and these have not");
        log_[alpha].push_back(std::log(row.Re*row.Cd));
    }
    if (log_.back().size() != Re.size()) refuse("alpha ", fractions_.back(), " has fewer Re than the others");
}

/// The force is as Cd Re^2: its logarithm must rise.
void DragTable::checkForceGrows() const
{
    for (std::size_t a = 0; a < fractions_.size(); ++a)
    {
        for (std::size_t k = 1; k < logRe_.size(); ++k)
        {
            if (log_[a][k] + logRe_[k] > log_[a][k - 1] + logRe_[k - 1]) continue;
            refuse("alpha ", fractions_[a], ": the force, which is as Cd Re^2, does not grow from Re ", std::exp(logRe_[k - 1]), " to Re ",
                std::exp(logRe_[k]));
        }
    }
}

double DragTable::value(std::size_t alpha, double logRe) const
{
    const Between at = between(logRe_, logRe);
    return (1 - at.share)*log_[alpha][at.low] + at.share*log_[alpha][at.high];
}

double DragTable::cdRe(double Re, double fluidFraction) const
{
    // log(0) would trip a run that traps floating-point errors.
    const double logRe = Re > 0 ? std::max(std::log(Re), logRe_.front()) : logRe_.front();
    const Between at = between(fractions_, fluidFraction);
    const double within = (1 - at.share)*value(at.low, logRe) + at.share*value(at.high, logRe);
    return std::exp(within + std::max(0.0, logRe - logRe_.back()));
}

DragRange DragTable::range() const
{
    return {std::exp(logRe_.back()), fractions_.front(), fractions_.back()};
}

DragLaw lawOf(const DragTable& table)
{
    // Shared, so that copies of the law do not copy the table.
    const auto shared = std::make_shared<const DragTable>(table);
    return [shared](const DragState& s) { return drag::hindered(s, shared->cdRe(superficialRe(s), s.fluidFraction), 0); };
}

} // namespace closures
