# SPDX-License-Identifier: BSD-3-Clause
"""Draws a NumPy array as a volume to numpy_volume.png"""
import numpy
from vtkink import numpy_support, vtk, vtkInkIsoSurfaceSampler, vtkInkSplattingLinesMapper

z, y, x = numpy.mgrid[-1:1:80j, -1:1:100j, -1:1:120j]  # VTK's x runs fastest: it is the array's last axis
turns = numpy.arctan2(y, x) - 3 * z  # a twisted vase
values = 0.7 + 0.1 * numpy.cos(5 * turns) - 0.25 * numpy.cos(3 * z) - numpy.hypot(x, y) - z**8

image, sampler = vtk.vtkImageData(), vtkInkIsoSurfaceSampler()
image.SetDimensions(values.shape[::-1])
image.SetSpacing(2 / 119, 2 / 99, 2 / 79)
image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(values.ravel()))  # shares the array's memory
sampler.SetInputData(image)
sampler.SetValue(0, 0)
sampler.Update()
normals = numpy_support.vtk_to_numpy(sampler.GetOutput().GetPointData().GetArray("Normals"))
print(f"{len(normals)} points, their normals as an array of {normals.shape}")

actor, mapper = vtk.vtkActor(), vtkInkSplattingLinesMapper()
mapper.SetInputConnection(sampler.GetOutputPort())
actor.SetMapper(mapper)
renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
renderer.AddActor(actor)
renderer.SetBackground(1, 1, 1)
renderer.GetActiveCamera().SetPosition(0, -3, 1)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera()
window.AddRenderer(renderer)
window.SetSize(600, 600)
window.SetOffScreenRendering(True)
picture, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
picture.SetInput(window)
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName("numpy_volume.png")
writer.Write()
