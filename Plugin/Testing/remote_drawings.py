# SPDX-License-Identifier: BSD-3-Clause
"""Draws what a server holds, on the server and here, for TestParallel.py to compare:

pvpython remote_drawings.py PORT OUTPUT_FOLDER"""

import sys

from paraview.simple import Connect

PORT, OUTPUT = sys.argv[1:3]
Connect("localhost", int(PORT))

# It takes the names of what is connected.
from rendering import *  # noqa: E402

view = green_view(120)
view.UseFXAA = True
wavelet = Wavelet(WholeExtent=[-16, 14, -13, 15, -12, 14])
sampler = InkIsoSurfaceSampler(Input=wavelet, Isosurfaces=[150.0])
# Dots of some pixels in a small picture, too.
IN_PIXELS = {"SizeUnit": "Pixels"}
COLORS = {**IN_PIXELS, "StippleInkColor": [0.8, 0.1, 0.3], "StipplePaperColor": [0.9, 0.8, 0.3]}
heights = Elevation(Input=wavelet, LowPoint=[0, 0, -12], HighPoint=[0, 0, 14])


def color_again(display):
    """By an array, off while points are made without it, and by it again."""
    ColorBy(display, ("POINTS", "Elevation"))
    Render(view)
    ColorBy(display, None)
    display.LinesIsoValue = 150.0
    Render(view)
    ColorBy(display, ("POINTS", "Elevation"))


for name, source, style, properties in (
    ("transparent", wavelet, "Stipple", IN_PIXELS),
    ("lines", sampler, "Splatting Lines", {}),
    ("stipples", wavelet, "Stipple", IN_PIXELS),
    ("colored-stipples", wavelet, "Stipple", COLORS),
    ("colored-again-lines", heights, "Splatting Lines", {"LinesScalars": ["POINTS", "RTData"]}),
):
    display = Show(source, view)
    display.SetRepresentationType(style)
    for key, value in properties.items():
        setattr(display, key, value)
    if name == "colored-again-lines":
        color_again(display)
    ResetCamera(view)
    for place, megabytes in (("here", 1e9), ("server", 0)):
        view.RemoteRenderThreshold = megabytes
        SaveScreenshot(f"{OUTPUT}/{place}-{name}.png", view, TransparentBackground=name == "transparent")
    Hide(source, view)
