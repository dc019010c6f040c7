# SPDX-License-Identifier: BSD-3-Clause
"""Draws a volume to splatting_lines.png:  splatting_lines.py [VOLUME.nii.gz [ISO_VALUE]]"""
import sys
from vtkink import vtk, vtkInkIsoSurfaceSampler, vtkInkSplattingLinesMapper

engine = sys.path[0] + "/../../Data/engine.nii.gz"
reader, sampler = vtk.vtkNIFTIImageReader(), vtkInkIsoSurfaceSampler()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else engine)
sampler.SetInputConnection(reader.GetOutputPort())
sampler.SetValue(0, float(sys.argv[2]) if len(sys.argv) > 2 else 80)
actor, mapper = vtk.vtkActor(), vtkInkSplattingLinesMapper()
mapper.SetInputConnection(sampler.GetOutputPort())
actor.SetMapper(mapper)
renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
renderer.AddActor(actor)
renderer.SetBackground(1, 1, 1)
renderer.GetActiveCamera().SetPosition(-1, -2, 2)
renderer.ResetCamera()
window.AddRenderer(renderer)
window.SetSize(800, 800)
window.SetOffScreenRendering(True)
picture, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
picture.SetInput(window)
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName("splatting_lines.png")
writer.Write()
