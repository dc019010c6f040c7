# SPDX-License-Identifier: BSD-3-Clause
"""Draws a mesh to surface_samples.png from blue-noise samples:  surface_samples.py MESH.ply [SAMPLES]"""
import sys
from vtkink import vtk, vtkInkSplattingLinesMapper, vtkInkSurfaceSampler

reader, sampler = vtk.vtkPLYReader(), vtkInkSurfaceSampler()
reader.SetFileName(sys.argv[1])
sampler.SetInputConnection(reader.GetOutputPort())
sampler.SetNumberOfSamples(int(sys.argv[2]) if len(sys.argv) > 2 else 200000)
actor, mapper = vtk.vtkActor(), vtkInkSplattingLinesMapper()
mapper.SetInputConnection(sampler.GetOutputPort())
actor.SetMapper(mapper)
renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
renderer.AddActor(actor)
renderer.SetBackground(1, 1, 1)
renderer.ResetCamera()
window.AddRenderer(renderer)
window.SetSize(800, 800)
window.SetOffScreenRendering(True)
picture, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
picture.SetInput(window)
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName("surface_samples.png")
writer.Write()
