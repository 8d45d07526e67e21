// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ghosts and their owners, joined by messages between neighbors.
#include "parallel/mpiExchange.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

namespace
{

/// ImpulseForOwner on its way.
struct ImpulseOnWay
{
    std::int64_t id;
    std::array<double, 3> impulse;
    int index;
    int padding = 0;
};

std::vector<RankCount> countsOf(const std::vector<Message>& messages)
{
    std::vector<RankCount> counts;
    for (const Message& message : messages) counts.push_back({message.rank, static_cast<int>(message.bytes.size()/sizeof(int))});
    return counts;
}

void checkSize(const char* name, std::size_t size, std::size_t needed)
{
    if (size != needed) throw invalidValue(std::string("length of ") + name, size, std::to_string(needed));
}

} // namespace

MpiExchange::MpiExchange(MPI_Comm parent)
:
    tree_(Communicator(parent))
{}

std::vector<GhostGrain> MpiExchange::findGhosts(const Grains& owned, const GrainPaths& paths, const PeriodicBox& box)
{
    return nscd::findGhosts(tree_, owned, paths, box, covered_);
}

std::vector<int> MpiExchange::connect(const std::vector<GhostGrain>& ghosts)
{
    std::vector<int> owner, index;
    for (const GhostGrain& ghost : ghosts)
    {
        owner.push_back(ghost.owner);
        index.push_back(ghost.index);
    }
    ghostsByOwner_.resize(ghosts.size());
    std::iota(ghostsByOwner_.begin(), ghostsByOwner_.end(), 0);
    const auto byOwner = [&](int a, int b) { return owner[a] < owner[b]; };
    std::stable_sort(ghostsByOwner_.begin(), ghostsByOwner_.end(), byOwner);

    const std::vector<Message> wanted = messagesByRank(index, owner);
    const std::vector<Message> asked = tree_.all().exchange(wanted);
    owners_ = countsOf(wanted);
    holders_ = countsOf(asked);
    const std::vector<int> shared = valuesOf<int>(asked);
    nShared_ = shared.size();
    return shared;
}

void MpiExchange::toGhosts(const std::vector<double>& shared, std::vector<double>& ghosts, int width) const
{
    checkSize("shared", shared.size(), nShared_*width);
    buffer_.resize(ghostsByOwner_.size()*width);
    ghosts.resize(buffer_.size());
    tree_.all().transfer(holders_, shared.data(), owners_, buffer_.data(), width);
    const double* from = buffer_.data();
    for (int ghost : ghostsByOwner_)
    {
        std::copy(from, from + width, ghosts.begin() + static_cast<std::ptrdiff_t>(ghost)*width);
        from += width;
    }
}

void MpiExchange::toOwners(const std::vector<double>& ghosts, std::vector<double>& shared, int width) const
{
    checkSize("ghosts", ghosts.size(), ghostsByOwner_.size()*width);
    buffer_.resize(ghosts.size());
    shared.resize(nShared_*width);
    double* to = buffer_.data();
    for (int ghost : ghostsByOwner_) to = std::copy_n(ghosts.begin() + static_cast<std::ptrdiff_t>(ghost)*width, width, to);
    tree_.all().transfer(owners_, buffer_.data(), holders_, shared.data(), width);
}

std::vector<ImpulseForOwner> MpiExchange::deliver(const std::vector<ImpulseForOwner>& entries) const
{
    std::vector<ImpulseOnWay> sent;
    std::vector<int> destination;
    for (const ImpulseForOwner& entry : entries)
    {
        const Vec3& r = entry.impulse;
        sent.push_back({entry.id, {r[0], r[1], r[2]}, entry.index});
        destination.push_back(entry.rank);
    }
    std::vector<ImpulseForOwner> received;
    for (const ImpulseOnWay& entry : valuesOf<ImpulseOnWay>(tree_.all().exchange(messagesByRank(sent, destination))))
    {
        received.push_back({rank(), entry.index, entry.id, Vec3(entry.impulse.data())});
    }
    return received;
}

} // namespace nscd
