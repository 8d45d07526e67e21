// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A drag law of a user's own, as a table of drag coefficients.
#pragma once

#include "closures/dragLaws.hpp"

#include <vector>

namespace closures
{

/// One measured or computed value: F = A/2 rho Cd U_s^2 with U_s = alpha |u - v|, the drag in form A.
struct DragTableRow
{
    double Re;             ///< Re_s = rho U_s d/mu [-]
    double fluidFraction;  ///< alpha [-]
    double Cd;             ///< [-]
};

/// Equation: ln(Cd Re_s) linear in ln Re_s and in alpha between the rows. Below the lowest Re_s Cd Re_s stays (viscous drag), above the
///           highest Cd stays (Newton's); alpha beyond its bounds counts as the bound.
class DragTable
{
public:
    /// Rows in any order; every alpha with every Re_s.
    /// Errors: std::invalid_argument for values out of range, rows missing or given twice, and a force Cd Re_s^2 that does not grow with Re_s
    explicit DragTable(std::vector<DragTableRow> rows);

    /// Cd Re_s
    double cdRe(double Re, double fluidFraction) const;

    /// Where the table has rows.
    DragRange range() const;

private:
    void setNodes(const std::vector<DragTableRow>& rows);
    void checkForceGrows() const;
    double value(std::size_t alpha, double logRe) const;

    std::vector<double> logRe_;            ///< increasing
    std::vector<double> fractions_;        ///< increasing
    std::vector<std::vector<double>> log_; ///< ln(Cd Re_s) by alpha, then Re_s
};

/// The law of a table.
DragLaw lawOf(const DragTable& table);

} // namespace closures
