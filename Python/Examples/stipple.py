# SPDX-License-Identifier: BSD-3-Clause
"""Draws a volume to stipple.png:  stipple.py [VOLUME.nii.gz [PRESET]]"""
import sys
from vtkink import vtk, vtkInkStippleActor, vtkInkStippleControls, vtkInkStippleGenerator, vtkInkStippleMapper

bonsai = sys.path[0] + "/../../Data/bonsai.nii.gz"
reader, generator = vtk.vtkNIFTIImageReader(), vtkInkStippleGenerator()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else bonsai)
generator.SetInputConnection(reader.GetOutputPort())
actor, mapper, controls = vtkInkStippleActor(), vtkInkStippleMapper(), vtkInkStippleControls()
mapper.SetInputConnection(generator.GetOutputPort())
controls.SetPreset(sys.argv[2] if len(sys.argv) > 2 else "anatomy")
controls.SetOrientation(0.6)  # six sliders; after Apply, any of the mapper's k's
controls.Apply(mapper)
actor.SetMapper(mapper)
renderer, window, paper = vtk.vtkRenderer(), vtk.vtkRenderWindow(), [0, 0, 0]
renderer.AddActor(actor)
controls.GetPaperColor(paper)
renderer.SetBackground(paper)
renderer.GetActiveCamera().SetPosition(0, -1, 0)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera()
window.AddRenderer(renderer)
window.SetSize(800, 800)
window.SetOffScreenRendering(True)
picture, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
picture.SetInput(window)
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName("stipple.png")
writer.Write()
