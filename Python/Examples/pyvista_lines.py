# SPDX-License-Identifier: BSD-3-Clause
"""Draws a volume in a PyVista plotter to pyvista_lines.png, beside a mesh of PyVista's:  pyvista_lines.py"""
import numpy
import pyvista  # takes VTK from the package cvista where that is installed, as vtkink does
from vtkink import vtk, vtkInkIsoSurfaceSampler, vtkInkSplattingLinesMapper

grid = pyvista.ImageData(dimensions=(120, 120, 120), origin=(-1, -1, -1), spacing=(2 / 119, 2 / 119, 2 / 119))
x, y, z = grid.points.T
turns = numpy.arctan2(y, x) - 3 * z  # a twisted vase
grid["density"] = 0.7 + 0.1 * numpy.cos(5 * turns) - 0.25 * numpy.cos(3 * z) - numpy.hypot(x, y) - z**8
sampler, mapper, actor = vtkInkIsoSurfaceSampler(), vtkInkSplattingLinesMapper(), vtk.vtkActor()
sampler.SetInputData(grid)
sampler.SetValue(0, 0)
mapper.SetInputConnection(sampler.GetOutputPort())
actor.SetMapper(mapper)

plotter = pyvista.Plotter(off_screen=True, window_size=(600, 600))
plotter.set_background("white")
plotter.add_actor(actor)
plotter.add_mesh(pyvista.Plane(center=(0, 0, -1), i_size=2, j_size=2), color="gray", style="wireframe")
plotter.screenshot("pyvista_lines.png")
points = pyvista.wrap(sampler.GetOutput())
print(f"{points.n_points} points with {', '.join(points.point_data.keys())}")
