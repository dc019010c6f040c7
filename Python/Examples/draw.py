# SPDX-License-Identifier: BSD-3-Clause
"""Draws a volume in each style to draw_*.png, and lists what a style can be told:  draw.py [VOLUME.nii.gz]"""
import sys
import vtkink

file = sys.argv[1] if len(sys.argv) > 1 else sys.path[0] + "/../../Data/engine.nii.gz"
for parameter in vtkink.styles()["stipple"].parameters.values():
    if parameter.essential:
        print(f"{parameter.keyword} ({parameter.default}): {parameter.text}")
vtkink.draw(file, "stipple", "draw_stipple.png", size=(600, 600), view="back", preset="bone", sharpness=0.7, iso_values=[80])
vtkink.draw(file, "splatting-lines", "draw_lines.png", size=(600, 600), view="back", tau=1.0, iso_values=[80], ink_color="navy")
