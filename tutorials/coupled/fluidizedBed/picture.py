# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The bed as ParaView shows it, at the last written time: bed.png. Run by pvbatch in the case."""

import os

from paraview.simple import *

open("case.foam", "a").close()
case = OpenFOAMReader(FileName=os.path.abspath("case.foam"))
case.MeshRegions = ["lagrangian/grains"]
case.UpdatePipeline(time=case.TimestepValues[-1])

view = CreateView("RenderView")
view.ViewSize = [500, 900]
view.ViewTime = case.TimestepValues[-1]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.OrientationAxesVisibility = 0

grains = Show(case, view)
grains.SetRepresentationType("Point Gaussian")
grains.GaussianRadius = 1.25e-3
ColorBy(grains, ("POINTS", "U", "Magnitude"))
colors = GetColorTransferFunction("U")
colors.RescaleTransferFunction(0, 1)
bar = GetScalarBar(colors, view)
bar.Title, bar.ComponentTitle = "grain speed [m/s]", ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]
grains.SetScalarBarVisibility(view, True)

view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.75, 0, 0.17], [0, 0, 0.17], [0, 0, 1]
SaveScreenshot("bed.png", view)
