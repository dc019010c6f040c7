# SPDX-License-Identifier: BSD-3-Clause
"""Draws silhouettes of a volume's iso-surfaces, found straight from its voxels, to volume_contours.png; the lines follow the
camera:  volume_contours.py [FILE [ISO_VALUES...]]"""
import sys
from vtkink import read, vtk, vtkInkContours, vtkInkStrokeMapper

image = read(sys.argv[1] if len(sys.argv) > 1 else sys.path[0] + "/../../Data/engine.nii.gz")
renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
camera = renderer.GetActiveCamera()
camera.SetPosition(1, -1, 1)
camera.SetViewUp(0, 0, 1)
renderer.ResetCamera(image.GetBounds())

contours, mapper, actor = vtkInkContours(), vtkInkStrokeMapper(), vtk.vtkActor()
contours.SetInputData(image)
contours.SetCamera(camera)
contours.ComputeNormalsOn()
for i, value in enumerate(map(float, sys.argv[2:] or ["80", "180"])):
    contours.SetValue(i, value)
mapper.SetInputConnection(contours.GetOutputPort())
mapper.SetDepthWidth(0.7)
actor.SetMapper(mapper)

renderer.AddActor(actor)
renderer.SetBackground(1, 1, 1)
window.AddRenderer(renderer)
window.SetSize(600, 600)
window.SetOffScreenRendering(True)
picture, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
picture.SetInput(window)
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName("volume_contours.png")
writer.Write()
print(f"{contours.GetOutput().GetNumberOfLines()} lines; another camera finds others without preparing the volume again")
