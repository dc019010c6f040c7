# SPDX-License-Identifier: BSD-3-Clause
"""Draws silhouettes of a volume's iso-surfaces, found straight from its voxels, to volume_contours.png; the lines follow the
camera, and what is hidden is dashed:  volume_contours.py [FILE [ISO_VALUES...]]"""
import sys
from vtkink import read, vtk, vtkInkSilhouetteMapper

mapper, actor = vtkInkSilhouetteMapper(), vtk.vtkActor()
mapper.SetInputData(read(sys.argv[1] if len(sys.argv) > 1 else sys.path[0] + "/../../Data/engine.nii.gz"))
for i, value in enumerate(map(float, sys.argv[2:] or ["80", "180"])):
    mapper.SetValue(i, value)
mapper.SetLineWidth(3)
mapper.SetDepthWidth(0.7)
mapper.SetHiddenPartsToDashed()
actor.SetMapper(mapper)

renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
renderer.AddActor(actor)
renderer.SetBackground(1, 1, 1)
renderer.GetActiveCamera().SetPosition(1, -1, 1)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera()
window.AddRenderer(renderer)
window.SetSize(600, 600)
window.SetOffScreenRendering(True)
picture, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
picture.SetInput(window)
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName("volume_contours.png")
writer.Write()
lines = mapper.GetContours(renderer, actor).GetNumberOfLines()
print(f"{lines} lines; another camera, or another iso-value, finds others without preparing the volume again")
