// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A user's own drag coefficients: what a table means, and which ones are refused.
#include "closures/dragTable.hpp"
#include "dragStates.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <stdexcept>

namespace
{

using namespace dragStates;
using closures::DragTable;
using closures::DragTableRow;

const std::vector<DragTableRow> small = {{1, 0.4, 200}, {100, 0.4, 20}, {1, 0.8, 50}, {100, 0.8, 2}};

/// Cd of a row that a law of the table has, as rows give it: F = A/2 rho Cd U_s^2.
double cdOf(const DragLawRow& row, double Re, double alpha)
{
    const DragState state = stateAt(Re/alpha, alpha);
    const double Us = alpha*state.slip;
    return row.law(state)*state.slip/(0.5*state.size.frontalArea*state.density*Us*Us);
}

std::string refusal(const std::vector<DragTableRow>& rows)
{
    try
    {
        DragTable table(rows);
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "";
}

} // namespace

TEST(DragTable, rowsAreMetAndBetweenThemLogarithmsAreLinear)
{
    const DragTable table(small);
    for (const DragTableRow& row : small) EXPECT_NEAR(table.cdRe(row.Re, row.fluidFraction)/(row.Cd*row.Re), 1, 1e-14);
    EXPECT_NEAR(table.cdRe(10, 0.4), std::sqrt(200*2000.0), 1e-10);
    EXPECT_NEAR(table.cdRe(1, 0.6), std::sqrt(200*50.0), 1e-12);
}

TEST(DragTable, beyondItsRowsDragIsViscousOrNewtonsAndAlphaIsThatOfItsEnds)
{
    const DragTable table(small);
    for (double Re : {0.0, 1e-300, 0.5}) EXPECT_NEAR(table.cdRe(Re, 0.8), 50, 1e-12);
    EXPECT_NEAR(table.cdRe(5000, 0.8), 2*5000, 1e-9);
    EXPECT_EQ(table.cdRe(10, 0.3), table.cdRe(10, 0.4));
    EXPECT_EQ(table.cdRe(10, 1), table.cdRe(10, 0.8));
    const closures::DragRange range = table.range();
    EXPECT_NEAR(range.highestRe, 100, 1e-12);
    EXPECT_EQ(range.lowestFraction, 0.4);
    EXPECT_EQ(range.highestFraction, 0.8);
}

TEST(DragTable, theForceIsThatOfTheSuperficialSlip)
{
    const closures::DragLaw law = closures::lawOf(DragTable(small));
    const DragState state = stateAt(100/0.4, 0.4);
    const double Us = 0.4*state.slip;
    EXPECT_NEAR(law(state)*state.slip/(0.5*pi/4*1e-6*1000*20*Us*Us), 1, 1e-13);
}

// A table of a law is that law: to 1 % with 24 rows over 5 decades and alpha in steps of 0.05.
TEST(DragTable, aLawWrittenAsATableComesBack)
{
    const DragLawRow& row = closures::findDragLaw("Beetstra");
    std::vector<DragTableRow> rows;
    for (double alpha = 0.4; alpha < 0.96; alpha += 0.05)
    {
        for (int k = 0; k < 24; ++k)
        {
            const double Re = std::pow(10, -2 + 5*k/23.0);
            rows.push_back({Re, alpha, cdOf(row, Re, alpha)});
        }
    }
    const closures::DragLaw law = closures::lawOf(DragTable(rows));
    for (double alpha : {0.42, 0.5, 0.77, 0.9})
    {
        for (double Re : {0.0, 1e-3, 0.3, 5.0, 77.0, 900.0})
        {
            const DragState state = stateAt(Re/alpha, alpha);
            EXPECT_NEAR(law(state)/row.law(state), 1, 0.01) << Re << " " << alpha;
        }
    }
}

TEST(DragTable, trapsNothingAtRest)
{
    const closures::DragLaw law = closures::lawOf(DragTable(small));
    std::feclearexcept(FE_ALL_EXCEPT);
    volatile double sum = 0;
    for (double Re : {0.0, 1e-300, 1e-13}) sum = sum + law(stateAt(Re, 0.5));
    EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
}

TEST(DragTable, wrongOnesAreRefusedInWords)
{
    const struct { std::vector<DragTableRow> rows; const char* word; } cases[] =
    {
        {{}, "no row"},
        {{{0, 0.5, 1}}, "above 0"}, {{{1, 0.5, -1}}, "above 0"}, {{{1, 1.5, 1}}, "at most 1"}, {{{1, 0, 1}}, "above 0"},
        {{{1, 0.5, 1}, {1, 0.5, 2}}, "twice"},
        {{{1, 0.5, 9}, {2, 0.5, 8}, {1, 0.6, 9}, {3, 0.6, 8}}, "same Re"},
        {{{1, 0.5, 9}, {2, 0.5, 8}, {1, 0.6, 9}}, "fewer"},
        {{{1, 0.5, 9}, {1, 0.6, 9}, {2, 0.6, 8}}, "same Re"},
        {{{1, 0.5, 400}, {10, 0.5, 3}}, "does not grow"}
    };
    for (const auto& one : cases) EXPECT_NE(refusal(one.rows).find(one.word), std::string::npos) << one.word << ": " << refusal(one.rows);
    EXPECT_EQ(refusal(small), "");
}
