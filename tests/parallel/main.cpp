// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Runs all tests on every rank: mpirun -np 4 parallelTests. Rank 0 prints; other ranks tell only what failed.
#include <gtest/gtest.h>

#include <mpi.h>

#include <cfenv>
#include <cstdio>

namespace
{

class FailuresOfRank : public testing::EmptyTestEventListener
{
public:
    explicit FailuresOfRank(int rank) : rank_(rank) {}

private:
    void OnTestPartResult(const testing::TestPartResult& result) override
    {
        if (!result.failed()) return;
        std::fprintf(stderr, "rank %d, %s:%d: %s\n", rank_, result.file_name(), result.line_number(), result.message());
    }

    int rank_;
};

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
#ifdef __GLIBC__
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);  // as OpenFOAM does: ranks without grains must not reckon with infinity
#endif
    testing::InitGoogleTest(&argc, argv);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank > 0)
    {
        testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new FailuresOfRank(rank));
    }
    int failed = RUN_ALL_TESTS();
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    if (rank == 0) std::printf(failed ? "failed on some rank\n" : "passed on all ranks\n");
    MPI_Finalize();
    return failed;
}
