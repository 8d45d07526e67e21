// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The regions that need no program around them.
#include "nscd/tools/entryRegion.hpp"

namespace nscd
{

EntryRegion::EntryRegion(const Region& region)
:
    bounds(region.bounds),
    draw([region](const RandomNumbers& random) { return EntryTry{randomPoint(region, random)}; })
{}

} // namespace nscd
