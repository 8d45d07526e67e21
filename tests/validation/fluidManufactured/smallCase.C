// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The small fluid case of the tests, compiled here too: wmake keeps objects of a folder within it.

#include "../../foam/boxMesh.C"
#include "../../foam/fluidCase.C"
