// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which arrays of grains are written.
#include "vtkFiles.hpp"

#include "nscd/base/vtkPolyData.hpp"

namespace nscdGrains
{

void writeGrainsVtp(const std::string& path, double time, const nscd::Grains& grains, const std::vector<nscd::Vec3>& contactForce)
{
    std::vector<double> diameter(grains.size());
    for (std::size_t i = 0; i < grains.size(); ++i) diameter[i] = 2.0*grains.radius[i];
    const std::vector<int> clumpOf = nscd::clumpOfGrains(grains);

    nscd::VtkPolyData data = nscd::VtkPolyData::ofVertices(grains.position);
    data.open("PointData Scalars=\"d\" Vectors=\"U\"");
    data.add("d", diameter);
    data.add("U", grains.velocity);
    data.add("omega", grains.omega);
    data.add("fContact", contactForce);
    data.add("id", grains.id);
    data.add("material", grains.material);
    if (!clumpOf.empty())
    {
        data.add("clump", clumpOf);
        data.add("orientation", grains.orientation);
    }
    data.close("PointData");
    data.write(path, time);
}

} // namespace nscdGrains
