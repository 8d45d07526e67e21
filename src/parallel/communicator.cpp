// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reductions and messages by MPI.
#include "parallel/communicator.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace nscd
{

namespace
{

// Tags 0 and 1 belong to exchange() in turn: a rank that leaves a round may send in the next one while another still listens
// in the former, but nobody is two rounds ahead, since a round ends when all have taken part.
constexpr int swapTag = 2;
constexpr int transferTag = 3;

int mpiCount(std::size_t count)
{
    if (count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    {
        throw std::length_error("a message of " + std::to_string(count) + " items is longer than MPI allows");
    }
    return static_cast<int>(count);
}

Message receive(MPI_Comm comm, const MPI_Status& arrived)
{
    int bytes = 0;
    MPI_Get_count(&arrived, MPI_BYTE, &bytes);
    Message message{arrived.MPI_SOURCE, std::vector<char>(bytes)};
    MPI_Recv(message.bytes.data(), bytes, MPI_BYTE, arrived.MPI_SOURCE, arrived.MPI_TAG, comm, MPI_STATUS_IGNORE);
    return message;
}

bool isMpiOver()
{
    int isOver = 0;
    MPI_Finalized(&isOver);
    return isOver != 0;
}

/// Of numbers in threes.
void addTwoAndTakeMax(void* from, void* to, int* count, MPI_Datatype*)
{
    const double* x = static_cast<const double*>(from);
    double* y = static_cast<double*>(to);
    for (int k = 0; k < *count; ++k, x += 3, y += 3)
    {
        y[0] += x[0];
        y[1] += x[1];
        y[2] = std::max(y[2], x[2]);
    }
}

} // namespace

struct SumAndMax
{
    SumAndMax()
    {
        MPI_Type_contiguous(3, MPI_DOUBLE, &type);
        MPI_Type_commit(&type);
        MPI_Op_create(addTwoAndTakeMax, /* commutes */ 1, &operation);
    }

    ~SumAndMax()
    {
        // Who started MPI may have ended it before us.
        if (isMpiOver()) return;
        MPI_Op_free(&operation);
        MPI_Type_free(&type);
    }

    SumAndMax(const SumAndMax&) = delete;
    SumAndMax& operator=(const SumAndMax&) = delete;

    MPI_Datatype type;
    MPI_Op operation;
};

Communicator::Communicator(MPI_Comm parent)
:
    traffic_(std::make_shared<Traffic>())
{
    int isStarted = 0;
    MPI_Initialized(&isStarted);
    if (!isStarted) return;
    sumAndMax_ = std::make_shared<const SumAndMax>();
    MPI_Comm_dup(parent, &comm_);
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
}

Communicator::Communicator(MPI_Comm own, const Communicator& parent)
:
    comm_(own),
    traffic_(parent.traffic_),
    sumAndMax_(parent.sumAndMax_)
{
    if (own == MPI_COMM_NULL) return;
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
}

Communicator::Communicator(Communicator&& other) noexcept
:
    comm_(std::exchange(other.comm_, MPI_COMM_NULL)),
    rank_(other.rank_),
    size_(other.size_),
    traffic_(other.traffic_),
    sumAndMax_(other.sumAndMax_),
    round_(other.round_)
{}

Communicator& Communicator::operator=(Communicator&& other) noexcept
{
    std::swap(comm_, other.comm_);
    std::swap(rank_, other.rank_);
    std::swap(size_, other.size_);
    std::swap(traffic_, other.traffic_);
    std::swap(sumAndMax_, other.sumAndMax_);
    std::swap(round_, other.round_);
    return *this;
}

Communicator::~Communicator()
{
    if (comm_ == MPI_COMM_NULL) return;
    if (!isMpiOver()) MPI_Comm_free(&comm_);
}

void Communicator::reduce(void* values, int count, MPI_Datatype type, MPI_Op operation) const
{
    if (size_ == 1) return;
    ++traffic_->reductions;
    MPI_Allreduce(MPI_IN_PLACE, values, count, type, operation, comm_);
}

void Communicator::sum(double* values, int count) const
{
    reduce(values, count, MPI_DOUBLE, MPI_SUM);
}

void Communicator::max(double* values, int count) const
{
    reduce(values, count, MPI_DOUBLE, MPI_MAX);
}

void Communicator::sumAndMax(double (&sums)[2], double& max) const
{
    if (size_ == 1) return;
    double values[3] = {sums[0], sums[1], max};
    reduce(values, 1, sumAndMax_->type, sumAndMax_->operation);
    sums[0] = values[0];
    sums[1] = values[1];
    max = values[2];
}

Communicator Communicator::split(int color) const
{
    MPI_Comm part = MPI_COMM_NULL;
    if (comm_ != MPI_COMM_NULL) MPI_Comm_split(comm_, color, rank_, &part);
    return Communicator(part, *this);
}

void Communicator::count(std::size_t bytes) const
{
    ++traffic_->messages;
    traffic_->bytes += static_cast<std::int64_t>(bytes);
}

std::vector<MPI_Request> Communicator::startSends(const std::vector<Message>& outgoing, int tag) const
{
    std::vector<MPI_Request> requests;
    for (const Message& message : outgoing)
    {
        if (message.rank == rank_) continue;
        const int bytes = mpiCount(message.bytes.size());
        MPI_Issend(message.bytes.data(), bytes, MPI_BYTE, message.rank, tag, comm_, &requests.emplace_back());
        count(message.bytes.size());
    }
    return requests;
}

void Communicator::receiveArrived(int tag, std::vector<Message>& incoming) const
{
    for (;;)
    {
        int hasArrived = 0;
        MPI_Status arrived;
        MPI_Iprobe(MPI_ANY_SOURCE, tag, comm_, &hasArrived, &arrived);
        if (!hasArrived) return;
        incoming.push_back(receive(comm_, arrived));
    }
}

std::vector<Message> Communicator::exchange(std::vector<Message> outgoing) const
{
    std::vector<Message> incoming;
    for (Message& message : outgoing)
    {
        if (message.rank == rank_) incoming.push_back({rank_, std::move(message.bytes)});
    }
    if (size_ == 1) return incoming;

    const int tag = std::exchange(round_, 1 - round_);
    std::vector<MPI_Request> sends = startSends(outgoing, tag);
    MPI_Request barrier = MPI_REQUEST_NULL;
    bool isInBarrier = false;
    for (int isDone = 0; !(isInBarrier && isDone);)
    {
        receiveArrived(tag, incoming);
        if (isInBarrier)
        {
            MPI_Test(&barrier, &isDone, MPI_STATUS_IGNORE);
            continue;
        }
        MPI_Testall(mpiCount(sends.size()), sends.data(), &isDone, MPI_STATUSES_IGNORE);
        if (!isDone) continue;
        MPI_Ibarrier(comm_, &barrier);
        isInBarrier = true;
        isDone = 0;
    }
    const auto bySender = [](const Message& a, const Message& b) { return a.rank < b.rank; };
    std::stable_sort(incoming.begin(), incoming.end(), bySender);
    return incoming;
}

std::vector<Message> Communicator::swap(const std::vector<Message>& outgoing) const
{
    std::vector<MPI_Request> sends = startSends(outgoing, swapTag);
    std::vector<Message> incoming;
    for (const Message& message : outgoing)
    {
        MPI_Status arrived;
        MPI_Probe(message.rank, swapTag, comm_, &arrived);
        incoming.push_back(receive(comm_, arrived));
    }
    MPI_Waitall(mpiCount(sends.size()), sends.data(), MPI_STATUSES_IGNORE);
    return incoming;
}

void Communicator::transfer
(
    const std::vector<RankCount>& to, const double* send, const std::vector<RankCount>& from, double* receive, int width
) const
{
    std::vector<MPI_Request> requests;
    requests.reserve(from.size() + to.size());
    for (const auto& [rank, entries] : from)
    {
        const std::size_t numbers = static_cast<std::size_t>(entries)*width;
        MPI_Irecv(receive, mpiCount(numbers), MPI_DOUBLE, rank, transferTag, comm_, &requests.emplace_back());
        receive += numbers;
    }
    for (const auto& [rank, entries] : to)
    {
        const std::size_t numbers = static_cast<std::size_t>(entries)*width;
        MPI_Isend(send, mpiCount(numbers), MPI_DOUBLE, rank, transferTag, comm_, &requests.emplace_back());
        send += numbers;
        count(numbers*sizeof(double));
    }
    MPI_Waitall(mpiCount(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

} // namespace nscd
