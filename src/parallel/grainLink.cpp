// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Packing values of grains that have their home elsewhere, and copying the others'.
#include "parallel/grainLink.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

void checkLengths(const std::vector<GrainColumn>& columns, std::size_t needed)
{
    for (const GrainColumn& column : columns)
    {
        if (column.grains != needed) throw invalidValue("length of a column", column.grains, std::to_string(needed));
    }
}

int widthOf(const std::vector<GrainColumn>& columns)
{
    int width = 0;
    for (const GrainColumn& column : columns) width += column.width;
    return width;
}

/// The numbers of some entries of all columns, an entry's side by side.
std::vector<double> packed(const std::vector<GrainColumn>& columns, const std::vector<std::size_t>& entries)
{
    std::vector<double> numbers(entries.size()*widthOf(columns));
    double* to = numbers.data();
    for (std::size_t entry : entries)
    {
        for (const GrainColumn& column : columns) to = std::copy_n(column.from + entry*column.width, column.width, to);
    }
    return numbers;
}

void unpack(const std::vector<double>& numbers, const std::vector<GrainColumn>& columns, const std::vector<std::size_t>& entries)
{
    const double* from = numbers.data();
    for (std::size_t entry : entries)
    {
        for (const GrainColumn& column : columns)
        {
            std::copy_n(from, column.width, column.to + entry*column.width);
            from += column.width;
        }
    }
}

} // namespace

void GrainLink::connect(const std::vector<int>& homes)
{
    grains_ = homes.size();
    leaving_.clear();
    staying_.clear();
    for (std::size_t i = 0; i < homes.size(); ++i)
    {
        if (homes[i] < -1 || homes[i] >= all_.size())
        {
            throw invalidValue("home of a grain", homes[i], "a rank below " + std::to_string(all_.size()) + ", or -1");
        }
        if (homes[i] >= 0) (homes[i] == all_.rank() ? staying_ : leaving_).push_back(i);
    }
    std::stable_sort(leaving_.begin(), leaving_.end(), [&](std::size_t a, std::size_t b) { return homes[a] < homes[b]; });

    homes_.clear();
    for (std::size_t i : leaving_)
    {
        if (homes_.empty() || homes_.back().rank != homes[i]) homes_.push_back({homes[i], 0});
        ++homes_.back().count;
    }
    std::vector<Message> counts;
    for (const RankCount& home : homes_) pack(&home.count, 1, counts.emplace_back(Message{home.rank, {}}).bytes);
    owners_.clear();
    firstStaying_ = 0;
    rows_ = staying_.size();
    for (const Message& message : all_.exchange(counts))
    {
        std::vector<int> count;
        unpack(message.bytes, count);
        owners_.push_back({message.rank, count.front()});
        rows_ += count.front();
        if (message.rank < all_.rank()) firstStaying_ += count.front();
    }
    arriving_.resize(rows_ - staying_.size());
    std::iota(arriving_.begin(), arriving_.end(), std::size_t(0));
    for (std::size_t k = firstStaying_; k < arriving_.size(); ++k) arriving_[k] += staying_.size();
}

void GrainLink::toHomes(const std::vector<GrainColumn>& columns) const
{
    checkLengths(columns, grains_);
    const int width = widthOf(columns);
    std::vector<double> received(arriving_.size()*width);
    all_.transfer(homes_, packed(columns, leaving_).data(), owners_, received.data(), width);
    unpack(received, columns, arriving_);
    for (const GrainColumn& column : columns)
    {
        double* to = column.to + firstStaying_*column.width;
        for (std::size_t i : staying_) to = std::copy_n(column.from + i*column.width, column.width, to);
    }
}

void GrainLink::toOwners(const std::vector<GrainColumn>& columns) const
{
    checkLengths(columns, rows_);
    const int width = widthOf(columns);
    std::vector<double> received(leaving_.size()*width);
    all_.transfer(owners_, packed(columns, arriving_).data(), homes_, received.data(), width);
    for (const GrainColumn& column : columns)
    {
        std::fill_n(column.to, grains_*column.width, 0.0);
        const double* from = column.from + firstStaying_*column.width;
        for (std::size_t i : staying_)
        {
            std::copy_n(from, column.width, column.to + i*column.width);
            from += column.width;
        }
    }
    unpack(received, columns, leaving_);
}

} // namespace nscd
