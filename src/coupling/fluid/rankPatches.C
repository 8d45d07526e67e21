// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Completing all fields of a mesh between ranks.

#include "coupling/fluid/rankPatches.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

// Old times are in the registry too, under names of their own, and are left to the fields they belong to.
template<class Type>
void fillAll(const fvMesh& mesh)
{
    using Field = GeometricField<Type, fvPatchField, volMesh>;
    // All ranks hold the same names; sorted, they talk about the same field.
    for (const word& name : mesh.sortedNames<Field>())
    {
        if (!name.endsWith("_0")) fillRankPatches(mesh.lookupObjectRef<Field>(name));
    }
}

} // End anonymous namespace


void fillAllRankPatches(const fvMesh& mesh)
{
    if (!Pstream::parRun()) return;
    fillAll<scalar>(mesh);
    fillAll<vector>(mesh);
    fillAll<symmTensor>(mesh);
}

} // End namespace nscdCoupling
} // End namespace Foam
