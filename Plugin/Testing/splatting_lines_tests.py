# SPDX-License-Identifier: BSD-3-Clause
"""What tests of the representation Splatting Lines share: a view, how data is shown, and what is drawn at least."""

from rendering import *


class SplattingLinesTests:
    def setUp(self):
        self.view = green_view()

    def tearDown(self):
        Delete(self.view)
        for source in GetSources().values():
            Delete(source)

    def show(self, source, **properties):
        display = Show(source, self.view)
        display.SetRepresentationType("Splatting Lines")
        display.LinesPaper = False  # TestPaper.py looks at it
        for name, value in properties.items():
            setattr(display, name, value)
        ResetCamera(self.view)
        return display

    def assert_drawn(self, pixels):
        drawn = ~is_background(pixels)
        self.assertGreater(drawn.mean(), 0.2)
        self.assertFalse(drawn[0, 0])
        self.assertGreater(ink(pixels), 0.001 * pixels.shape[0] * pixels.shape[1])
