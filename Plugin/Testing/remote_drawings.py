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
for name, source, style in (("lines", sampler, "Splatting Lines"), ("stipples", wavelet, "Stipple")):
    Show(source, view).SetRepresentationType(style)
    ResetCamera(view)
    for place, megabytes in (("here", 1e9), ("server", 0)):
        view.RemoteRenderThreshold = megabytes
        SaveScreenshot(f"{OUTPUT}/{place}-{name}.png", view)
    Hide(source, view)
