"""Draws pictures into a folder, for TestParallel.py to compare:  pvbatch drawings.py FOLDER"""

import sys

from rendering import *

wavelet = Wavelet()
wavelet.UpdatePipeline()
view = green_view()
display = Show(InkIsoSurfaceSampler(Input=wavelet, Isosurfaces=[130.0]), view)
display.SetRepresentationType("Splatting Lines")
display.Phi = 100
# A neighbour that each process has a part of, half in front of the drawing.
ball = Sphere(Radius=4, Center=[5, 0, 8], ThetaResolution=32, PhiResolution=32)
Show(ball, view)
ResetCamera(view)
SaveScreenshot(sys.argv[1] + "/paper.png", view)

Hide(ball, view)
display.PaperVisibility = False
SaveScreenshot(sys.argv[1] + "/lines.png", view)

# Each process makes the stipples of a part of the image, by the percentile and the ranges of the whole.
for source in GetSources().values():
    Hide(source, view)
display = Show(wavelet, view)
display.SetRepresentationType("Stipple")
display.GradientPercentile = 70
ResetCamera(view)
SaveScreenshot(sys.argv[1] + "/stipples.png", view)
display.StippleIsoValue = 150.0
display.IsoSurfaceHides = True
SaveScreenshot(sys.argv[1] + "/solid.png", view)
Hide(wavelet, view)

# A mesh of which each process has a part.
mesh = Show(ball, view)
mesh.SetRepresentationType("Stipple")
ResetCamera(view)
SaveScreenshot(sys.argv[1] + "/mesh.png", view)
