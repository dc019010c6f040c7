# SPDX-License-Identifier: BSD-3-Clause
"""What a style's actor shows, for tests."""

import numpy as np
import pytest

vtk = pytest.importorskip("vtkink").vtk


class StyleScene:
    """An actor of vtkink.draw on white paper, by the light of its style, in a square window."""

    def __init__(self, actor, size):
        self.actor, self.style, self.size = actor, actor.style, size
        self.renderer, self.window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
        self.renderer.SetBackground(1, 1, 1)
        self.renderer.AddActor(actor)
        if self.style.GetLight():
            self.renderer.AddLight(self.style.GetLight())
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)

    def draw(self, direction=(0, 0, 1), scale=1.0, origin=0.0):
        """Darkness, 0 to 1, from below up, of what is seen along a direction in a frame of two units."""
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(scale)
        camera.SetFocalPoint([origin] * 3)
        camera.SetPosition([origin + 5 * scale * step for step in direction])
        camera.SetViewUp(0, 1, 0)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        pixels = vtk.vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        return 1 - np.frombuffer(memoryview(pixels), np.uint8).reshape(self.size, self.size, 3)[..., 0] / 255
