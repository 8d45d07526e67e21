// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Collapsing columns of discs. A13: against the grains of Gerris' example `column` (Contact Dynamics; Staron & Hinch 2005), for several
// friction and restitution coefficients. A14: how far columns of aspect ratio 0.5 to 8 run out.
//     dryColumns                   A14, and A13 from the tutorial's own packing
//     dryColumns gerris FOLDER     A13 from the published packing: FOLDER holds grains-0.dat and the others
#include "columns.hpp"

#include "../resources/bars.hpp"
#include "../resources/csvFile.hpp"

#include "nscd/base/formattedText.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

using bars::require;
using columns::Disc;
using columns::Shape;
using nscd::Vec3;

namespace
{

/// Table A13: t*, time and the published grains' shape.
struct Published
{
    const char* name;
    double time;
    Shape shape;
};
const std::vector<Published> published =
{
    {"0.66", 0.1734, {0.23050, 0.07632, 0.2094, 0.5389}}, {"0.95", 0.2496, {0.15250, 0.11484, 0.3207, 0.3871}},
    {"1.24", 0.3257, {0.09888, 0.17815, 0.4547, 0.2533}}, {"1.52", 0.3993, {0.07293, 0.24615, 0.6004, 0.1894}},
    {"2.28", 0.5990, {0.04792, 0.37913, 0.9809, 0.1445}}
};

struct Collapse
{
    std::vector<Shape> shapes;                 ///< at the times of the table
    std::vector<std::vector<Vec3>> positions;
    double overlapMax = 0.0;
    double overlapMean = 0.0;
    int capped = 0;
};

Collapse collapse(const std::vector<Disc>& discs, double friction, double restitution, double deltaT)
{
    const scenes::Scene scene = columns::collapseScene(discs, friction, restitution);
    auto dynamics = scene.build(nscd::ContactSettings());
    Collapse found;
    double time = 0.0;
    for (const Published& moment : published)
    {
        const int steps = std::max(1, static_cast<int>(std::lround((moment.time - time)/deltaT)));
        const double step = (moment.time - time)/steps;
        for (int k = 0; k < steps; ++k)
        {
            const nscd::StepReport report = scenes::step(dynamics, scene.g, step);
            found.overlapMax = std::max(found.overlapMax, report.overlapMax);
            found.overlapMean = std::max(found.overlapMean, report.overlapMean);
            found.capped += !report.solve.converged;
        }
        time = moment.time;
        found.shapes.push_back(columns::shapeOf(dynamics.grains().position, dynamics.grains().radius));
        found.positions.push_back(dynamics.grains().position);
    }
    return found;
}

double relative(double value, double reference) { return value/reference - 1.0; }

/// One pair of coefficients beside the table.
Collapse tabulate(bars::CsvFile& csv, const std::vector<Disc>& discs, double friction, double restitution, double deltaT)
{
    const Collapse found = collapse(discs, friction, restitution, deltaT);
    bars::scene(nscd::formatted("A13 mu %g e %g dt %g", friction, restitution, deltaT));
    std::printf("  overlap max %.2g mean %.2g d, %d steps at the cap\n", found.overlapMax, found.overlapMean, found.capped);
    for (std::size_t k = 0; k < published.size(); ++k)
    {
        const Shape &ours = found.shapes[k], &theirs = published[k].shape;
        std::printf("  t %.4f s: height %.5f (%+.1f %%), mean distance %.5f (%+.1f %%), 99 %% distance %.4f (%+.1f %%), top %.4f\n",
            published[k].time, ours.height, 100*relative(ours.height, theirs.height), ours.distance,
            100*relative(ours.distance, theirs.distance), ours.reach, 100*relative(ours.reach, theirs.reach), ours.top);
        csv.row({friction, restitution, deltaT, published[k].time, ours.height, ours.distance, ours.reach, ours.top});
    }
    std::fflush(stdout);
    return found;
}

/// The bars of A13: 3 % of the mass center's height, 5 % of the distances; overlaps below those of the published grains.
void judge(const Collapse& found)
{
    double height = 0.0, distance = 0.0, reach = 0.0;
    for (std::size_t k = 0; k < published.size(); ++k)
    {
        height = std::max(height, std::abs(relative(found.shapes[k].height, published[k].shape.height)));
        distance = std::max(distance, std::abs(relative(found.shapes[k].distance, published[k].shape.distance)));
        reach = std::max(reach, std::abs(relative(found.shapes[k].reach, published[k].shape.reach)));
    }
    require("height of the mass center, worst of five times, share", height, 0.03);
    require("mean distance, worst of five times, share", distance, 0.05);
    require("99 % distance, worst of five times, share", reach, 0.05);
    require("largest overlap, d", found.overlapMax, 0.02);
    require("mean overlap, d", found.overlapMean, 0.004);
}

void sensitivity(const char* program, const std::vector<Disc>& discs)
{
    bars::CsvFile csv(program, "collapse", "friction,restitution,deltaT,time,height,meanDistance,distance99,top");
    for (double restitution : {0.5, 0.0})
    {
        for (double friction : {0.3, 0.5, 1.0})
        {
            const Collapse found = tabulate(csv, discs, friction, restitution, 1e-3);
            if (friction == 1.0 && restitution == 0.5) judge(found);
        }
    }
}

/// Mean distance between our grains and the published ones, grain by grain, in diameters, at the first time of the table.
void compareGrains(const std::string& folder, const std::vector<Disc>& discs, const Collapse& found)
{
    const std::vector<Disc> theirs = columns::readGerris(folder + "/grains-0.66.dat");
    double sum = 0.0, fall = 0.0;
    for (std::size_t i = 0; i < discs.size(); ++i)
    {
        const Vec3 there(theirs[i].x, 0, theirs[i].z), start(discs[i].x, 0, discs[i].z);
        sum += (found.positions[0][i] - there).norm();
        fall += (there - start).norm();
    }
    std::printf("grain by grain at t* 0.66: %.2f d apart in the mean, %.3f of what they moved\n",
        sum/static_cast<double>(discs.size())/5.014e-3, sum/fall);
}

/// Slope of log y against log x.
double exponent(const std::vector<double>& x, const std::vector<double>& y)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t k = 0; k < x.size(); ++k, ++n)
    {
        const double a = std::log(x[k]), b = std::log(y[k]);
        sx += a;
        sy += b;
        sxx += a*a;
        sxy += a*b;
    }
    return (n*sxy - sx*sy)/(n*sxx - sx*sx);
}

