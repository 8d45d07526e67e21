// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The local solution of a contact with a film, and passes of it.
#include "nscd/contacts/laws/filmSweep.hpp"

#include "nscd/kernels/applyImpulse.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

Vec3 inBlock(const double (&of)[3][blockLanes], int lane) { return Vec3(of[0][lane], of[1][lane], of[2][lane]); }

void set(double (&of)[3][blockLanes], int lane, const Vec3& x)
{
    for (int k = 0; k < 3; ++k) of[k][lane] = x[k];
}

/// A film along the normal, thicknesses over the time step.
struct Film
{
    double strength;      ///< k
    double start;         ///< h/dt
    double edge;
    double untilClosed;   ///< q(-b)

    Film(const LawBlock& block, int lane)
    :
        strength(block.of[filmLaw::strength][lane]), start(block.of[filmLaw::thickness][lane]),
        edge(block.of[filmLaw::edge][lane]), untilClosed(block.of[filmLaw::untilClosed][lane])
    {}

    /// q where the step ends with the thickness y.
    double impulse(double y) const { return strength*std::log(std::min(start, edge)/std::min(y, edge)); }
};

/// Root y > 0 of y + K ln(y/s) = c, from a first guess: rising and concave, as a function of ln y convex, so Newton's iteration in y from the left,
/// in ln y from the right, comes nearer without passing it.
double endThickness(double K, double s, double c, double y)
{
    constexpr double fine = 1e-14;
    constexpr int most = 60;
    for (int k = 0; k < most; ++k)
    {
        const double f = y + K*std::log(y/s) - c;
        const double next = f < 0.0 ? y - f*y/(y + K) : y*std::exp(-f/(y + K));
        const bool isDone = std::abs(next - y) <= fine*y;
        y = next;
        if (isDone) break;
    }
    return y;
}

/// Solves u = u' + W q(u) without contact; `u`: a first guess. Returns q [N s].
double filmAlone(const Film& film, double w, double free, double u)
{
    if (!(film.strength > 0.0)) return 0.0;
    const double K = w*film.strength, s = std::min(film.start, film.edge), c = film.start + free;
    // Beyond the edge nothing acts, and nothing more.
    if (c - film.edge >= K*std::log(film.edge/s)) return film.impulse(film.edge);
    constexpr double least = 1e-12;   // of the start: a guess beyond the wall is none
    const double guess = std::max(least*film.start, std::min(film.start + u, film.edge));
    return film.impulse(endThickness(K, s, c, guess));
}

struct NormalPart
{
    double r;   ///< contact
    double q;   ///< film
};

NormalPart solveNormal(const Film& film, double w, double bias, double free, double u)
{
    const double pressed = -(free + bias)/w - film.untilClosed;
    if (pressed > 0.0) return {pressed, film.strength > 0.0 ? film.untilClosed : 0.0};
    return {0.0, filmAlone(film, w, free, u)};
}

void add(DefectSums& sums, double defect2, bool isActive)
{
    sums.sumSquares += isActive ? defect2 : 0.0;
    sums.active += isActive ? 1.0 : 0.0;
    if (!(defect2 <= sums.maxSquare)) sums.maxSquare = defect2;
}

void solveLane(Body* bodies, ContactBlock& block, LawBlock& films, int lane, DefectSums& sums)
{
    if (!(block.invWn[lane] > 0.0)) return;
    Body &a = bodies[block.a[lane]], &b = bodies[block.b[lane]];
    const Vec3 n = inBlock(block.n, lane), r = inBlock(block.r, lane), u = relativeVelocity(a, b, n);
    const double w = 1.0/block.invWn[lane], un = n.dot(u), rn = n.dot(r), qn = n.dot(inBlock(films.q, lane));
    const NormalPart normal = solveNormal(Film(films, lane), w, block.bias[lane], un - w*(rn + qn), un);

    const double limit = block.friction[lane]*normal.r, invWt = block.invWt[lane];
    Vec3 tangential = r - rn*n - invWt*(u - un*n);
    const double size = tangential.norm();
    if (size > limit) tangential *= limit/size;
    const Vec3 newR = normal.r*n + tangential, slip = tangential - (r - rn*n);
    const Vec3 change = newR - r + (normal.q - qn)*n;

    const double defectN = w*(normal.r - rn + normal.q - qn);
    add(sums, defectN*defectN + slip.squaredNorm()/(invWt*invWt), normal.r > 0.0 || rn > 0.0 || normal.q != 0.0);
    set(block.r, lane, newR);
    set(films.q, lane, normal.q*n);
    applyImpulse(a, b, n.data(), change.data());
}

/// Moves what a block has on by theta of what it changed since `before`, which receives it as it was.
void moveOn(double (&values)[3][blockLanes], double* before, double theta)
{
    double* const present = &values[0][0];
    for (int i = 0; i < 3*blockLanes; ++i)
    {
        const double now = present[i];
        present[i] += theta*(now - before[i]);
        before[i] = now;
    }
}

} // namespace

DefectSums sweepFilms(Body* bodies, ContactBlock* blocks, LawBlock* films, BlockRange range)
{
    DefectSums sums = {0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < range.count; ++k)
    for (int lane = 0; lane < blockLanes; ++lane) solveLane(bodies, blocks[range[k]], films[range[k]], lane, sums);
    return sums;
}

DefectSums sweepFilmsOn(Body* bodies, ContactBlock* blocks, LawBlock* films, BlockRange range, double* before, double* filmsBefore, double theta)
{
    DefectSums sums = {0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < range.count; ++k)
    {
        moveOn(blocks[range[k]].r, before + 3*k*blockLanes, theta);
        moveOn(films[range[k]].q, filmsBefore + 3*k*blockLanes, theta);
        for (int lane = 0; lane < blockLanes; ++lane) solveLane(bodies, blocks[range[k]], films[range[k]], lane, sums);
    }
    return sums;
}

DefectSums evaluateFilms(const Body* bodies, const ContactBlock* blocks, const LawBlock* films, BlockRange range)
{
    DefectSums sums = {0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < range.count; ++k)
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        const ContactBlock& block = blocks[range[k]];
        const Film film(films[range[k]], lane);
        if (!(block.invWn[lane] > 0.0) || !(film.strength > 0.0)) continue;
        const Vec3 n = inBlock(block.n, lane);
        const double w = 1.0/block.invWn[lane], q = n.dot(inBlock(films[range[k]].q, lane));
        const double un = n.dot(relativeVelocity(bodies[block.a[lane]], bodies[block.b[lane]], n));
        const double defect = w*(filmAlone(film, w, un - w*q, un) - q);
        sums.sumSquares += defect*defect;
        sums.maxSquare = std::max(sums.maxSquare, defect*defect);
        // Those that touch are counted with their contact.
        sums.active += n.dot(inBlock(block.r, lane)) > 0.0 ? 0.0 : 1.0;
    }
    return sums;
}

} // namespace nscd
