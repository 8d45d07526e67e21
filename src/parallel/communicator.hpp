// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A group of ranks: reductions, and messages between few of them. The one place that calls MPI.
#pragma once

#include "parallel/message.hpp"

#include <mpi.h>

#include <cstdint>
#include <memory>

namespace nscd
{

/// What this rank sent to others since it started, by a Communicator or one split from it.
struct Traffic
{
    std::int64_t messages = 0;
    std::int64_t bytes = 0;       ///< in these messages
    std::int64_t reductions = 0;  ///< calls of sum(), max() and sumAndMax(), each log2(size) messages deep
};

/// A number of entries for a rank, or from one.
struct RankCount
{
    int rank;
    int count;
};

/// What MPI must be told to reduce two sums and a maximum together; in communicator.cpp.
struct SumAndMax;

/// A group of ranks with messages of its own. All functions but rank(), size() and traffic() are collective over the ranks
/// that take part. MPI's errors end the run, as MPI does by default.
class Communicator
{
public:
    /// The ranks of `parent`. Neither starts nor ends MPI; where nobody started it, this is one rank alone.
    explicit Communicator(MPI_Comm parent = MPI_COMM_WORLD);
    ~Communicator();
    Communicator(Communicator&& other) noexcept;
    Communicator& operator=(Communicator&& other) noexcept;

    int rank() const { return rank_; }
    int size() const { return size_; }
    const Traffic& traffic() const { return *traffic_; }

    /// Replaces `count` values by their sums or maxima over all ranks; the same bits on every rank, as MPI promises.
    void sum(double* values, int count) const;
    void max(double* values, int count) const;
    /// Two sums and a maximum in one reduction.
    void sumAndMax(double (&sums)[2], double& max) const;

    /// The ranks that give the same color, in the same order as here. Counts its traffic here too.
    Communicator split(int color) const;

    /// Delivers messages of which their receivers know nothing beforehand, to this rank itself too.
    /// Equation: NBX (Hoefler, Siebert, Lumsdaine 2010): synchronous sends, receive until a barrier says that all have arrived
    /// Cost:     as many messages as given, one barrier: O(neighbors + log size)
    /// Ensures:  `rank` of what is returned is the sender's; ascending, a sender's messages in the order it gave them
    std::vector<Message> exchange(std::vector<Message> outgoing) const;

    /// Gives each rank named its message and takes one from each of the same ranks, which name this one.
    /// Ensures:  the messages of these ranks, in the order they were named
    std::vector<Message> swap(const std::vector<Message>& outgoing) const;

    /// Sends and receives `width` numbers for each entry, where both sides know how many entries there are.
    /// Shapes:   send [sum of to.count][width], receive [sum of from.count][width], one rank behind the other
    /// Cost:     one message per rank named
    void transfer
    (
        const std::vector<RankCount>& to, const double* send, const std::vector<RankCount>& from, double* receive, int width
    ) const;

private:
    Communicator(MPI_Comm own, const Communicator& parent);

    void reduce(void* values, int count, MPI_Datatype type, MPI_Op operation) const;
    std::vector<MPI_Request> startSends(const std::vector<Message>& outgoing, int tag) const;
    void receiveArrived(int tag, std::vector<Message>& incoming) const;
    void count(std::size_t bytes) const;

    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0;
    int size_ = 1;
    std::shared_ptr<Traffic> traffic_;
    std::shared_ptr<const SumAndMax> sumAndMax_;
    mutable int round_ = 0;  ///< of exchange(), modulo 2
};

} // namespace nscd
