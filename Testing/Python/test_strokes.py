# SPDX-License-Identifier: BSD-3-Clause
"""Strokes among volumes, which VTK draws after all that is translucent."""

import numpy as np
import pytest

vtkink = pytest.importorskip("vtkink")
vtk = vtkink.vtk
SIZE = 200


def fog():
    """A slab around z = 0, white and too thick to see through."""
    volumes = pytest.importorskip(f"{vtkink.VTK_PACKAGE}.vtkRenderingVolumeOpenGL2")
    image = vtk.vtkImageData()
    image.SetDimensions(16, 16, 16)
    image.SetOrigin(-1, -1, -0.5)
    image.SetSpacing(2 / 15, 2 / 15, 1 / 15)
    image.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1)
    image.GetPointData().GetScalars().Fill(255)
    slab, mapper = vtk.vtkVolume(), volumes.vtkOpenGLGPUVolumeRayCastMapper()
    color, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    color.AddRGBPoint(0, 1, 1, 1)
    opacity.AddPoint(0, 1)
    mapper.SetInputData(image)
    slab.SetMapper(mapper)
    slab.GetProperty().SetColor(color)
    slab.GetProperty().SetScalarOpacity(opacity)
    return slab


@pytest.mark.parametrize("height, covered", [(0.9, False), (-0.9, True)])
def test_a_volume_covers_only_lines_behind_it(height, covered):
    line, mapper, actor = vtk.vtkLineSource(), vtkink.vtkInkStrokeMapper(), vtk.vtkActor()
    line.SetPoint1(-0.5, 0, height)
    line.SetPoint2(0.5, 0, height)
    mapper.SetInputConnection(line.GetOutputPort())
    mapper.SetLineWidth(40)
    actor.SetMapper(mapper)
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    renderer.AddVolume(fog())
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(1)
    camera.SetPosition(0, 0, 5)
    renderer.ResetCameraClippingRange()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    window.Render()
    pixels = vtk.vtkUnsignedCharArray()
    window.GetPixelData(0, 0, SIZE - 1, SIZE - 1, 0, pixels, 0)
    gray = np.frombuffer(memoryview(pixels), np.uint8).reshape(SIZE, SIZE, 3)[..., 0]
    assert (gray[SIZE // 2, SIZE // 2] > 200) == covered
    assert gray[SIZE // 4, SIZE // 2] > 200
    assert (gray < 128).sum() == (0 if covered else pytest.approx(100 * 8, abs=70))
