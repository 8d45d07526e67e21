// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The rows.
#include "coupling/step/forces/forceTable.H"

#include "coupling/step/forces/addedMass.H"
#include "coupling/step/forces/bassetForce.H"
#include "coupling/step/forces/drag.H"
#include "coupling/step/forces/fieldForce.H"
#include "coupling/step/forces/magnusLift.H"
#include "coupling/step/forces/pressureForce.H"
#include "coupling/step/forces/saffmanLift.H"
#include "coupling/step/forces/spinDrag.H"
#include "coupling/step/forces/viscousForce.H"
#include "coupling/step/forces/weight.H"

namespace Foam
{
namespace nscdCoupling
{

const std::vector<ForceRow>& forceTable()
{
    constexpr bool switched = true, always = false;
    static const std::vector<ForceRow> table =
    {
        // keyword            on if       and if the case has                             made by
        {"weight",            always,     needs::nothing,                                 forces::weight},
        {"field",             switched,   needs::nothing,                                 forces::fieldForce},
        {"pressureGradient",  switched,   needs::fluid,                                   forces::pressureForce},
        {"viscous",           switched,   needs::fluid,                                   forces::viscousForce},
        {"addedMass",         switched,   needs::fluid,                                   forces::addedMass},  // drag reads its mass
        {"basset",            switched,   needs::fluid | needs::spheres,                  forces::bassetForce},  // likewise
        {"drag",              switched,   needs::fluid,                                   forces::drag},
        {"spinDrag",          switched,   needs::fluid | needs::dragLaw | needs::turning, forces::spinDrag},
        {"saffmanLift",       switched,   needs::fluid | needs::spheres,                  forces::saffmanLift},
        {"magnusLift",        switched,   needs::fluid | needs::spheres,                  forces::magnusLift}
    };
    return table;
}

} // namespace nscdCoupling
} // namespace Foam
