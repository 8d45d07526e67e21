// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
#include "coupling/base/fieldTemplates.H"

#if OPENFOAM == 1912
namespace Foam
{

nscdFieldTemplates()

} // namespace Foam
#endif
