// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag laws fitted to resolved simulations of flow through random arrays of equal spheres.
//
// Such papers give F, the force over 3 pi mu d U_s of a lone sphere in the superficial slip. Where F is the whole force on a sphere, of which
// the mean pressure gradient has the part phi, gamma = 3 pi mu d alpha^2 F; where it is the drag alone, gamma = 3 pi mu d alpha F. What F
// is in a paper shows at its creeping limit in a packed bed, Carman and Kozeny's 180 phi^2 mu U_s/(alpha^3 d^2) for the pressure gradient:
// the whole force has 10 phi/alpha^3 there, the drag 10 phi/alpha^2.
// Tested by tests/unit/closures/dragLawsTest.cpp, tests/unit/closures/dragLawValuesTest.cpp
#pragma once

#include "closures/drag/dragState.hpp"

#include <algorithm>

namespace closures
{
namespace drag
{

/// From F, the whole force over 3 pi mu d U_s.
inline double fromWholeForce(const DragState& s, double F)
{
    return timesStokes(s, s.fluidFraction*s.fluidFraction*F);
}

/// F of a packed bed in creeping flow, after Carman and Kozeny.
inline double packedForce(double phi)
{
    return 10*phi/((1 - phi)*(1 - phi)*(1 - phi));
}

/// (1 + 3 sqrt(phi/2) + 135/64 phi ln phi + a phi)/(1 + 0.681 phi + b phi^2 + c phi^3), 1 at phi = 0. With a = 17.14 it begins as the exact
/// expansion for fixed random arrays, 1 + 3 sqrt(phi/2) + 135/64 phi ln phi + 16.456 phi (Kim & Russel 1985).
inline double diluteForce(double phi, double a, double b, double c)
{
    if (phi <= 0) return 1;
    return (1 + 3*std::sqrt(phi/2) + 135.0/64*phi*std::log(phi) + a*phi)/(1 + phi*(0.681 + phi*(b + c*phi)));
}

/// Slope of F over Re_s/2 in a bed with inertia.
inline double kochHillSlope(double phi)
{
    const double alpha = 1 - phi;
    return 0.0673 + 0.212*phi + 0.0232/(alpha*alpha*alpha*alpha*alpha);
}

/// Equation: whole force F = F0 + F3 Re_s/2; F0 = diluteForce(16.14, -8.48, 8.16) for phi < 0.4, else 10 phi/alpha^3;
///           F3 = 0.0673 + 0.212 phi + 0.0232/alpha^5 (Koch & Hill 2001)
/// Range:    simulated up to phi 0.64, Re_s about 200; F0 rises by 1.0 % at phi 0.4. A slope for beds: a lone grain gets 0.84, 1.2 and 2.5
///           times Schiller and Naumann's drag at Re 10, 100 and 1000
inline double kochHill(const DragState& s)
{
    const double phi = solidFraction(s);
    const double F0 = phi < 0.4 ? diluteForce(phi, 16.14, -8.48, 8.16) : packedForce(phi);
    return fromWholeForce(s, F0 + 0.5*kochHillSlope(phi)*superficialRe(s));
}

/// What Benyahia, Syamlal & O'Brien (2006) join Hill, Koch and Ladd's simulations by; R = Re_s/2.
struct HillKochLaddTerms
{
    double F0;  ///< of creeping flow
    double F1;  ///< of R^2, the first effect of inertia
    double F2;  ///< what the line of strong inertia starts from
    double F3;  ///< of R in strong inertia
};

inline HillKochLaddTerms hillKochLaddTerms(double phi)
{
    HillKochLaddTerms terms{};
    terms.F1 = phi > 0.1 ? 0.11 + 5.1e-4*std::exp(11.6*phi) : std::sqrt(2/std::max(phi, 1e-300))/40;
    terms.F3 = phi < 0.0953 ? 0.9351*phi + 0.03667 : kochHillSlope(phi);
    if (phi >= 0.4)
    {
        terms.F0 = terms.F2 = packedForce(phi);
        return terms;
    }
    const double packed = phi > 0 ? std::exp(-10*(0.4 - phi)/phi) : 0;
    terms.F0 = (1 - packed)*diluteForce(phi, 17.14, -8.48, 8.16) + packed*packedForce(phi);
    terms.F2 = (1 - packed)*diluteForce(phi, 17.89, -11.03, 15.41) + packed*packedForce(phi);
    return terms;
}

/// Equation: whole force, R = Re_s/2: F0 + F1 R^2 up to the R where that meets F2 + F3 R, which holds beyond; at phi <= 0.01
///           1 + 3/8 R, up to the R where that does. F0 = (1 - w) diluteForce(17.14, -8.48, 8.16) + w 10 phi/alpha^3,
///           F2 = (1 - w) diluteForce(17.89, -11.03, 15.41) + w 10 phi/alpha^3, w = exp(-10 (0.4 - phi)/phi), from phi 0.4 on both
///           10 phi/alpha^3; F1 = sqrt(2/phi)/40 up to phi 0.1, then 0.11 + 0.00051 exp(11.6 phi); F3 = 0.9351 phi + 0.03667 below phi
///           0.0953, then 0.0673 + 0.212 phi + 0.0232/alpha^5 (Hill, Koch & Ladd 2001; Benyahia, Syamlal & O'Brien 2006)
/// Range:    phi up to 0.64, Re_s about 200 simulated; it rises by 28 % at phi 0.01 in creeping flow, as published, and a lone grain gets
///           0.68, 0.62 and 1.06 times Schiller and Naumann's drag at Re 10, 100 and 1000
inline double hillKochLadd(const DragState& s)
{
    const double phi = solidFraction(s), R = 0.5*superficialRe(s);
    const HillKochLaddTerms t = hillKochLaddTerms(phi);
    const double strong = t.F2 + t.F3*R;
    if (phi <= 0.01) return fromWholeForce(s, R <= (t.F2 - 1)/(0.375 - t.F3) ? 1 + 0.375*R : strong);
    const double meeting = (t.F3 + std::sqrt(t.F3*t.F3 - 4*t.F1*(t.F0 - t.F2)))/(2*t.F1);
    return fromWholeForce(s, R <= meeting ? t.F0 + t.F1*R*R : strong);
}

/// Equation: drag F = 10 phi/alpha^2 + alpha^2 (1 + 1.5 sqrt(phi)) + 0.413 Re_s/(24 alpha^2) (1/alpha + 3 alpha phi + 8.4 Re_s^-0.343)/
///           (1 + 10^(3 phi) Re_s^-(1/2 + 2 phi)) (Beetstra, van der Hoef & Kuipers 2007)
/// Range:    simulated at phi 0.1 to 0.64, Re_s up to 1000; a lone grain has Stokes' drag as Re -> 0, and 0.94, 1.16 and 1.69 times Schiller
///           and Naumann's at Re 10, 100 and 1000
inline double beetstra(const DragState& s)
{
    const double alpha = s.fluidFraction, phi = solidFraction(s), Re = superficialRe(s);
    const double creeping = 10*phi/(alpha*alpha) + alpha*alpha*(1 + 1.5*std::sqrt(phi));
    // Both parts of the fraction times Re_s^(1/2 + 2 phi), which is 0 at rest.
    const double power = std::pow(Re, 0.5 + 2*phi);
    const double inertial = Re*(1/alpha + 3*alpha*phi) + 8.4*std::pow(Re, 0.657);
    return timesStokes(s, alpha*(creeping + 0.413/(24*alpha*alpha)*inertial*power/(power + std::pow(10, 3*phi))));
}

/// Equation: whole force F = (1 + 0.15 Re_s^0.687)/alpha^3 + 5.81 phi/alpha^3 + 0.48 phi^(1/3)/alpha^4
///           + phi^3 Re_s (0.95 + 0.61 phi^3/alpha^2) (Tenneti, Garg & Subramaniam 2011)
/// Range:    simulated at phi 0.1 to 0.5, Re_s up to 300
inline double tenneti(const DragState& s)
{
    const double alpha = s.fluidFraction, phi = solidFraction(s), Re = superficialRe(s);
    const double cube = alpha*alpha*alpha, phi3 = phi*phi*phi;
    const double lone = 1 + 0.15*std::pow(Re, 0.687);
    const double F = (lone + 5.81*phi + 0.48*std::cbrt(phi)/alpha)/cube + phi3*Re*(0.95 + 0.61*phi3/(alpha*alpha));
    return fromWholeForce(s, F);
}

} // namespace drag
} // namespace closures
