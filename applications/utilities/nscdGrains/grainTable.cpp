// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing tables of grains.
#include "grainTable.hpp"

#include "nscd/base/completeFile.hpp"
#include "nscd/base/numberText.hpp"

namespace nscdGrains
{

void writeGrainTable(const std::string& path, const SceneSettings& scene, const nscd::Grains& grains)
{
    const input::Place place = {scene.file, 0, "grains"};
    if (scene.hasClumps()) throw input::InputError({place, "has clumps, which a table of grains does not hold", "", "single grains"});
    nscd::CompleteFile file(path);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        for (const double x : grains.position[i]) file.stream() << nscd::exact(x) << ' ';
        file.stream() << nscd::exact(2.0*grains.radius[i]) << ' ' << scene.materials.table.names()[grains.material[i]] << '\n';
    }
    file.complete();
}

} // namespace nscdGrains