/// Run-out of one column: (Rinf - R0)/R0 once nothing flows any more.
double runOut(bars::CsvFile& csv, double aspect, int number, unsigned seed)
{
    const std::vector<Disc> discs = columns::pack(number, aspect, seed);
    const scenes::Scene scene = columns::collapseScene(discs, 0.5, 0.5);
    auto dynamics = scene.build(nscd::ContactSettings());
    const double half = columns::deposit(scene.grains.position, scene.grains.radius), height = columns::shapeOf(scene.grains.position, scene.grains.radius).top;
    const double unit = std::sqrt(height/scenes::gravity);
    double wide = half;
    int step = 0;
    for (double time = 0.0; time < 6.0*unit; time += 1e-3, ++step) scenes::step(dynamics, scene.g, 1e-3);
    wide = columns::deposit(dynamics.grains().position, dynamics.grains().radius);
    const double energy = nscd::kineticEnergy(dynamics.grains())/(nscd::totalVolume(dynamics.grains())*2500*scenes::gravity*height);
    const double out = (wide - half)/half;
    std::printf("  a %.2f (%d discs, H/R %.3f): (Rinf - R0)/R0 = %.3f, over a: %.3f, over a^0.7: %.3f; %d steps, kinetic energy %.1e M g H\n",
        aspect, number, height/half, out, out/(height/half), out/std::pow(height/half, 0.7), step, energy);
    std::fflush(stdout);
    csv.row({height/half, double(number), double(seed), half, height, wide, out, energy});
    return out;
}

/// A14: exponents 1 below and 0.7 above a = 2 (Contact Dynamics, Staron & Hinch 2005).
void scalings(const char* program)
{
    bars::scene("A14 run-out of columns, mu 0.5, e 0.5");
    bars::CsvFile csv(program, "runOut", "aspect,discs,seed,R0,H0,Rinf,runOut,kineticEnergy");
    std::vector<double> low, lowOut, high, highOut;
    for (double aspect : {0.5, 1.0, 2.0, 4.0, 8.0})
    {
        for (unsigned seed : {1u, 2u})
        {
            const double out = runOut(csv, aspect, 4000, seed);
            if (aspect <= 2.0) { low.push_back(aspect); lowOut.push_back(out); }
            if (aspect >= 2.0) { high.push_back(aspect); highOut.push_back(out); }
        }
    }
    const double below = exponent(low, lowOut), above = exponent(high, highOut);
    std::printf("  exponents %.3f for a <= 2, %.3f for a >= 2\n", below, above);
    bars::requireNear("exponent for a <= 2", below, 1.0, 0.1);
    bars::requireNear("exponent for a >= 2", above, 0.7, 0.1);
}

} // namespace

int main(int count, char** arguments)
{
    if (count == 3 && std::strcmp(arguments[1], "gerris") == 0)
    {
        const std::string folder = arguments[2];
        const std::vector<Disc> discs = columns::readGerris(folder + "/grains-0.dat");
        sensitivity(arguments[0], discs);
        return bars::status();
    }
    if (count == 6 && std::strcmp(arguments[1], "one") == 0)
    {
        const std::vector<Disc> discs = columns::readGerris(std::string(arguments[2]) + "/grains-0.dat");
        bars::CsvFile csv(arguments[0], "one", "friction,restitution,deltaT,time,height,meanDistance,distance99,top");
        compareGrains(arguments[2], discs, tabulate(csv, discs, std::atof(arguments[3]), std::atof(arguments[4]), std::atof(arguments[5])));
        return 0;
    }
    scalings(arguments[0]);
    sensitivity(arguments[0], columns::readTutorial("../../../tutorials/grains/columnCollapse/constant/column.dat"));
    return bars::status();
}
