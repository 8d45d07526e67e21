# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""For pvpython: what ParaView's reader of decomposed cases finds at the last time: readDecomposed.py case.foam"""

import sys

from paraview import servermanager
from paraview.simple import OpenFOAMReader, UpdatePipeline


def blocks(data, name=""):
    """(name, data set) of all leaves."""
    if not data.IsA("vtkMultiBlockDataSet"):
        yield name, data
        return
    for i in range(data.GetNumberOfBlocks()):
        inner = data.GetBlock(i)
        label = data.GetMetaData(i).Get(data.NAME()) if data.HasMetaData(i) else ""
        if inner:
            yield from blocks(inner, name + "/" + (label or str(i)))


reader = OpenFOAMReader(FileName=sys.argv[1])
reader.CaseType = "Decomposed Case"
reader.UpdatePipelineInformation()
reader.MeshRegions = list(reader.MeshRegions.Available)
reader.LagrangianArrays = list(reader.LagrangianArrays.Available)
UpdatePipeline(time=reader.TimestepValues[-1], proxy=reader)
found = {"mesh": [0, set()], "grains": [0, set()], "contacts": [0, set()]}
for name, data in blocks(servermanager.Fetch(reader)):
    for key, (count, arrays) in found.items():
        isMesh = key == "mesh" and name.endswith("internalMesh")
        if isMesh or name.endswith("/" + key):
            values = data.GetCellData() if isMesh else data.GetPointData()
            found[key][0] += data.GetNumberOfCells() if isMesh else data.GetNumberOfPoints()
            arrays.update(values.GetArrayName(i) for i in range(values.GetNumberOfArrays()))
for key, (count, arrays) in found.items():
    print(key, count, *sorted(arrays))
