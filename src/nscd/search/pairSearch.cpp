// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Half stencil within a grid, spheres row by row in finer grids, distances of eight members at once.
#include "nscd/search/pairSearch.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nscd
{

namespace
{

using Image = std::array<signed char, 3>;
using Cell = CellGrid::Cell;

/// Two numbers: a register of every x86-64, and of most other processors.
typedef double Two __attribute__((vector_size(2*sizeof(double))));

Two two(double a) { return Two{a, a}; }

Two load(const double* p)
{
    Two a;
    __builtin_memcpy(&a, p, sizeof a);
    return a;
}

/// Bit k: whether number k is negative.
unsigned signs(Two a)
{
#if defined(__SSE2__)
    return static_cast<unsigned>(__builtin_ia32_movmskpd(a));
#else
    return (a[0] < 0.0 ? 1u : 0u) + (a[1] < 0.0 ? 2u : 0u);
#endif
}

constexpr int chunk = CellGrid::padding;   // members tested at once
constexpr int chunksAtOnce = 8;            // their bits fill a word

constexpr std::size_t pairsInPiece = 5000;

double square(double a) { return a*a; }

/// Looks one body after the other up in a grid. Which members are near is hard to foretell, so tests do not branch: bits are collected.
class Look
{
public:
    Look(const CellGrid& grid, const PeriodicBox& box, std::vector<BodyPair>& pairs)
    :
        grid_(grid),
        box_(box),
        pairs_(pairs)
    {}

    /// Pairs of a member with the rest of its cell, the next one along x, and half of the rows around: so each is met once.
    void around(int member)
    {
        start(grid_.body[member], grid_.x[0][member], grid_.x[1][member], grid_.x[2][member], grid_.size[member]);
        const Cell cell = grid_.cellOf(x_[0], x_[1], x_[2]);
        const int own = grid_.row(cell[1], cell[2]) + cell[0];
        const bool isInside = isInner(cell, 0) && isInner(cell, 1) && isInner(cell, 2);
        if (isInside)
        {
            const int nx = grid_.count[0], layer = nx*grid_.count[1];
            const int* cells = &grid_.cellStart[own];
            const Image none{0, 0, 0};
            test(member + 1, cells[2], none);
            test(cells[nx - 1], cells[nx + 2], none);
            for (int dy = -nx; dy <= nx; dy += nx) test(cells[layer + dy - 1], cells[layer + dy + 2], none);
        }
        else
        {
            test(member + 1, grid_.cellStart[own + 1], {0, 0, 0});
            row(cell[0] + 1, cell[0] + 1, cell[1], cell[2]);
            row(cell[0] - 1, cell[0] + 1, cell[1] + 1, cell[2]);
            for (int dy = -1; dy <= 1; ++dy) row(cell[0] - 1, cell[0] + 1, cell[1] + dy, cell[2] + 1);
        }
        flush();
    }

    /// Pairs of a larger body of another grid with the members that its sphere may touch.
    void within(int body, double px, double py, double pz, double size)
    {
        start(body, px, py, pz, size);
        const double reach = (size_ + grid_.maxSize)*(1.0 + 1e-9);
        const std::array<int, 2> z = cellRange(2, reach);
        for (int k = z[0]; k <= z[1]; ++k)
        {
            const double left2 = std::max(0.0, reach*reach - square(distanceToCell(2, k)));
            const std::array<int, 2> y = cellRange(1, std::sqrt(left2));
            for (int j = y[0]; j <= y[1]; ++j)
            {
                const std::array<int, 2> x = cellRange(0, std::sqrt(std::max(0.0, left2 - square(distanceToCell(1, j)))));
                row(x[0], x[1], j, k);
            }
        }
        flush();
    }

private:
    void start(int body, double px, double py, double pz, double size)
    {
        body_ = body;
        x_[0] = px;
        x_[1] = py;
        x_[2] = pz;
        size_ = size;
    }

    bool isInner(const Cell& cell, int axis) const { return cell[axis] > 0 && cell[axis] < grid_.count[axis] - 1; }

    /// Cells along an axis within a distance; of a periodic one those of the nearest images too, as if the grid went on.
    std::array<int, 2> cellRange(int axis, double distance) const
    {
        const int count = grid_.count[axis], first = box_.isPeriodic(axis) ? -count : 0;
        const int last = box_.isPeriodic(axis) ? 2*count - 1 : count - 1;
        const auto index = [&](double x) { return std::floor((x - grid_.lower[axis])*grid_.inverseSize[axis]); };
        // Rounding may have put members of the cells at the ends a little beyond.
        const double low = std::max<double>(first, index(x_[axis] - distance - 1e-9*grid_.cellSize[axis]));
        const double high = std::min<double>(last, index(x_[axis] + distance + 1e-9*grid_.cellSize[axis]));
        return low > high ? std::array<int, 2>{0, -1} : std::array<int, 2>{static_cast<int>(low), static_cast<int>(high)};
    }

    double distanceToCell(int axis, int cell) const
    {
        const double low = grid_.lower[axis] + cell*grid_.cellSize[axis];
        return std::max({0.0, low - x_[axis], x_[axis] - low - grid_.cellSize[axis]});
    }

    /// Wraps an index into the grid. Returns whether there is such a cell.
    bool wrap(int axis, int& cell, signed char& image) const
    {
        image = 0;
        if (cell >= 0 && cell < grid_.count[axis]) return true;
        if (!box_.isPeriodic(axis)) return false;
        image = cell < 0 ? -1 : 1;
        cell -= image*grid_.count[axis];
        return true;
    }

    /// Tests cells first .. last of a row; what is beyond the grid lies in its images.
    void row(int first, int last, int y, int z)
    {
        Image image;
        if (!wrap(1, y, image[1]) || !wrap(2, z, image[2])) return;
        const int begin = grid_.row(y, z), count = grid_.count[0];
        const auto cells = [&](int from, int to, int shift)
        {
            if (from > to) return;
            image[0] = static_cast<signed char>(shift);
            test(grid_.cellStart[begin + from - shift*count], grid_.cellStart[begin + to - shift*count + 1], image);
        };
        cells(std::max(first, 0), std::min(last, count - 1), 0);
        if (!box_.isPeriodic(0)) return;
        cells(first, std::min(last, -1), -1);
        cells(std::max(first, count), last, 1);
    }

    void test(int first, int last, const Image& image)
    {
        for (; first < last; first += chunk)
        {
            const unsigned long long inRun = last - first >= chunk ? (1u << chunk) - 1u : (1u << (last - first)) - 1u;
            bits_ |= (nearBits(first, image) & inRun) << (chunk*chunks_);
            firsts_[chunks_] = first;
            images_[chunks_][0] = opposite(image);
            images_[chunks_][1] = image;
            if (++chunks_ == chunksAtOnce) flush();
        }
    }

    /// Bit k: whether member first + k is near.
    unsigned nearBits(int first, const Image& image) const
    {
        const Two px = two(x_[0] - image[0]*box_.length[0]), py = two(x_[1] - image[1]*box_.length[1]), pz = two(x_[2] - image[2]*box_.length[2]);
        const Two size = two(size_);
        const double *const x = &grid_.x[0][first], *const y = &grid_.x[1][first], *const z = &grid_.x[2][first], *const s = &grid_.size[first];
        unsigned bits = 0;
        for (int k = 0; k < chunk; k += 2)
        {
            const Two dx = px - load(x + k), dy = py - load(y + k), dz = pz - load(z + k), reach = size + load(s + k);
            bits |= signs(dx*dx + dy*dy + dz*dz - reach*reach) << k;
        }
        return bits;
    }

    void flush()
    {
        for (; bits_ != 0; bits_ &= bits_ - 1)
        {
            const int bit = __builtin_ctzll(bits_), c = bit/chunk;
            const int other = grid_.body[firsts_[c] + bit % chunk];
            if (other != body_) pairs_.push_back({std::min(body_, other), std::max(body_, other), images_[c][body_ < other]});
        }
        chunks_ = 0;
    }

    static Image opposite(const Image& image)
    {
        return {static_cast<signed char>(-image[0]), static_cast<signed char>(-image[1]), static_cast<signed char>(-image[2])};
    }

    const CellGrid& grid_;
    const PeriodicBox& box_;
    std::vector<BodyPair>& pairs_;
    int body_ = 0;
    double x_[3] = {0.0, 0.0, 0.0};
    double size_ = 0.0;
    unsigned long long bits_ = 0;
    int chunks_ = 0;
    int firsts_[chunksAtOnce] = {};
    Image images_[chunksAtOnce][2] = {};   // as seen from the member, and from the body
};

void checkPeriods(const PeriodicBox& box, double maxRadius)
{
    for (int k = 0; k < 3; ++k)
    {
        if (box.isPeriodic(k) && box.length[k] < 2.0*maxRadius*(1.0 - 1e-9))
        {
            throw invalidValue("period along axis " + std::to_string(k), box.length[k], "at least the largest grain's diameter");
        }
    }
}

} // namespace

/// Empty octaves are left out.
void PairSearch::groupByOctave(const std::vector<double>& size)
{
    const auto extremes = std::minmax_element(size.begin(), size.end());
    const double smallest = *extremes.first;
    grids_.resize(1 + std::ilogb(*extremes.second/smallest));
    for (CellGrid& grid : grids_) grid.bodies.clear();
    if (grids_.size() == 1)
    {
        grids_[0].bodies.resize(size.size());
        std::iota(grids_[0].bodies.begin(), grids_[0].bodies.end(), 0);
        return;
    }
    for (std::size_t i = 0; i < size.size(); ++i) grids_[std::ilogb(size[i]/smallest)].bodies.push_back(static_cast<int>(i));
    grids_.erase(std::remove_if(grids_.begin(), grids_.end(), [](const CellGrid& grid) { return grid.bodies.empty(); }), grids_.end());
}

void PairSearch::fill(const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box)
{
    grids_.resize(position.empty() ? 0 : grids_.size());
    if (!position.empty()) groupByOctave(size);
    for (CellGrid& grid : grids_) grid.fill(position, size, box);
}

const std::vector<BodyPair>& PairSearch::around(const Vec3& x, double size, const PeriodicBox& box)
{
    found_.clear();
    for (const CellGrid& grid : grids_) Look(grid, box, found_).within(-1, x[0], x[1], x[2], size);
    return found_;
}

/// Looks up one body after the other, and asks after each whether that is enough.
template<class IsEnough>
void PairSearch::lookUp(const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, const IsEnough& isEnough)
{
    found_.clear();
    fill(position, size, box);
    for (const CellGrid& grid : grids_)
    {
        Look look(grid, box, found_);
        for (int place : grid.placeOf)
        {
            look.around(place);
            if (isEnough()) return;
        }
    }
    for (std::size_t level = 1; level < grids_.size(); ++level)
    {
        const CellGrid& coarse = grids_[level];
        for (std::size_t finer = 0; finer < level; ++finer)
        {
            Look look(grids_[finer], box, found_);
            for (int m : coarse.placeOf)
            {
                look.within(coarse.body[m], coarse.x[0][m], coarse.x[1][m], coarse.x[2][m], coarse.size[m]);
                if (isEnough()) return;
            }
        }
    }
}

const std::vector<BodyPair>& PairSearch::find
(
    const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, double maxRadius, std::size_t mostPairs
)
{
    checkPeriods(box, maxRadius);
    sorted_.clear();
    lookUp(position, size, box, [&] { return found_.size() > mostPairs; });
    if (found_.size() > mostPairs)
    {
        throw invalidValue
        (
            "number of pairs of grains that may meet before they are listed again", "more than " + std::to_string(mostPairs),
            "at most 1000 a grain (or a million): grains fly too far in a step; use a smaller time step"
        );
    }

    // By first body, keeping the order of discovery within one.
    next_.assign(position.size() + 1, 0);
    for (const BodyPair& pair : found_) ++next_[pair.a + 1];
    std::partial_sum(next_.begin(), next_.end(), next_.begin());
    sorted_.resize(found_.size());
    for (const BodyPair& pair : found_) sorted_[next_[pair.a]++] = pair;
    return sorted_;
}

void PairSearch::findInPieces
(
    const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, double maxRadius, const TakePairs& take
)
{
    checkPeriods(box, maxRadius);
    bool isEnough = false;
    const auto handOver = [&]
    {
        isEnough = !take(found_);
        found_.clear();
    };
    lookUp(position, size, box, [&]
    {
        if (found_.size() >= pairsInPiece) handOver();
        return isEnough;
    });
    if (!isEnough) handOver();
}

std::vector<BodyPair> findPairs
(
    const std::vector<Vec3>& position, const std::vector<double>& size, const PeriodicBox& box, double maxRadius
)
{
    return PairSearch().find(position, size, box, maxRadius);
}

} // namespace nscd
