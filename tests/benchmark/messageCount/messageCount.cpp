// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// MPI's sending functions once more: they count, and call MPI's own by their names of the profiling interface. MPI_Finalize writes the
// counts as CSV into the file that MESSAGE_COUNT_FILE names. Not counted: messages of a rank to itself, MPI's own inside a collective call.
#include "messageCount.hpp"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <vector>

namespace messageCount
{

namespace
{

struct Counts
{
    double calls = 0, messages = 0, bytes = 0;
    double reductions = 0, reducedBytes = 0, barriers = 0, otherCollectives = 0;
    double mostToOne = 0;             // messages to one rank in one call
    std::map<int, double> messagesTo; // since reset, by rank of the world
};

/// Communicators made by MPI_Comm_dup, and what is split from these, are nscdDEMFoam's; the others are OpenFOAM's.
enum Whose { ours, others };
constexpr const char* names[] = {"ours", "others"};

struct CountsOfBoth
{
    std::array<Counts, 2> of;
};

struct OpenPart
{
    std::string name;
    std::array<std::map<int, double>, 2> messagesTo;  // in this call
};

struct State
{
    std::map<std::string, CountsOfBoth> parts;
    std::vector<OpenPart> open{{"outside", {}}};
    std::map<MPI_Comm, Whose> whose;
    std::map<MPI_Comm, MPI_Group> groups;
};

// Made at first use, and never ended: MPI may be called from the start to the very end of a program.
State& state()
{
    static State& it = *new State;
    return it;
}

Whose whoseIs(MPI_Comm comm)
{
    const auto known = state().whose.find(comm);
    return known == state().whose.end() ? others : known->second;
}

int worldRank(MPI_Comm comm, int rank)
{
    if (comm == MPI_COMM_WORLD) return rank;
    for (MPI_Comm c : {MPI_COMM_WORLD, comm})
    {
        if (!state().groups.count(c)) PMPI_Comm_group(c, &state().groups[c]);
    }
    int inWorld = rank;
    PMPI_Group_translate_ranks(state().groups[comm], 1, &rank, state().groups[MPI_COMM_WORLD], &inWorld);
    return inWorld;
}

double sizeOf(int count, MPI_Datatype type)
{
    int size = 0;
    PMPI_Type_size(type, &size);
    return double(count)*size;
}

Counts& here(MPI_Comm comm) { return state().parts[state().open.back().name].of[whoseIs(comm)]; }

void countMessage(int count, MPI_Datatype type, int to, MPI_Comm comm)
{
    if (to == MPI_PROC_NULL) return;
    const int rank = worldRank(comm, to);
    int self = 0;
    PMPI_Comm_rank(MPI_COMM_WORLD, &self);
    if (rank == self) return;
    Counts& counts = here(comm);
    counts.messages += 1;
    counts.bytes += sizeOf(count, type);
    counts.messagesTo[rank] += 1;
    state().open.back().messagesTo[whoseIs(comm)][rank] += 1;
}

void countReduction(int count, MPI_Datatype type, MPI_Comm comm)
{
    here(comm).reductions += 1;
    here(comm).reducedBytes += sizeOf(count, type);
}

void countOther(MPI_Comm comm) { here(comm).otherCollectives += 1; }

void closeCall(const OpenPart& part)
{
    for (int whose : {ours, others})
    {
        Counts& counts = state().parts[part.name].of[whose];
        for (const auto& [rank, messages] : part.messagesTo[whose]) counts.mostToOne = std::max(counts.mostToOne, messages);
    }
}

constexpr int columns = 9;

std::array<double, columns> rowOf(const Counts& c)
{
    const double calls = std::max(1.0, c.calls);
    return
    {
        c.calls, c.messages/calls, c.bytes/calls, double(c.messagesTo.size()), c.mostToOne, c.reductions/calls, c.reducedBytes/calls,
        c.barriers/calls, c.otherCollectives/calls
    };
}

void writeRow(std::FILE* file, const std::string& part, Whose whose, int ranks)
{
    const auto known = state().parts.find(part);
    const std::array<double, columns> row = known == state().parts.end() ? std::array<double, columns>{} : rowOf(known->second.of[whose]);
    std::array<double, columns> sum{}, most{};
    PMPI_Reduce(row.data(), sum.data(), columns, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    PMPI_Reduce(row.data(), most.data(), columns, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
    if (!file || most[1] + most[5] + most[7] + most[8] == 0) return;
    std::fprintf
    (
        file, "%d,%s,%s,%.0f,%.3f,%.3f,%.1f,%.1f,%.1f,%.0f,%.0f,%.3f,%.1f,%.3f,%.3f\n", ranks, part.c_str(), names[whose], most[0],
        sum[1]/ranks, most[1], sum[2]/ranks, most[2], sum[3]/ranks, most[3], most[4], most[5], most[6], most[7], most[8]
    );
}

/// Of the parts that rank 0 knows. Collective.
void write(const char* path)
{
    int rank = 0, ranks = 1;
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    PMPI_Comm_size(MPI_COMM_WORLD, &ranks);
    std::FILE* file = rank == 0 ? std::fopen(path, "w") : nullptr;
    if (file)
    {
        std::fprintf(file, "ranks,part,whose,calls,messages,messagesMax,bytes,bytesMax,partners,partnersMax,mostToOne,reductions,"
                     "reducedBytes,barriers,otherCollectives\n");
    }
    std::string all;
    for (const auto& [name, counts] : state().parts) all += name + "\n";
    int length = static_cast<int>(all.size());
    PMPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    all.resize(length);
    PMPI_Bcast(all.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
    for (std::size_t at = 0, end; (end = all.find('\n', at)) != std::string::npos; at = end + 1)
    {
        for (Whose whose : {ours, others}) writeRow(file, all.substr(at, end - at), whose, ranks);
    }
    if (file) std::fclose(file);
}

} // namespace

Part::Part(const std::string& name)
{
    const bool isInner = state().open.size() > 1;
    state().open.push_back({isInner ? state().open[1].name + " " + name : name, {}});
    for (Counts& counts : state().parts[state().open.back().name].of) counts.calls += 1;
}

Part::~Part()
{
    closeCall(state().open.back());
    state().open.pop_back();
}

void reset() { state().parts.clear(); }

} // namespace messageCount

using namespace messageCount;

#define SENDS(function)                                                                                            \
    extern "C" int MPI_##function(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)    \
    {                                                                                                              \
        countMessage(count, type, to, comm);                                                                       \
        return PMPI_##function(data, count, type, to, tag, comm);                                                  \
    }

#define STARTS_SENDING(function)                                                                                   \
    extern "C" int MPI_##function                                                                                    \
    (                                                                                                              \
        const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request       \
    )                                                                                                              \
    {                                                                                                              \
        countMessage(count, type, to, comm);                                                                       \
        return PMPI_##function(data, count, type, to, tag, comm, request);                                         \
    }

SENDS(Send)
SENDS(Bsend)
SENDS(Ssend)
SENDS(Rsend)
STARTS_SENDING(Isend)
STARTS_SENDING(Ibsend)
STARTS_SENDING(Issend)
STARTS_SENDING(Irsend)

#define COLLECTIVE(count, function, parameters, arguments)                                                         \
    extern "C" int MPI_##function parameters                                                                        \
    {                                                                                                              \
        count;                                                                                                     \
        return PMPI_##function arguments;                                                                          \
    }

COLLECTIVE
(
    countReduction(count, type, comm), Allreduce,
    (const void* send, void* receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm), (send, receive, count, type, op, comm)
)
COLLECTIVE
(
    countReduction(count, type, comm), Iallreduce,
    (const void* send, void* receive, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm, MPI_Request* request),
    (send, receive, count, type, op, comm, request)
)
COLLECTIVE
(
    countOther(comm), Reduce,
    (const void* send, void* receive, int count, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm),
    (send, receive, count, type, op, root, comm)
)
COLLECTIVE(here(comm).barriers += 1, Barrier, (MPI_Comm comm), (comm))
COLLECTIVE(here(comm).barriers += 1, Ibarrier, (MPI_Comm comm, MPI_Request* request), (comm, request))
COLLECTIVE(countOther(comm), Bcast, (void* data, int count, MPI_Datatype type, int root, MPI_Comm comm), (data, count, type, root, comm))
COLLECTIVE
(
    countOther(comm), Gather,
    (const void* s, int n, MPI_Datatype type, void* r, int m, MPI_Datatype other, int root, MPI_Comm comm),
    (s, n, type, r, m, other, root, comm)
)
COLLECTIVE
(
    countOther(comm), Gatherv,
    (const void* s, int n, MPI_Datatype type, void* r, const int* m, const int* at, MPI_Datatype other, int root, MPI_Comm comm),
    (s, n, type, r, m, at, other, root, comm)
)
COLLECTIVE
(
    countOther(comm), Scatter,
    (const void* s, int n, MPI_Datatype type, void* r, int m, MPI_Datatype other, int root, MPI_Comm comm),
    (s, n, type, r, m, other, root, comm)
)
COLLECTIVE
(
    countOther(comm), Scatterv,
    (const void* s, const int* n, const int* at, MPI_Datatype type, void* r, int m, MPI_Datatype other, int root, MPI_Comm comm),
    (s, n, at, type, r, m, other, root, comm)
)
COLLECTIVE
(
    countOther(comm), Allgather,
    (const void* s, int n, MPI_Datatype type, void* r, int m, MPI_Datatype other, MPI_Comm comm), (s, n, type, r, m, other, comm)
)
COLLECTIVE
(
    countOther(comm), Allgatherv,
    (const void* s, int n, MPI_Datatype type, void* r, const int* m, const int* at, MPI_Datatype other, MPI_Comm comm),
    (s, n, type, r, m, at, other, comm)
)
COLLECTIVE
(
    countOther(comm), Alltoall,
    (const void* s, int n, MPI_Datatype type, void* r, int m, MPI_Datatype other, MPI_Comm comm), (s, n, type, r, m, other, comm)
)
COLLECTIVE
(
    countOther(comm), Alltoallv,
    (
        const void* s, const int* n, const int* from, MPI_Datatype type, void* r, const int* m, const int* at, MPI_Datatype other,
        MPI_Comm comm
    ),
    (s, n, from, type, r, m, at, other, comm)
)

extern "C" int MPI_Comm_dup(MPI_Comm comm, MPI_Comm* made)
{
    const int status = PMPI_Comm_dup(comm, made);
    state().whose[*made] = ours;
    return status;
}

extern "C" int MPI_Comm_split(MPI_Comm comm, int color, int key, MPI_Comm* made)
{
    const int status = PMPI_Comm_split(comm, color, key, made);
    state().whose[*made] = whoseIs(comm);
    return status;
}

// A new communicator may get the handle of one that is gone.
extern "C" int MPI_Comm_free(MPI_Comm* comm)
{
    state().whose.erase(*comm);
    if (const auto group = state().groups.find(*comm); group != state().groups.end())
    {
        PMPI_Group_free(&group->second);
        state().groups.erase(group);
    }
    return PMPI_Comm_free(comm);
}

extern "C" int MPI_Finalize()
{
    if (const char* path = std::getenv("MESSAGE_COUNT_FILE")) write(path);
    return PMPI_Finalize();
}
