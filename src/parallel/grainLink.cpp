// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Packing values by home, and back.
#include "parallel/grainLink.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

void checkSize(const char* name, std::size_t size, std::size_t needed)
{
    if (size != needed) throw invalidValue(std::string("length of ") + name, size, std::to_string(needed));
}

} // namespace

void GrainLink::connect(const std::vector<int>& homes)
{
    grains_ = homes.size();
    byHome_.clear();
    for (std::size_t i = 0; i < homes.size(); ++i)
    {
        if (homes[i] < -1 || homes[i] >= all_.size())
        {
            throw invalidValue("home of a grain", homes[i], "a rank below " + std::to_string(all_.size()) + ", or -1");
        }
        if (homes[i] >= 0) byHome_.push_back(i);
    }
    std::stable_sort(byHome_.begin(), byHome_.end(), [&](std::size_t a, std::size_t b) { return homes[a] < homes[b]; });

    homes_.clear();
    for (std::size_t i : byHome_)
    {
        if (homes_.empty() || homes_.back().rank != homes[i]) homes_.push_back({homes[i], 0});
        ++homes_.back().count;
    }
    std::vector<Message> counts;
    for (const RankCount& home : homes_) pack(&home.count, 1, counts.emplace_back(Message{home.rank, {}}).bytes);
    owners_.clear();
    rows_ = 0;
    for (const Message& message : all_.exchange(counts))
    {
        std::vector<int> count;
        unpack(message.bytes, count);
        owners_.push_back({message.rank, count.front()});
        rows_ += count.front();
    }
}

std::vector<double> GrainLink::toHomes(const std::vector<double>& perGrain, int width) const
{
    checkSize("perGrain", perGrain.size(), grains_*width);
    std::vector<double> sent(byHome_.size()*width), rows(rows_*width);
    double* to = sent.data();
    for (std::size_t i : byHome_) to = std::copy_n(perGrain.begin() + static_cast<std::ptrdiff_t>(i*width), width, to);
    all_.transfer(homes_, sent.data(), owners_, rows.data(), width);
    return rows;
}

std::vector<double> GrainLink::toOwners(const std::vector<double>& perRow, int width) const
{
    checkSize("perRow", perRow.size(), rows_*width);
    std::vector<double> received(byHome_.size()*width), perGrain(grains_*width, 0.0);
    all_.transfer(owners_, perRow.data(), homes_, received.data(), width);
    const double* from = received.data();
    for (std::size_t i : byHome_)
    {
        std::copy(from, from + width, perGrain.begin() + static_cast<std::ptrdiff_t>(i*width));
        from += width;
    }
    return perGrain;
}

} // namespace nscd
