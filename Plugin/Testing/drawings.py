"""Draws paper.png and lines.png into a folder, for TestParallel.py to compare:  pvbatch drawings.py FOLDER"""

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
