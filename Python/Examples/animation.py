# SPDX-License-Identifier: BSD-3-Clause
"""Draws a gourd that is twisted and bent to animation_00.png, animation_01.png, ...:  animation.py [FRAMES]"""
import math
import sys
from vtkink import vtk, vtkInkSplattingLinesMapper, vtkInkSurfaceSampler

frames = int(sys.argv[1]) if len(sys.argv) > 1 else 60
source, mesh, rest = vtk.vtkSphereSource(), vtk.vtkPolyData(), vtk.vtkPoints()
source.SetRadius(1.0)
source.SetPhiResolution(120)
source.SetThetaResolution(120)
source.Update()
mesh.DeepCopy(source.GetOutput())
mesh.GetPointData().SetNormals(None)  # they are those of the ball
rest.DeepCopy(mesh.GetPoints())
sampler, mapper, actor = vtkInkSurfaceSampler(), vtkInkSplattingLinesMapper(), vtk.vtkActor()
sampler.SetInputData(mesh)
sampler.FollowDeformationOn()  # samples are made once and move with the mesh
mapper.SetInputConnection(sampler.GetOutputPort())
actor.SetMapper(mapper)
renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
renderer.AddActor(actor)
renderer.SetBackground(1, 1, 1)
renderer.GetActiveCamera().SetPosition(0, -1, 0.3)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera(-0.9, 0.9, -0.6, 0.6, -1.1, 1.1)
window.AddRenderer(renderer)
window.SetSize(400, 400)
window.SetOffScreenRendering(True)
for frame in range(frames):
    time = frame / max(frames - 1, 1)
    for i in range(rest.GetNumberOfPoints()):
        x, y, z = rest.GetPoint(i)
        out = 0.5 * math.hypot(x, y) * (1 + 0.15 * math.cos(7 * math.atan2(y, x)))
        around = math.atan2(y, x) + 1.2 * time * z
        mesh.GetPoints().SetPoint(i, out * math.cos(around) + time * (z * z - 0.5), out * math.sin(around), 1.2 * z)
    mesh.GetPoints().Modified()
    picture, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    picture.SetInput(window)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(f"animation_{frame:02d}.png")
    writer.Write()
