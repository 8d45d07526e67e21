// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Functions of nscdDEMFoam whose messages are counted apart, caught by their symbols. Of a library they are caught because this one is
// loaded first; in a program that holds the core itself (COUNT_LINKED), by the linker's --wrap. One of the core
// that is renamed does not link any more; of the others, the messages then count for what calls it.
#include "messageCount.hpp"

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/storedImpulses.hpp"
#include "nscd/solvers/contactSolver.hpp"

#include <dlfcn.h>

#include <utility>

#ifdef COUNT_LINKED
#define COUNTED(part, result, symbol, parameters, arguments)        \
    extern "C" result __real_##symbol parameters;              \
    extern "C" result __wrap_##symbol parameters                    \
    {                                                               \
        const messageCount::Part counted(part);                     \
        return __real_##symbol arguments;                           \
    }
#else
#define COUNTED(part, result, symbol, parameters, arguments)        \
    extern "C" result symbol parameters                             \
    {                                                               \
        using Next = result (*)parameters;                          \
        static const Next next = reinterpret_cast<Next>(dlsym(RTLD_NEXT, #symbol)); \
        const messageCount::Part counted(part);                     \
        return next arguments;                                      \
    }
#endif

using nscd::ContactList;
using nscd::ContactProblem;
using nscd::DefectSums;
using Numbers = std::vector<double>;
using WallReaches = std::vector<nscd::WallReach>;

// A member function is called as one that takes its object first.
COUNTED
(
    "sweep", DefectSums, _ZN4nscd11sweepActiveERNS_14ContactProblemERKNS_7SweepOnE, (ContactProblem& problem, const nscd::SweepOn& on), (problem, on)
)
COUNTED("check", DefectSums, _ZN4nscd8residualERNS_14ContactProblemE, (ContactProblem& problem), (problem))
COUNTED("check", bool, _ZN4nscd10wakeBlocksERNS_14ContactProblemE, (ContactProblem& problem), (problem))
COUNTED("mixing", void, _ZN4nscd15replaceImpulsesERNS_14ContactProblemERSt6vectorIdSaIdEE, (void* problem, void* target), (problem, target))
COUNTED
(
    "mixing sums", void, _ZN4nscd20AndersonAcceleration3mixERKSt6vectorINS_12ContactBlockESaIS2_EERS1_IdSaIdEE,
    (void* self, const void* blocks, void* r), (self, blocks, r)
)
COUNTED
(
    "list", ContactList,
    _ZN4nscd16buildContactListERKNS_5SceneERKNS_10WallSearchERKSt6vectorIdSaIdEES6_INS_9WallReachESaISB_EEdRNS_8ExchangeENS_11ContactListERKNS_14ExpectedMotionE,
    (
        const void* scene, const void* wallSearch, const Numbers& reach, WallReaches wallReach, double diameter, void* exchange, ContactList old,
        const void* expected
    ),
    (scene, wallSearch, reach, std::move(wallReach), diameter, exchange, std::move(old), expected)
)
COUNTED
(
    "impulses", void, _ZN4nscd14assignImpulsesERNS_11ContactListENS_13ImpulseRecordERNS_8ExchangeE,
    (void* list, nscd::ImpulseRecord record, void* exchange), (list, std::move(record), exchange)
)
COUNTED
(
    "overlaps", int, _ZN4nscd15correctOverlapsERNS_11ContactListERKNS_5SceneERKSt6vectorINS_7WallGapESaIS6_EEddd,
    (void* list, const void* scene, const void* missed, double deepest, double tolerance, double deadBand),
    (list, scene, missed, deepest, tolerance, deadBand)
)

#ifndef COUNT_LINKED

// The seven parts of a step.
#define COUNTED_STEP(length, name) \
    COUNTED(#name, void, _ZN4Foam12nscdCoupling10CoupledRun##length##name##Ev, (void* self), (self))

COUNTED_STEP(11, sampleFluid)
COUNTED_STEP(13, linearizeDrag)
COUNTED_STEP(10, solveFluid)
COUNTED_STEP(11, fluidForces)
COUNTED_STEP(13, advanceGrains)
COUNTED_STEP(13, depositGrains)
COUNTED_STEP(10, reportStep)

// What was sent before the first step does not count.
extern "C" bool _ZN4Foam12nscdCoupling10CoupledRun8nextStepEv(void* self)
{
    using Next = bool (*)(void*);
    static const Next next = reinterpret_cast<Next>(dlsym(RTLD_NEXT, "_ZN4Foam12nscdCoupling10CoupledRun8nextStepEv"));
    static bool isFirst = true;
    if (isFirst) messageCount::reset();
    isFirst = false;
    const messageCount::Part counted("nextStep");
    return next(self);
}

// Between the owners of grains and their homes.
COUNTED("homes", void*, _ZN4Foam12nscdCoupling10GrainHomes6updateERKN4nscd6GrainsE, (void* self, const void* grains), (self, grains))
COUNTED("homes connect", void, _ZN4nscd9GrainLink7connectERKSt6vectorIiSaIiEE, (void* self, const void* homes), (self, homes))
COUNTED("to homes", void, _ZNK4nscd9GrainLink7toHomesERKSt6vectorINS_11GrainColumnESaIS2_EE, (void* self, const void* columns), (self, columns))
COUNTED("to owners", void, _ZNK4nscd9GrainLink8toOwnersERKSt6vectorINS_11GrainColumnESaIS2_EE, (void* self, const void* columns), (self, columns))

// Between the ranks of cells and those that hold copies.
COUNTED("cells to halo", void, _ZNK4Foam12nscdCoupling12HaloExchange6toHaloERKNS0_10CellFieldsE, (void* self, const void* fields), (self, fields))
COUNTED("halo to cells", void, _ZNK4Foam12nscdCoupling12HaloExchange8toOwnersERKNS0_10CellFieldsE, (void* self, const void* fields), (self, fields))

COUNTED("balance", void, _ZN4Foam12nscdCoupling10CoupledRun12balanceRanksEv, (void* self), (self))
COUNTED("exits", void, _ZN4Foam12nscdCoupling10CoupledRun12removeExitedERKSt6vectorIiSaIiEE, (void* self, const void* cells), (self, cells))

#endif
