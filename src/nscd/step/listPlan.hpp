// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How far grains may travel, and for how long, before a contact list is stale.
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// What a list is made for.
struct ListPlan
{
    std::vector<double> speed;    ///< of each grain, what its reach allows for during the time of `expected` [m/s]
    ExpectedMotion expected;      ///< without velocities where no paths are expected
};

/// What a plan by paths allows for beside the impacts that the list so far foresees.
struct OffPaths
{
    std::vector<double> fall;   ///< of each grain, what forces change its velocity by in a step [m/s]; empty: nothing
    double margin = 1.0;    ///< what impacts may be exceeded by [-]
    bool areListsLong = false;    ///< many candidates a grain so far: fewer then, for fewer steps and for impacts by the time that is left after them
    bool areStraysFollowed = false;    ///< the few grains that go otherwise cost no list: what is allowed for may be less, and lasts for whole steps
    std::vector<char> isNearOthers = {};    ///< of each grain, whether grains of other ranks may be so near that it is not followed; empty: none is
};

/// For grains that go on as they do, and impacts that may throw them off their paths: from the candidates of the list so far.
/// `velocity`: of each grain; `mean`: of those of all ranks [m/s]; `diameter`: mean [m]. Collective.
ListPlan planByPaths(const ContactList& list, const std::vector<Vec3>& velocity, const Vec3& mean, double diameter, double deltaT, const OffPaths& off);

/// For grains that fly together, first of all: each moves with the mean velocity, give or take how much faster it is than that, or all are in the
/// mean (rms), since any may be hit. Pairs through a periodic side that the flow crosses several times a step are else listed for each of its images.
/// `margin`: what deviations from the mean may be exceeded by [-].
ListPlan planAroundMean(const std::vector<Vec3>& velocity, const Vec3& mean, double rms, double time, double margin);

/// For grains as fast as each is, or as `common` [m/s]: a slow grain may be hit, and be as fast as the others at the end of a step.
/// `margin`: what speeds may be exceeded by [-].
ListPlan planBySpeeds(const std::vector<Vec3>& velocity, double common, double time, double margin);

} // namespace nscd
