// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The drag laws as curves, and against what is measured of beds, as CSV.
// dragLaws curves    law, alpha, Re_s, gamma/(3 pi mu d)
// dragLaws errors    law, bed, alpha, Re, ratio: what the law has over what is measured; Re is Re_s of packed beds, Re_t of suspensions
// Measured are
//   packed    pressure gradient of beds of spheres: psi phi/alpha^3 rho U_s^2/(2 d), psi = 320/(Re_s/phi) + 6/(Re_s/phi)^0.1, for alpha 0.36
//             to 0.42 (KTA rule 3102.3, 1981)
//   settling  superficial velocity of suspensions, of beds in liquids: U_t alpha^n, n = 4.65 up to Re_t 0.2, 4.35 Re_t^-0.03 up to 1,
//             4.45 Re_t^-0.1 up to 500, 2.39 beyond (Richardson & Zaki 1954), Re_t of the lone sphere, by Schiller and Naumann
#include "closures/dragLaws.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace
{

using closures::DragLawRow;

const double pi = std::acos(-1.0);

/// gamma/(3 pi mu d), of a sphere of 1 in a fluid of 1 and 1.
double factor(const DragLawRow& row, double Re_s, double alpha)
{
    return row.law({closures::sphereSize(1), Re_s/alpha, alpha, 1, 1})/(3*pi);
}

void printCurves()
{
    std::puts("law,alpha,Re,factor");
    for (const DragLawRow& row : closures::dragLaws())
    {
        for (double Re : {0.01, 1.0, 10.0, 100.0, 1000.0})
        {
            for (double alpha = 0.3; alpha < 0.9999; alpha += 0.002) std::printf("%s,%.4f,%g,%.8g\n", row.name, alpha, Re, factor(row, Re, alpha));
        }
    }
}

void printPacked(const DragLawRow& row)
{
    for (double alpha : {0.36, 0.38, 0.4, 0.42})
    {
        const double phi = 1 - alpha;
        for (double exponent = 0; exponent < 3.01; exponent += 0.25)
        {
            // In units of mu U_s/d^2.
            const double Re = std::pow(10, exponent), psi = 320*phi/Re + 6*std::pow(phi/Re, 0.1);
            const double measured = psi*phi/(alpha*alpha*alpha)*Re/2, ofLaw = 18*phi*factor(row, Re, alpha)/(alpha*alpha);
            std::printf("%s,packed,%g,%g,%.6g\n", row.name, alpha, Re, ofLaw/measured);
        }
    }
}

double richardsonZaki(double Re_t)
{
    if (Re_t < 0.2) return 4.65;
    if (Re_t < 1) return 4.35*std::pow(Re_t, -0.03);
    return Re_t < 500 ? 4.45*std::pow(Re_t, -0.1) : 2.39;
}

/// Re_s at which drag is alpha times the submerged weight, which is as the drag of the lone sphere at Re_t.
double settlingRe(const DragLawRow& row, double Re_t, double alpha)
{
    const double weight = alpha*factor(closures::findDragLaw("SchillerNaumann"), Re_t, 1)*Re_t;
    double low = 1e-9*Re_t, high = 10*Re_t;
    for (int i = 0; i < 100; ++i)
    {
        const double middle = std::sqrt(low*high);
        (factor(row, middle, alpha)*middle/alpha > weight ? high : low) = middle;
    }
    return low;
}

void printSettling(const DragLawRow& row)
{
    for (double Re_t : {0.1, 1.0, 10.0, 100.0, 1000.0})
    {
        for (double alpha = 0.5; alpha < 0.96; alpha += 0.05)
        {
            const double measured = Re_t*std::pow(alpha, richardsonZaki(Re_t));
            std::printf("%s,settling,%g,%g,%.6g\n", row.name, alpha, Re_t, settlingRe(row, Re_t, alpha)/measured);
        }
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc == 2 && std::strcmp(argv[1], "curves") == 0)
    {
        printCurves();
        return 0;
    }
    if (argc != 2 || std::strcmp(argv[1], "errors") != 0)
    {
        std::fputs("usage: dragLaws curves|errors\n", stderr);
        return 2;
    }
    std::puts("law,bed,alpha,Re,ratio");
    for (const DragLawRow& row : closures::dragLaws())
    {
        printPacked(row);
        printSettling(row);
    }
    return 0;
}
