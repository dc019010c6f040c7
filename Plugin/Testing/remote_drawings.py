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
for name, source, style, properties in (
    ("transparent", wavelet, "Stipple", IN_PIXELS),
    ("lines", sampler, "Splatting Lines", {}),
    ("stipples", wavelet, "Stipple", IN_PIXELS),
    ("colored-stipples", wavelet, "Stipple", COLORS),
):
    display = Show(source, view)
    display.SetRepresentationType(style)
    for key, value in properties.items():
        setattr(display, key, value)
    ResetCamera(view)
    for place, megabytes in (("here", 1e9), ("server", 0)):
        view.RemoteRenderThreshold = megabytes
        SaveScreenshot(f"{OUTPUT}/{place}-{name}.png", view, TransparentBackground=name == "transparent")
    Hide(source, view)
