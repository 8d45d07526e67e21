// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The laws as published, and their table.
#include "closures/nusseltLaws.hpp"

#include <cmath>
#include <stdexcept>

namespace closures
{

namespace
{

/// Nu of a sphere alone, by the interstitial slip; for drops of Re up to 200.
/// Equation: 2 + 0.6 Re^1/2 Pr^1/3 (Ranz & Marshall 1952)
double ranzMarshall(const NusseltState& s) { return 2 + 0.6*std::sqrt(s.Re)*std::cbrt(s.Pr); }

/// Nu in fixed and fluidized beds, by the superficial slip, Re_s = alpha Re; for alpha 0.35 to 1, Re_s up to 1e5.
/// Equation: (7 - 10 alpha + 5 alpha^2)(1 + 0.7 Re_s^0.2 Pr^1/3) + (1.33 - 2.4 alpha + 1.2 alpha^2) Re_s^0.7 Pr^1/3 (Gunn 1978)
double gunn(const NusseltState& s)
{
    const double alpha = s.fluidFraction, Re = alpha*s.Re, prandtl = std::cbrt(s.Pr);
    return (7 - 10*alpha + 5*alpha*alpha)*(1 + 0.7*std::pow(Re, 0.2)*prandtl)
        + (1.33 - 2.4*alpha + 1.2*alpha*alpha)*std::pow(Re, 0.7)*prandtl;
}

/// Nu in packed beds, by the superficial slip; for Re_s 15 to 8500.
/// Equation: 2 + 1.1 Re_s^0.6 Pr^1/3 (Wakao et al. 1979)
double wakao(const NusseltState& s) { return 2 + 1.1*std::pow(s.fluidFraction*s.Re, 0.6)*std::cbrt(s.Pr); }

/// Nu in dense flows of gas and grains, by the interstitial slip.
/// Equation: 2 + 0.6 alpha^3.5 Re^1/2 Pr^1/3 up to Re 200, 2 + alpha^3.5 (0.5 Re^1/2 + 0.02 Re^0.8) Pr^1/3 up to 1500, beyond it
///           2 + 4.5e-5 alpha^3.5 Re^1.8 (Li & Mason 2000)
double liMason(const NusseltState& s)
{
    const double dense = std::pow(s.fluidFraction, 3.5), prandtl = std::cbrt(s.Pr);
    if (s.Re <= 200) return 2 + 0.6*dense*std::sqrt(s.Re)*prandtl;
    if (s.Re <= 1500) return 2 + dense*(0.5*std::sqrt(s.Re) + 0.02*std::pow(s.Re, 0.8))*prandtl;
    return 2 + 4.5e-5*dense*std::pow(s.Re, 1.8);
}

const std::vector<NusseltLawRow> table =
{
    // name          function      source
    {"RanzMarshall", ranzMarshall, "Ranz & Marshall 1952"},
    {"Gunn",         gunn,         "Gunn 1978"},
    {"Wakao",        wakao,        "Wakao et al. 1979"},
    {"LiMason",      liMason,      "Li & Mason 2000"}
};

} // namespace

const std::vector<NusseltLawRow>& nusseltLaws() { return table; }

const NusseltLawRow& findNusseltLaw(const std::string& name)
{
    std::string names;
    for (const NusseltLawRow& row : table)
    {
        if (row.name == name) return row;
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    throw std::invalid_argument("unknown law of heat transfer '" + name + "'; known are " + names);
}

double conductanceOverStep(double conductance, double heatCapacity, double deltaT)
{
    return -heatCapacity*std::expm1(-conductance*deltaT/heatCapacity)/deltaT;
}

} // namespace closures
