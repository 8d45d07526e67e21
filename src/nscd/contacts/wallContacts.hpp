// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which of a body's candidates with neighboring wall regions are contacts, and which are ghosts of a shared edge or vertex.
#pragma once

#include "nscd/contacts/contactList.hpp"

namespace nscd
{

/// Takes out, by a gap without limit, candidates of bodies near several regions whose nearest point is no contact of the whole
/// surface. A grain touches a surface where the distance to it has a local minimum; so
/// - a nearest point on an edge or vertex of one region is none if another region that holds this point comes nearer;
/// - of regions with the same nearest point one stays: a face before an edge, then the lowest number.
/// Flat floors of any triangulation act as one plane, ridges and peaks give one contact, valleys their two or more. It is
/// judged by the geometry alone, so vertices of many triangles, T-junctions and slivers need no care; points nearer
/// than half of the default dead band are one.
/// Cost: per body linear in the number of its candidates, and a cheap test for each pair of them.
void suppressGhosts(ContactList& list, const Scene& scene);

} // namespace nscd
